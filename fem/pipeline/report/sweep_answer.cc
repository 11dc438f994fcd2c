#include "fem/pipeline/report/facts.h"
#include "fem/pipeline/report/render/number_format.h"
#include "fem/pipeline/report/sweep_results.h"
#include "fem/pipeline/support/numbers.h"

#include <algorithm>
#include <cmath>

namespace stemware::pipeline
{

using Json = nlohmann::ordered_json;

namespace
{

/// "0.27 %", "2110 %".
std::string in_percent_of_sweep(double value)
{
  return format::number(value, "short") + " %";
}

/// "+0.15 rad/s".
std::string signed_spin(double omega)
{
  return format::number(omega, "+.3g");
}

/// " (Load/Moment ratio = 1.3)": where something happens.
std::string at_case(const SweepPlan &plan, std::size_t index)
{
  return " (" + values_of_case(plan, index) + ")";
}

/// Which entry the variance of @p about is due to, most of all, as "share" and "entry": from the linear fit
/// where that explains it, else from the shares where there are samples enough; null where neither tells.
void add_largest_share(const SweepPlan &plan, const QuantityFindings &about, Json &facts)
{
  constexpr double good_fit = 0.9;
  facts["share"] = nullptr;
  if (!about.sensitivity)
    return;
  std::vector<double> shares = about.sensitivity->first_order;
  if (about.sensitivity->r_squared >= good_fit)
  {
    shares.clear();
    for (const double coefficient : about.sensitivity->regression)
      shares.push_back(coefficient * coefficient);
  }
  if (shares.empty())
    return;
  const auto largest = std::max_element(shares.begin(), shares.end());
  facts["share"] = std::min(*largest, 1.);
  facts["entry"] = plan.entries[static_cast<std::size_t>(largest - shares.begin())].path;
}

/// Least and largest terminal spin, or their band.
void add_spread(const SweepPlan &plan, const QuantityFindings &spin, Json &facts)
{
  if (!spin.band)
  {
    facts["range"] = { { "n", spin.n_values },
                       { "least", spin.least },
                       { "least_case", values_of_case(plan, spin.least_case) },
                       { "most", spin.most },
                       { "most_case", values_of_case(plan, spin.most_case) } };
    return;
  }
  const SampleBand &band = *spin.band;
  // Where nothing varies, rounding would be shown as a spread.
  const double spread = std::max(band.deviation, 1e-9 * std::abs(band.mean));
  facts["band"] = { { "n", spin.n_values },
                    { "mean", format::to_spread(band.mean, spread) },
                    { "deviation", format::to_spread(band.deviation, spread) },
                    { "lower", format::to_spread(band.lower, spread) },
                    { "upper", format::to_spread(band.upper, spread) } };
  add_largest_share(plan, spin, facts["band"]);
}

/// "by between -4.47 rad/s (...) and +4.1 rad/s (...)": where the spin changes its sign.
std::string absolute_range(const SweepPlan &plan, const QuantityFindings *about)
{
  if (about == nullptr)
    return "";
  if (about->band)
    return "by " + signed_spin(about->band->mean) +
           " rad/s (mean; 95 % of the samples: " + signed_spin(about->band->lower) + " to " +
           signed_spin(about->band->upper) + " rad/s).";
  if (about->most - about->least < 1e-9 * std::abs(about->most))
    return "by " + signed_spin(about->most) + " rad/s";
  return "by between " + signed_spin(about->least) + " rad/s" + at_case(plan, about->least_case) + " and " +
         signed_spin(about->most) + " rad/s" + at_case(plan, about->most_case);
}

/// Clause on the harmonics beyond the first: "make it up to 2 % faster (...)"; empty where nobody knows.
std::string harmonics_clause(const SweepPlan &plan, const SweepFindings &findings)
{
  if (findings.spin_changes_sign())
  {
    const std::string range = absolute_range(plan, findings.about("absolute harmonic effect"));
    return range.empty() ? "" : "change it " + range;
  }
  const QuantityFindings *effect = findings.about("harmonic effect");
  if (effect == nullptr)
    return "";
  if (effect->band)
    return "change it by " + in_percent_of_sweep(effect->band->mean) +
           " (mean; 95 % of the samples: " + in_percent_of_sweep(effect->band->lower) + " to " +
           in_percent_of_sweep(effect->band->upper) + ")";
  if (std::max(std::abs(effect->least), std::abs(effect->most)) < 1e-7) // per cent
    return "do not change that";
  const std::string faster =
    effect->most > 0 ? in_percent_of_sweep(effect->most) + " faster" + at_case(plan, effect->most_case) : "";
  const std::string slower =
    effect->least < 0 ? in_percent_of_sweep(-effect->least) + " slower" + at_case(plan, effect->least_case)
                      : "";
  return "make it up to " + faster + (faster.empty() || slower.empty() ? "" : " and up to ") + slower;
}

/// Whether the moment is given in some of the cases, so that no balance asks for it.
bool has_given_moment(const SweepPlan &plan)
{
  bool is_given = plan.base.load.is_static() || plan.base.load.source == LoadSource::file;
  for (std::size_t i = 0; i < plan.entries.size(); ++i)
    if (plan.entries[i].path == "Load/Moment ratio")
      is_given = std::any_of(plan.cases.begin(), plan.cases.end(),
                             [=](const std::vector<std::string> &values)
                             { return parse_number(values[i]).value_or(-1) >= 0; });
  return is_given;
}

/// Clause on the effect of what the paper's moment balance leaves out, on the spin of a first-harmonic load:
/// "by 4 % to 5 %"; empty where no balance asks for the moment.
std::string closure_clause(const SweepPlan &plan, const SweepFindings &findings)
{
  if (has_given_moment(plan))
    return "";
  if (findings.spin_changes_sign())
    return absolute_range(plan, findings.about("moment balance"));
  const QuantityFindings *effect = findings.about("closure effect");
  if (effect == nullptr)
    return "";
  const bool is_constant = effect->most - effect->least < 1e-9 * std::abs(effect->most);
  return "by " + (is_constant ? "" : in_percent_of_sweep(effect->least) + " to ") +
         in_percent_of_sweep(effect->most);
}

Json falls_facts(const SweepPlan &plan, const SweepFindings &findings)
{
  const QuantityFindings *fall = findings.about(spin_of_fall);
  if (fall == nullptr)
    return nullptr;
  return { { "n", fall->n_values },
           { "one", fall->n_values == 1 },
           { "case", values_of_case(plan, fall->first_case) } };
}

} // namespace

Json sweep_facts(const SweepPlan &plan, const SweepFindings &findings)
{
  const QuantityFindings *held = findings.about("held by the grip"), *spin = findings.about("terminal spin");
  const bool is_held = held != nullptr && held->most >= 1;
  Json facts = study_facts(plan.base);
  facts.update({ { "n_cases", findings.n_cases },
                 { "n_failed", findings.n_failed > 0 ? Json(findings.n_failed) : Json(nullptr) },
                 { "falls", falls_facts(plan, findings) },
                 { "range", nullptr },
                 { "band", nullptr },
                 { "held_in_some", is_held && held->least < 1 ? values_of_case(plan, held->most_case) : "" },
                 { "held_in_all", is_held && held->least >= 1 },
                 { "harmonics", harmonics_clause(plan, findings) },
                 { "closure", closure_clause(plan, findings) } });
  if (spin != nullptr)
    add_spread(plan, *spin, facts);
  return facts;
}

} // namespace stemware::pipeline
