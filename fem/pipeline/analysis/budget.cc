#include "fem/pipeline/analysis/budget.h"

#include "fem/pipeline/variants/model_variants.h"

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

/// The place of a model of the chain by its key, "2a".
ChainStep step_of(const Variant &model)
{
  return { static_cast<unsigned int>(model.key.front() - '0'), model.key.size() > 1 };
}

/// Puts the answer to a model under those in @p rows.
void add_row(const ChainStep &step, const std::string &name, const Study &study, const SpinRow &row,
             std::vector<BudgetRow> &rows)
{
  BudgetRow added = { step, name, row.harmonics, row.omega_terminal() };
  if (!rows.empty() && added.omega_terminal && rows.back().omega_terminal)
    added.difference = *added.omega_terminal - *rows.back().omega_terminal + 0.; // no -0
  for (std::size_t i = 0; i < row.torques.size(); ++i)
    added.torques.at(i) = unless_nan(row.torques[i]);
  added.standing = row.terminal && row.pulls() ? Standing::formal : row.standing;
  added.reason = row.reason.empty() ? held_by_the_grip(study, row) : row.reason;
  rows.push_back(added);
}

/// The chain from the rows of its @p models in front and those by harmonics, which are rows 3 or 3a, 4, 5,
/// ... of a study whose load has harmonics to tell apart.
std::vector<BudgetRow> judge_chain(const Study &study, const std::vector<Variant> &models,
                                   const std::vector<SpinRow> &answers)
{
  std::vector<BudgetRow> rows;
  for (std::size_t i = 0; i < models.size(); ++i)
    add_row(step_of(models[i]), models[i].name, models[i].study, answers[i], rows);
  if (study.load.source == LoadSource::first_harmonic)
    return rows;
  const SpinRow &first = answers[models.size()];
  add_row({ 3, study.tilts() }, study.tilts() ? "tilt" : "where the foot touches", study, first, rows);
  ChainStep step = { 4 };
  for (std::size_t i = models.size() + 1; i < answers.size(); ++i)
  {
    add_row(step, "harmonics", study, answers[i], rows);
    ++step.number;
  }
  if (&first == &answers.back()) // a first harmonic from a file is all its harmonics
    add_row(step, "harmonics", study, first, rows);
  BudgetRow &all = rows.back();
  all.harmonics.reset();
  // The series of a pressure that ends somewhere dips below zero there; the pressure does not.
  if (study.load.is_from_contact() && all.standing == Standing::formal)
    all.standing = Standing::lift_off;
  return rows;
}

WithoutRow judge_without(const Variant &variant, const SpinRow &answer, const SpinRow &complete)
{
  WithoutRow row = { variant.name, answer.omega_terminal() };
  if (row.omega_terminal && complete.terminal)
    row.difference = *row.omega_terminal - complete.terminal->omega;
  row.reason = answer.reason.empty() ? held_by_the_grip(variant.study, answer) : answer.reason;
  return row;
}

/// Torques of all harmonics and of the first, from rest to a little beyond the terminal spin, or to the fall.
void add_curves(const Study &study, const std::vector<LoadedRow> &by_harmonics, Budget &budget)
{
  constexpr unsigned int n_intervals = 32;
  const SpinRow &all = by_harmonics.back().row;
  const double last = all.fall ? all.fall->omega : 1.2 * shown_spin(study, all, *all.omega_terminal());
  for (unsigned int i = 0; i <= n_intervals; ++i)
    budget.omega.push_back(last * i / n_intervals);
  const auto torques_of = [&](const LoadedRow &answer)
  {
    std::string reason; // the row says it
    return answer.load ? friction_torques(*answer.load, study.motion.orbit, budget.omega, reason)
                       : std::vector<double>(budget.omega.size(), std::nan(""));
  };
  budget.torque_all = torques_of(by_harmonics.back());
  budget.torque_first = torques_of(by_harmonics.front());
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
  return *difference / *reference + 0.; // no -0
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

std::vector<BudgetRow> budget_rows(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                                   const std::vector<SpinRow> &by_harmonics, const Executor &executor)
{
  const std::vector<Variant> models = model_chain(study);
  SpinQuestion question;
  question.near = known_zero(by_harmonics.back()); // they differ little from the complete model
  std::vector<SpinRow> answers;
  for (const LoadedRow &answer : solve_rows(models, foot, question, executor))
    answers.push_back(answer.row);
  answers.insert(answers.end(), by_harmonics.begin(), by_harmonics.end());
  for (SpinRow &row : answers)
    row.torques.clear();
  return judge_chain(study, models, answers);
}

std::vector<Variant> budget_variants(const Study &study, const SpinRow &all)
{
  std::vector<Variant> variants = model_chain(study);
  for (const Variant &variant : variants_without(study, all.ripple > 0))
    variants.push_back(variant);
  return variants;
}

Budget find_budget(const Study &study, const std::vector<LoadedRow> &by_harmonics,
                   const std::vector<LoadedRow> &answers, const Executor &executor)
{
  const SpinRow &all = by_harmonics.back().row;
  const std::optional<double> terminal = all.omega_terminal();
  Budget budget;
  budget.shown_spins = { 0 };
  if (terminal)
    budget.shown_spins = { 0, *terminal / 2, *terminal };

  const std::vector<Variant> models = model_chain(study), variants = budget_variants(study, all);
  for (std::size_t i = models.size(); i < variants.size(); ++i)
    budget.without.push_back(judge_without(variants[i], answers[i].row, all));

  std::vector<LoadedRow> chain = answers;
  chain.resize(models.size());
  chain.insert(chain.end(), by_harmonics.begin(), by_harmonics.end());
  std::vector<SpinRow> rows(chain.size());
  const auto add_torques = [&](std::size_t i)
  {
    rows[i] = chain[i].row;
    const ring::Motion &motion = (i < models.size() ? models[i].study : study).motion.orbit;
    if (chain[i].load)
      rows[i].torques = friction_torques(*chain[i].load, motion, budget.shown_spins, rows[i].reason);
  };
  // Loads that were cut off share the phases of what they are cut from.
  executor.for_each(chain.size(), add_torques, !study.load.is_in_balance());
  budget.rows = judge_chain(study, models, rows);
  // Of the last row, whose load is interpolated, the exact ones are known.
  budget.rows.back().torques[0] = all.at_rest->friction.torque;
  if (all.at_terminal)
    budget.rows.back().torques[2] = all.at_terminal->friction.torque;
  budget.harmonics = harmonic_effect(by_harmonics.front().row.omega_terminal(), terminal, spin_scale(study));
  add_curves(study, by_harmonics, budget);
  return budget;
}

} // namespace stemware::pipeline
