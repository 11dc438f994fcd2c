#include "fem/pipeline/document/number_format.h"
#include "fem/pipeline/report/common_sections.h"
#include "fem/pipeline/report/sweep_results.h"
#include "fem/pipeline/support/numbers.h"

#include <algorithm>
#include <cmath>

namespace stemware::pipeline
{

using Json = nlohmann::ordered_json;

namespace
{

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

/// Least and largest value of a quantity with their cases, and in random samples its band; null where no case
/// has it. One of samples, constant and between is there.
Json range_facts(const SweepPlan &plan, const QuantityFindings *about)
{
  if (about == nullptr)
    return nullptr;
  const bool is_constant = about->most - about->least < 1e-9 * std::abs(about->most);
  const auto &band = about->band;
  Json facts = { { "samples", nullptr },
                 { "constant", !band && is_constant },
                 { "between", !band && !is_constant },
                 { "changes", is_constant ? Json(nullptr) : Json(about->least) },
                 { "least", about->least },
                 { "least_case", values_of_case(plan, about->least_case) },
                 { "most", about->most },
                 { "most_case", values_of_case(plan, about->most_case) },
                 { "faster", about->most > 0 },
                 { "slower", about->least < 0 },
                 { "nothing", std::max(std::abs(about->least), std::abs(about->most)) < 1e-7 } }; // per cent
  if (band)
    facts["samples"] = { { "mean", band->mean }, { "lower", band->lower }, { "upper", band->upper } };
  return facts;
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
  const bool absolute = findings.spin_changes_sign(); // per cent then say nothing
  const bool balances = !has_given_moment(plan);
  const auto range_of = [&](bool is_told, const char *quantity)
  { return range_facts(plan, is_told ? findings.about(quantity) : nullptr); };
  Json facts = study_facts(plan.base);
  facts.update({ { "n_cases", findings.n_cases },
                 { "n_failed", findings.n_failed > 0 ? Json(findings.n_failed) : Json(nullptr) },
                 { "falls", falls_facts(plan, findings) },
                 { "range", nullptr },
                 { "band", nullptr },
                 { "held_in_some", is_held && held->least < 1 ? values_of_case(plan, held->most_case) : "" },
                 { "held_in_all", is_held && held->least >= 1 },
                 { "harmonics_absolute", range_of(absolute, "absolute harmonic effect") },
                 { "harmonics", range_of(!absolute, "harmonic effect") },
                 { "closure_absolute", range_of(absolute && balances, "moment balance") },
                 { "closure", range_of(!absolute && balances, "closure effect") } });
  if (spin != nullptr)
    add_spread(plan, *spin, facts);
  return facts;
}

} // namespace stemware::pipeline
