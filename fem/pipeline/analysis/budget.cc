#include "fem/pipeline/analysis/budget.h"

#include "fem/pipeline/analysis/model_variants.h"
#include "fem/pipeline/coupling/study_load.h"

#include <cmath>
#include <cstddef>

namespace stemware::pipeline
{

namespace
{

/// The question for a model that differs little from the complete one, whose answer is @p complete.
SpinQuestion question_near(const Study &study, const SpinRow &complete)
{
  SpinQuestion question = spin_question(study);
  question.near = known_zero(complete);
  return question;
}

/// A model of the chain.
struct Model
{
  ChainStep step;
  std::string name;
  Study study;
};

/// The models in front of those that are told apart by their harmonics: 1, 1a, 2, 2a and 3, all of them with
/// a first harmonic.
std::vector<Model> first_models(const Study &study)
{
  std::vector<Model> models = { { { 1 }, "paper", paper_study(study) } };
  if (!study.motion.orbit.has_constant_friction())
  {
    models.push_back({ { 1, true }, "friction law", models.back().study });
    models.back().study.motion.orbit = study.motion.orbit;
  }
  if (study.load.source != LoadSource::file)
  {
    models.push_back(
      { { 2 }, study.load.is_static() ? "given moment" : "moment balance", first_harmonic_study(study) });
    models.back().study.motion.grip_torque = 0;
  }
  if (study.motion.grip_torque > 0)
  {
    models.push_back({ { 2, true }, "grip", models.back().study });
    models.back().study.motion.grip_torque = study.motion.grip_torque;
  }
  if (study.tilts())
  {
    models.push_back({ { 3 }, "where the foot touches", study });
    models.back().study.motion.tilt = false;
  }
  return models;
}

std::optional<double> unless_nan(double value)
{
  return std::isnan(value) ? std::nullopt : std::optional(value);
}

/// A row of the budget with the load that it is the answer to.
struct ChainLink
{
  BudgetRow row;
  SharedLoad load;
  ring::Motion motion;
};

/// Puts the answer to a model under those in @p chain.
void add_link(const ChainStep &step, const std::string &name, const Study &study, const LoadedRow &answer,
              std::vector<ChainLink> &chain)
{
  const SpinRow &row = answer.row;
  BudgetRow added = { step, name, row.harmonics, row.omega_terminal() };
  if (!chain.empty() && added.omega_terminal && chain.back().row.omega_terminal)
    added.difference = *added.omega_terminal - *chain.back().row.omega_terminal + 0.; // no -0
  added.standing = row.terminal && row.pulls() ? Standing::formal : row.standing;
  added.reason = row.reason.empty() ? held_by_the_grip(study, row) : row.reason;
  chain.push_back({ added, answer.load, study.motion.orbit });
}

/// Rows 3 or 3a, 4, 5, ... of a study whose load has harmonics to tell apart.
void add_links_by_harmonics(const Study &study, const std::vector<LoadedRow> &by_harmonics,
                            std::vector<ChainLink> &chain)
{
  add_link({ 3, study.tilts() }, study.tilts() ? "tilt" : "where the foot touches", study,
           by_harmonics.front(), chain);
  ChainStep step = { 4 };
  for (std::size_t i = 1; i < by_harmonics.size(); ++i)
  {
    add_link(step, "harmonics", study, by_harmonics[i], chain);
    ++step.number;
  }
  if (by_harmonics.size() == 1) // a first harmonic from a file is all its harmonics
    add_link(step, "harmonics", study, by_harmonics.back(), chain);
  BudgetRow &all = chain.back().row;
  all.harmonics.reset();
  // The series of a pressure that ends somewhere dips below zero there; the pressure does not.
  if (study.load.is_from_contact() && all.standing == Standing::formal)
    all.standing = Standing::lift_off;
}

std::vector<ChainLink> chain_of(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                                const std::vector<LoadedRow> &by_harmonics)
{
  std::vector<ChainLink> chain;
  for (const Model &model : first_models(study))
  {
    LoadedRow answer = attempt_row(model.study, foot, question_near(model.study, by_harmonics.back().row), 1);
    answer.row.harmonics = 1;
    add_link(model.step, model.name, model.study, answer, chain);
  }
  if (study.load.source != LoadSource::first_harmonic)
    add_links_by_harmonics(study, by_harmonics, chain);
  return chain;
}

/// The row of a link with its torques.
BudgetRow row_with_torques(const ChainLink &link, const std::vector<double> &spins)
{
  BudgetRow row = link.row;
  if (!link.load)
    return row;
  const std::vector<double> torques = friction_torques(*link.load, link.motion, spins, row.reason);
  for (std::size_t i = 0; i < torques.size(); ++i)
    row.torques[i] = unless_nan(torques[i]);
  return row;
}

/// @p foot and @p complete are those of the complete model.
WithoutRow answer_without(const ModelVariant &variant, const ElasticFoot *foot, const SpinRow &complete,
                          bool complete_is_hard, fem::ComplianceCache &cache)
{
  WithoutRow row = { variant.name };
  if (!has_compliance(variant.study))
  {
    row.reason = "not defined";
    return row;
  }
  const bool depends_on_phase = variant.study.has_waviness() || complete.ripple > 0;
  const bool is_of_revolution = abilities(variant.study.contact.body).is_of_revolution;
  if (depends_on_phase && !is_of_revolution && variant.study.table.is_hard() && !complete_is_hard)
  {
    row.reason = "not computed: a solid foot on a hard table takes long at every phase";
    return row;
  }
  const LoadedRow answer =
    attempt_row(variant.study, cache, question_near(variant.study, complete), all_harmonics, foot);
  row.omega_terminal = answer.row.omega_terminal();
  if (row.omega_terminal && complete.terminal)
    row.difference = *row.omega_terminal - complete.terminal->omega;
  row.reason = answer.row.reason.empty() ? held_by_the_grip(variant.study, answer.row) : answer.row.reason;
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
                                   const std::vector<SpinRow> &by_harmonics)
{
  std::vector<LoadedRow> answers;
  for (const SpinRow &row : by_harmonics)
    answers.push_back({ row });
  std::vector<BudgetRow> rows;
  for (ChainLink &link : chain_of(study, foot, answers))
    rows.push_back(std::move(link.row));
  return rows;
}

Budget find_budget(const Study &study, fem::ComplianceCache &cache, Progress &progress)
{
  const std::shared_ptr<ElasticFoot> foot = study_foot(study, cache, progress);
  const SharedLoad load = find_load(study, foot, progress);
  return find_budget(study, foot, rows_by_harmonics(study, foot, *load, spin_question(study), progress),
                     cache, progress);
}

Budget find_budget(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                   const std::vector<LoadedRow> &by_harmonics, fem::ComplianceCache &cache,
                   Progress &progress)
{
  const std::optional<double> terminal = by_harmonics.back().row.omega_terminal();
  const std::vector<ModelVariant> variants = variants_without(study);
  const std::size_t n_pieces = 1 + variants.size();
  std::size_t n_done = 0;

  Budget budget;
  budget.shown_spins = { 0 };
  if (terminal)
    budget.shown_spins = { 0, *terminal / 2, *terminal };
  for (const ChainLink &link : chain_of(study, foot, by_harmonics))
    budget.rows.push_back(row_with_torques(link, budget.shown_spins));
  // Of the last row, whose load is interpolated, the exact ones are known.
  const SpinRow &all = by_harmonics.back().row;
  budget.rows.back().torques[0] = all.at_rest->friction.torque;
  if (all.at_terminal)
    budget.rows.back().torques[2] = all.at_terminal->friction.torque;
  progress.pieces_done("budget", ++n_done, n_pieces);
  for (const ModelVariant &variant : variants)
  {
    budget.without.push_back(
      answer_without(variant, foot.get(), by_harmonics.back().row, study.table.is_hard(), cache));
    progress.pieces_done("budget", ++n_done, n_pieces);
  }
  budget.harmonics = harmonic_effect(by_harmonics.front().row.omega_terminal(), terminal, spin_scale(study));
  add_curves(study, by_harmonics, budget);
  return budget;
}

} // namespace stemware::pipeline
