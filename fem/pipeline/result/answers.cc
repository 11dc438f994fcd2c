#include "fem/pipeline/result/answers.h"

#include "fem/pipeline/analysis/ring_quantities.h"
#include "fem/pipeline/analysis/study_rows.h"
#include "fem/pipeline/result/number_format.h"
#include "fem/pipeline/result/sentences.h"

#include <algorithm>

namespace stemware::pipeline
{

using format::number;

std::string truncation_answer(const Study &study, const std::vector<ring::Answer> &rows,
                              const ring::TorqueEffects &effects, const HarmonicEffect &effect,
                              unsigned int n_enough)
{
  const ring::Answer &all = rows.back();
  const std::optional<double> first = rows.front().omega_terminal();
  if (all.fall)
  {
    std::string text = fall_sentences(study, all);
    if (rows.size() > 1)
      append(text, first
                     ? "The first harmonic only has a terminal spin of " + format::spin(*first) + " rad/s."
                     : "The first harmonic only has no terminal spin either.");
    return text;
  }
  const double omega = all.omega_terminal().value();
  if (!is_spin(study, omega))
  {
    const std::string held = grip_holds_note(study, all);
    return held.empty() ? "The glass does not spin up, with any number of harmonics." : held;
  }
  if (all.harmonics == 1)
    return "The " + one_way_word(study) + "load has one harmonic; the terminal spin is " +
           format::spin(omega) + " rad/s.";
  std::string text =
    under_its_load(study, "The glass spins up to " + format::spin(omega) + " rad/s with all " +
                            std::to_string(all.harmonics) + " harmonics of its load, " +
                            (first ? "to " + format::spin(*first) + " rad/s with the first harmonic only."
                                   : "and has no terminal spin with the first harmonic only."));
  append(text, torque_effect_sentence(effects));
  append(text, harmonic_effect_sentence(study, effect));
  append(text, "From " + std::to_string(n_enough) + " harmonics on, the spin is accurate to 1e-4.");
  return text;
}

std::string convergence_answer(const BandedQuantity &spin, const std::string &first_axis,
                               const std::optional<double> &order)
{
  return "Terminal spin " + format::with_band(spin.quantity.value, spin.band) +
         " rad/s (discretisation only)" +
         (order ? "; it converges with order " + number(*order, ".2f") + " in the " + first_axis : "") +
         ", Richardson value " + format::rounded_to_error(spin.richardson, spin.band) +
         " rad/s. The band of stemware run differs: its levels are coarser, and it has parts for rings, load "
         "harmonics and the spring of a hard interface.";
}

std::optional<CaseRange> range_of(const CaseList &list, const FinishedCases &finished, const std::string &key)
{
  const std::pair<const std::size_t, CaseResult> *min = nullptr, *max = nullptr;
  CaseRange range;
  for (const auto &one : finished)
    if (const auto value = one.second.value(key); value && !one.second.is_formal)
    {
      ++range.n;
      min = min == nullptr || *value < *min->second.value(key) ? &one : min;
      max = max == nullptr || *value > *max->second.value(key) ? &one : max;
    }
  if (range.n == 0)
    return std::nullopt;
  range.min = *min->second.value(key);
  range.max = *max->second.value(key);
  range.min_case = list.values_of(min->first);
  range.max_case = list.values_of(max->first);
  if (range.n > 1 && range.max - range.min <= 1e-9 * std::max(std::abs(range.min), std::abs(range.max)))
    range.min_case = range.max_case = "all " + std::to_string(range.n) + " cases";
  return range;
}

std::string sweep_answer(const CaseList &list, const FinishedCases &finished)
{
  const std::size_t n_cases = list.cases.size();
  const auto n_failed =
    std::count_if(finished.begin(), finished.end(), [](const auto &one) { return one.second.has_failed(); });
  const std::string of_cases = " of " + std::to_string(n_cases) + " cases ";
  std::string text;
  if (const auto falls = range_of(list, finished, "omega_fall"))
    append(text, "In " + std::to_string(falls->n) + of_cases +
                   "the glass stands at rest and tips over while it spins up" +
                   (falls->n == 1 ? " (" + falls->min_case + "); it has"
                                  : ", one of them " + falls->min_case + "; they have") +
                   " no terminal spin.");
  if (const auto n_at_rest = std::count_if(finished.begin(), finished.end(),
                                           [](const auto &one) { return one.second.tips_at_rest; }))
    append(text, "In " + std::to_string(n_at_rest) + of_cases + "the glass falls before it spins.");
  if (const auto n_formal =
        std::count_if(finished.begin(), finished.end(), [](const auto &one) { return one.second.is_formal; }))
    append(text, "In " + std::to_string(n_formal) + of_cases +
                   "the load is negative somewhere (tensile, not physical): their status is formal, and the "
                   "ranges leave them out.");
  if (const auto spin = range_of(list, finished, "omega_terminal"))
    append(text, under_its_load(list.base, "In " + std::to_string(spin->n) +
                                             (spin->n == 1 ? " case" : " cases") + " the terminal spin is ") +
                   (spin->min_case == spin->max_case
                      ? format::spin(spin->min) + " rad/s (" + spin->min_case + ")."
                      : "between " + format::spin(spin->min) + " rad/s (" + spin->min_case + ") and " +
                          format::spin(spin->max) + " rad/s (" + spin->max_case + ")."));
  if (const auto effect = range_of(list, finished, "harmonic_effect"))
  {
    const double largest = std::max(effect->max, -effect->min);
    if (is_spin(list.base, largest) && effect->min_case != effect->max_case)
      append(text, "The higher harmonics of the " + one_way_word(list.base) + "load change the spin by " +
                     number(effect->min, "+.3g") + " rad/s (" + effect->min_case + ") to " +
                     number(effect->max, "+.3g") + " rad/s (" + effect->max_case + ").");
    else if (largest != 0) // a load has one harmonic
      append(text, harmonic_effect_sentence(list.base, { effect->max, std::nullopt }));
  }
  if (n_failed > 0)
    append(text, std::to_string(n_failed) + " of " + std::to_string(finished.size()) +
                   " cases failed; sweep.csv gives the reasons in the column message.");
  return text;
}

} // namespace stemware::pipeline
