#include "fem/pipeline/report/answer.h"
#include "fem/pipeline/report/render/number_format.h"
#include "fem/pipeline/support/numbers.h"

#include <algorithm>
#include <cmath>

namespace stemware::pipeline
{

namespace
{

/// "0.27 %", "2110 %".
std::string in_percent_of_sweep(double value)
{
  return std::abs(value) < 1000 ? format::significant<3>(value) + " %" : format::fixed<0>(value) + " %";
}

/// " (Load/Moment ratio = 1.3)": where something happens.
std::string at_case(const SweepPlan &plan, std::size_t index)
{
  return " (" + values_of_case(plan, index) + ")";
}

/// Which entry the variance is due to, most of all: from the linear fit where that explains it, else from the
/// shares where there are samples enough; empty where neither tells.
std::string largest_share_sentence(const SweepPlan &plan, const QuantityFindings &about)
{
  constexpr double good_fit = 0.9;
  if (!about.sensitivity)
    return "";
  std::vector<double> shares = about.sensitivity->first_order;
  if (about.sensitivity->r_squared >= good_fit)
  {
    shares.clear();
    for (const double coefficient : about.sensitivity->regression)
      shares.push_back(coefficient * coefficient);
  }
  if (shares.empty())
    return "";
  const auto largest = std::max_element(shares.begin(), shares.end());
  return fmt::format(FMT_STRING(" {:.0f} % of the variance is due to {} alone."),
                     100 * std::min(*largest, 1.),
                     plan.entries[static_cast<std::size_t>(largest - shares.begin())].path);
}

std::string spread_sentence(const SweepPlan &plan, const SweepFindings &findings)
{
  const QuantityFindings *spin = findings.about("terminal spin");
  if (spin == nullptr)
    return "";
  const std::string beginning = one_way_beginning(plan.base) + (is_one_way(plan.base) ? "in" : "In");
  if (!spin->band)
    return fmt::format(
      FMT_STRING("{} {} cases the glass spins up to between {:.6g} rad/s{} and {:.6g} rad/s{}."), beginning,
      spin->n_values, format::Number{ spin->least }, at_case(plan, spin->least_case),
      format::Number{ spin->most }, at_case(plan, spin->most_case));
  const SampleBand &band = *spin->band;
  // Where nothing varies, rounding would be shown as a spread.
  const double spread = std::max(band.deviation, 1e-9 * std::abs(band.mean));
  std::string sentence = fmt::format(
    FMT_STRING("{} {} samples the glass spins up to {} ± {} rad/s (mean and standard deviation; 95 % of them "
               "lie between {} and {} rad/s)."),
    beginning, spin->n_values, format::to_spread(band.mean, spread),
    format::to_spread(band.deviation, spread), format::to_spread(band.lower, spread),
    format::to_spread(band.upper, spread));
  return sentence + largest_share_sentence(plan, *spin);
}

/// "@p beginning by between -4.47 rad/s (...) and +4.1 rad/s (...).": where the spin changes its sign.
std::string absolute_range_sentence(const SweepPlan &plan, const std::string &beginning,
                                    const QuantityFindings *about)
{
  if (about == nullptr)
    return "";
  if (about->band)
    return beginning + " by " + format::signed_significant<3>(about->band->mean) +
           " rad/s (mean; 95 % of the samples: " + format::signed_significant<3>(about->band->lower) +
           " to " + format::signed_significant<3>(about->band->upper) + " rad/s).";
  if (about->most - about->least < 1e-9 * std::abs(about->most))
    return beginning + " by " + format::signed_significant<3>(about->most) + " rad/s.";
  return beginning + " by between " + format::signed_significant<3>(about->least) + " rad/s" +
         at_case(plan, about->least_case) + " and " + format::signed_significant<3>(about->most) + " rad/s" +
         at_case(plan, about->most_case) + ".";
}

std::string sweep_harmonic_sentence(const SweepPlan &plan, const SweepFindings &findings)
{
  const std::string subject = harmonics_subject(plan.base);
  if (findings.spin_changes_sign())
    return absolute_range_sentence(plan, subject + "change it", findings.about("absolute harmonic effect"));
  const QuantityFindings *effect = findings.about("harmonic effect");
  if (effect == nullptr)
    return "";
  if (effect->band)
    return subject + "change it by " + in_percent_of_sweep(effect->band->mean) +
           " (mean; 95 % of the samples: " + in_percent_of_sweep(effect->band->lower) + " to " +
           in_percent_of_sweep(effect->band->upper) + ").";
  if (std::max(std::abs(effect->least), std::abs(effect->most)) < 1e-7) // per cent
    return subject + "do not change that.";
  const std::string faster =
    effect->most > 0 ? in_percent_of_sweep(effect->most) + " faster" + at_case(plan, effect->most_case) : "";
  const std::string slower =
    effect->least < 0 ? in_percent_of_sweep(-effect->least) + " slower" + at_case(plan, effect->least_case)
                      : "";
  return subject + "make it up to " + faster + (faster.empty() || slower.empty() ? "" : " and up to ") +
         slower + ".";
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

std::string sweep_closure_sentence(const SweepPlan &plan, const SweepFindings &findings)
{
  if (has_given_moment(plan))
    return "";
  if (findings.spin_changes_sign())
    return absolute_range_sentence(
      plan, "For scale: what the paper's moment balance leaves out changes the spin of a first-harmonic load",
      findings.about("moment balance"));
  const QuantityFindings *effect = findings.about("closure effect");
  if (effect == nullptr)
    return "";
  const bool is_constant = effect->most - effect->least < 1e-9 * std::abs(effect->most);
  return "For scale: what the paper's moment balance leaves out changes the spin of a first-harmonic load "
         "by " +
         (is_constant ? "" : in_percent_of_sweep(effect->least) + " to ") +
         in_percent_of_sweep(effect->most) + ".";
}

std::string held_cases_sentence(const SweepPlan &plan, const SweepFindings &findings)
{
  const QuantityFindings *held = findings.about("held by the grip");
  if (held == nullptr || held->most < 1)
    return "";
  return held->least < 1
           ? "In some of them the fingers hold the glass at rest" + at_case(plan, held->most_case) +
               "; see the column \"held by the grip\" of sweep.csv."
           : "In all of them the fingers hold the glass at rest.";
}

std::string falls_sentence(const SweepPlan &plan, const SweepFindings &findings)
{
  const QuantityFindings *fall = findings.about(spin_of_fall);
  if (fall == nullptr)
    return "";
  const bool is_one = fall->n_values == 1;
  return fmt::format(
    FMT_STRING(
      "In {} of {} cases the glass stands at rest and falls over on the way{}{}; {} no terminal spin."),
    fall->n_values, findings.n_cases, is_one ? "" : ", first", at_case(plan, fall->first_case),
    is_one ? "it has" : "they have");
}

std::string failed_cases_sentence(const SweepFindings &findings)
{
  if (findings.n_failed == 0)
    return "";
  return fmt::format(FMT_STRING("{} of {} cases failed; the column message of sweep.csv says why."),
                     findings.n_failed, findings.n_cases);
}

} // namespace

std::string sweep_answer(const SweepPlan &plan, const SweepFindings &findings)
{
  return joined({ falls_sentence(plan, findings), spread_sentence(plan, findings),
                  held_cases_sentence(plan, findings), sweep_harmonic_sentence(plan, findings),
                  sweep_closure_sentence(plan, findings), failed_cases_sentence(findings) });
}

} // namespace stemware::pipeline
