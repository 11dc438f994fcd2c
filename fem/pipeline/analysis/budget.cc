#include "fem/pipeline/analysis/budget.h"

#include "fem/pipeline/analysis/variant.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace stemware::pipeline
{

namespace
{

/// Returns the row of @p solved that follows the rows @p above. @p is_complete: true for the study itself.
BudgetRow row_below(const std::vector<BudgetRow> &above, const ChainStep &step, const std::string &name,
                    const LoadedRow &solved, bool is_complete, const std::optional<double> &band)
{
  const ring::Answer &row = solved.row;
  const Study &study = solved.variant.study;
  BudgetRow added = { step, name, {}, row.omega_terminal(), {}, band };
  if (!is_complete)
    added.harmonics = row.harmonics;
  if (!above.empty() && added.omega_terminal && above.back().omega_terminal)
    added.difference = *added.omega_terminal - *above.back().omega_terminal + 0.; // + 0. avoids -0
  for (std::size_t i = 0; i < solved.torques.size(); ++i)
    if (const double torque = solved.torques[i].friction.torque; !std::isnan(torque))
      added.torques.at(i) = torque;
  added.status = row.terminal && row.pulls() ? ring::Status::formal : row.status;
  // With lift-off, the truncated Fourier series of the load is slightly negative outside the contact. The
  // pressure is not negative, so the status `formal` (tensile load) does not apply.
  if (is_complete && study.load.is_from_contact() && added.status == ring::Status::formal)
    added.status = ring::Status::lift_off;
  added.reason = row.reason.empty() ? grip_holds_note(study.motion.grip_torque, row) : row.reason;
  return added;
}

WithoutRow judge_without(const LoadedRow &solved, const ring::Answer &complete)
{
  const ring::Answer &answer = solved.row;
  WithoutRow row = { solved.variant.name, answer.omega_terminal() };
  if (row.omega_terminal && complete.terminal)
    row.difference = *row.omega_terminal - complete.terminal->omega;
  row.reason =
    answer.reason.empty() ? grip_holds_note(solved.variant.study.motion.grip_torque, answer) : answer.reason;
  return row;
}

/// Returns the effect of each changed input on the terminal spin. Effects below rounding are omitted.
std::vector<std::pair<std::string, double>> judge_inputs(double rounding_of_spins,
                                                         const std::vector<LoadedRow> &others)
{
  std::optional<double> unchanged;
  std::vector<std::pair<std::string, double>> rows;
  for (const LoadedRow &solved : others)
    if (solved.variant.kind == VariantKind::input)
    {
      const std::optional<double> omega = solved.row.omega_terminal();
      if (!unchanged)
        unchanged = omega;
      if (!unchanged)
        return {};
      if (omega && std::abs(*omega - *unchanged) > rounding_of_spins)
        rows.push_back({ solved.variant.name, *omega - *unchanged });
    }
  return rows;
}

} // namespace

std::optional<double> relative_to(const std::optional<double> &reference,
                                  const std::optional<double> &difference, double spin_scale)
{
  const double rounding = 1e-9 * spin_scale;
  if (!reference || !difference || std::abs(*reference) < rounding)
    return std::nullopt;
  if (std::abs(*difference) < rounding)
    return 0;
  const double other = *reference + *difference;
  if (std::abs(other) < rounding || *reference * other < 0)
    return std::nullopt;
  return *difference / *reference + 0.; // + 0. avoids -0
}

HarmonicEffect harmonic_effect(const std::optional<double> &first, const std::optional<double> &all,
                               double spin_scale)
{
  HarmonicEffect effect;
  if (first && all)
    effect.absolute = *all - *first;
  effect.relative = relative_to(first, effect.absolute, spin_scale);
  return effect;
}

HarmonicEffect harmonic_effect(const StudyRows &rows)
{
  return harmonic_effect(rows.omega_first_harmonic(), rows.answer().omega_terminal(),
                         rows.by_harmonics.back().variant.study.spin_scale());
}

std::vector<Variant> budget_variants(const Variant &own, bool depends_on_phase)
{
  std::vector<Variant> variants = model_chain(own);
  for (const Variant &variant : variants_without(own, depends_on_phase))
    variants.push_back(variant);
  for (const Variant &variant : input_variants(own))
    variants.push_back(variant);
  return variants;
}

std::optional<double> model_band(double omega, const std::optional<double> &omega_all,
                                 const std::optional<double> &omega_first, const SpinBands &bands)
{
  const auto &[of_all, of_first] = bands;
  if (!of_all || !omega_all)
    return std::nullopt;
  const double to_all = std::abs(omega - *omega_all), from_all = *of_all + to_all;
  if (of_first && omega_first)
    return std::min({ std::max(*of_all, *of_first), from_all, *of_first + std::abs(omega - *omega_first) });
  return to_all <= *of_all ? std::optional(from_all) : std::nullopt;
}

std::vector<BudgetRow> assess_chain(const StudyRows &solved, const SpinBands &bands)
{
  const std::vector<LoadedRow> &by_harmonics = solved.by_harmonics;
  const Variant &own = by_harmonics.back().variant;
  std::vector<BudgetRow> rows;
  const auto add = [&](const ChainStep &step, const std::string &name, const LoadedRow &row, bool is_complete)
  {
    std::optional<double> band;
    if (const std::optional<double> omega = row.row.omega_terminal(); omega && step.is_of_contact())
      band = model_band(*omega, solved.answer().omega_terminal(), solved.omega_first_harmonic(), bands);
    rows.push_back(row_below(rows, step, name, row, is_complete, band));
  };
  for (const LoadedRow &other : solved.others)
    if (other.variant.is_of_chain())
      add(other.variant.step, other.variant.name, other, false);
  if (own.study.load.source == LoadSource::first_harmonic)
    return rows;
  const LoadedRow &first = by_harmonics.front();
  add({ 3, own.study.tilts() }, own.study.tilts() ? "tilt" : "where the foot touches", first, false);
  // In a load file with a single harmonic, the last row equals the first.
  const std::size_t last = by_harmonics.size() - 1;
  ChainStep step = { 4 };
  for (std::size_t i = std::min<std::size_t>(1, last); i <= last; ++i)
  {
    add(step, "harmonics", by_harmonics[i], i == last);
    ++step.number;
  }
  return rows;
}

Budget find_budget(const StudyRows &rows, const SpinBands &bands)
{
  const auto &[variant, all, load, torques] = rows.by_harmonics.back();
  Budget budget;
  for (const LoadedRow &solved : rows.others)
    if (solved.variant.kind == VariantKind::without)
      budget.without.push_back(judge_without(solved, all));
  budget.inputs = judge_inputs(variant.study.rounding_of_spins(), rows.others);
  budget.rows = assess_chain(rows, bands);
  return budget;
}

} // namespace stemware::pipeline
