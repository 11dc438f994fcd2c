#include "fem/pipeline/analysis/budget.h"

#include "fem/pipeline/analysis/model_variants.h"

#include <cmath>
#include <cstddef>

namespace stemware::pipeline
{

namespace
{

std::optional<double> unless_nan(double value)
{
  return std::isnan(value) ? std::nullopt : std::optional(value);
}

void add_row(const ChainStep &step, const std::string &name, const LoadedRow &solved,
             std::vector<BudgetRow> &rows)
{
  const ring::Answer &row = solved.row;
  BudgetRow added = { step, name, row.harmonics, row.omega_terminal() };
  if (!rows.empty() && added.omega_terminal && rows.back().omega_terminal)
    added.difference = *added.omega_terminal - *rows.back().omega_terminal + 0.; // + 0. avoids -0
  for (std::size_t i = 0; i < solved.torques.size(); ++i)
    added.torques.at(i) = unless_nan(solved.torques[i].friction.torque);
  added.status = row.terminal && row.pulls() ? ring::Status::formal : row.status;
  added.reason =
    row.reason.empty() ? grip_holds_note(solved.variant.study.motion.grip_torque, row) : row.reason;
  rows.push_back(added);
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

std::vector<Variant> budget_variants(const Variant &own, bool depends_on_phase)
{
  std::vector<Variant> variants = model_chain(own);
  for (const Variant &variant : variants_without(own, depends_on_phase))
    variants.push_back(variant);
  for (const Variant &variant : input_variants(own))
    variants.push_back(variant);
  return variants;
}

std::vector<BudgetRow> assess_chain(const StudyRows &solved)
{
  const std::vector<LoadedRow> &by_harmonics = solved.by_harmonics;
  const Variant &own = by_harmonics.back().variant;
  std::vector<BudgetRow> rows;
  for (const LoadedRow &other : solved.others)
    if (other.variant.is_of_chain())
      add_row(other.variant.step, other.variant.name, other, rows);
  if (own.study.load.source == LoadSource::first_harmonic)
    return rows;
  const LoadedRow &first = by_harmonics.front();
  add_row({ 3, own.study.tilts() }, own.study.tilts() ? "tilt" : "where the foot touches", first, rows);
  ChainStep step = { 4 };
  for (std::size_t i = 1; i < by_harmonics.size(); ++i)
  {
    add_row(step, "harmonics", by_harmonics[i], rows);
    ++step.number;
  }
  if (by_harmonics.size() == 1) // in a load file with a single harmonic, the last row equals the first
    add_row(step, "harmonics", first, rows);
  BudgetRow &all = rows.back();
  all.harmonics.reset();
  // With lift-off, the truncated Fourier series of the load is slightly negative outside the contact. The
  // pressure is not negative, so the status `formal` (tensile load) does not apply.
  if (own.study.load.is_from_contact() && all.status == ring::Status::formal)
    all.status = ring::Status::lift_off;
  return rows;
}

Budget find_budget(const StudyRows &rows)
{
  const auto &[variant, all, load, torques] = rows.by_harmonics.back();
  Budget budget;
  budget.shown_spins = rows.torque_spins;
  for (const LoadedRow &solved : rows.others)
    if (solved.variant.kind == VariantKind::without)
      budget.without.push_back(judge_without(solved, all));
  budget.inputs = judge_inputs(variant.study.rounding_of_spins(), rows.others);
  budget.rows = assess_chain(rows);
  budget.harmonics = harmonic_effect(rows.by_harmonics.front().row.omega_terminal(), all.omega_terminal(),
                                     variant.study.spin_scale());
  return budget;
}

} // namespace stemware::pipeline
