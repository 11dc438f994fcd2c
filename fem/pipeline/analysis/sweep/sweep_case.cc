#include "fem/pipeline/analysis/sweep/sweep_case.h"

#include "fem/contact/contact_newton.h"
#include "fem/pipeline/analysis/budget.h"
#include "fem/pipeline/analysis/refinement/goal_mesh.h"
#include "fem/pipeline/analysis/refinement/quantities_of_interest.h"
#include "fem/pipeline/analysis/sweep/sweep_folder.h"
#include "fem/pipeline/analysis/sweep/sweep_plan.h"
#include "fem/pipeline/coupling/failure_sentence.h"
#include "fem/pipeline/coupling/study_load.h"
#include "fem/pipeline/support/ranks.h"

#include <chrono>
#include <cmath>
#include <exception>
#include <stdexcept>

namespace stemware::pipeline
{

/// A solved case: its load, its rows and its budget.
struct FoundCase
{
  const Study &study;
  const LoadReport load;
  const std::optional<fem::ContactState> contact; ///< at rest
  const SpinRow first, all;                       ///< of the first harmonic alone and of all
  const std::vector<BudgetRow> budget;

  HarmonicEffect harmonics() const
  {
    return harmonic_effect(first.omega_terminal(), all.omega_terminal(), spin_scale(study));
  }

  /// The terminal spin of a first harmonic on a ring of the contact radius; nothing where there is none.
  std::optional<double> spin_of_first_harmonic(ring::Closure closure) const
  {
    return attempt_spin_row(*first_harmonic_load(study, closure), { study.motion.orbit }).omega_terminal();
  }

  /// Relative change of the spin from the paper's moment balance to the full one; with a given moment no
  /// balance acts.
  std::optional<double> closure_effect() const
  {
    if (study.load.is_static() || study.load.source == LoadSource::file)
      return std::nullopt;
    const std::optional<double> paper = spin_of_first_harmonic(ring::Closure::paper),
                                full = spin_of_first_harmonic(ring::Closure::full);
    return paper && full ? relative_to(paper, *full - *paper, spin_scale(study)) : std::nullopt;
  }

  std::optional<double> held() const
  {
    return study.motion.grip_torque > 0 && all.terminal ? std::optional<double>(all.terminal->held ? 1 : 0)
                                                        : std::nullopt;
  }
};

namespace
{

using Case = FoundCase;

std::optional<double> in_percent(const std::optional<double> &share)
{
  return share ? std::optional(100 * *share) : std::nullopt;
}

/// Difference of the terminal spin in the row of the budget that has this name [rad/s]; nothing without such
/// a row.
SweepQuantity difference_by(const std::string &name)
{
  return { name, "rad/s",
           [name](const Case &found) -> std::optional<double>
           {
             for (const BudgetRow &row : found.budget)
               if (row.name == name || (name == "moment balance" && row.name == "given moment"))
                 return row.difference;
             return std::nullopt;
           } };
}

std::vector<SweepQuantity> make_quantities()
{
  std::vector<SweepQuantity> quantities = {
    { "normal force", "N", [](const Case &found) { return found.load.normal_force; } },
    { "moment ratio", "1", [](const Case &found) { return found.load.moment_ratio; } },
    { "contact fraction", "1", [](const Case &found) { return found.load.contact_fraction; } },
    { "least load at rest", "N/rad", [](const Case &found) { return found.load.minimum; } },
    { "ring radius", "m", [](const Case &found) { return found.load.rings.radius(); } },
    { "mean radius", "m", [](const Case &found) { return found.load.mean_radius; } },
    { "a_0", "N/rad", [](const Case &found) { return found.load.rings.a(0); } }
  };
  for (unsigned int i = 0; i < 2 * n_harmonics_of_interest; ++i) // a_1/a_0, b_1/a_0, a_2/a_0, ...
  {
    const QuantityOfInterest harmonic = load_quantities(LoadReport(), 1)[i];
    quantities.push_back({ harmonic.name, harmonic.unit,
                           [i](const Case &found) { return load_quantities(found.load, 1)[i].value; } });
  }
  quantities.insert(
    quantities.end(),
    { { "torque at rest", "N m", [](const Case &found) { return found.all.at_rest->friction.torque; } },
      { "terminal spin", "rad/s", [](const Case &found) { return found.all.omega_terminal(); } },
      { "terminal spin of the first harmonic alone", "rad/s",
        [](const Case &found) { return found.first.omega_terminal(); } },
      { "terminal spin of the closure's first harmonic", "rad/s",
        [](const Case &found) { return found.spin_of_first_harmonic(found.study.motion.closure); } },
      difference_by("moment balance"),
      difference_by("grip"),
      difference_by("where the foot touches"),
      difference_by("tilt"),
      { "absolute harmonic effect", "rad/s", [](const Case &found) { return found.harmonics().absolute; } },
      { "harmonic effect", "%", [](const Case &found) { return in_percent(found.harmonics().relative); } },
      { "closure effect", "%", [](const Case &found) { return in_percent(found.closure_effect()); } },
      { "held by the grip", "1", [](const Case &found) { return found.held(); } },
      { "time constant", "s", [](const Case &found) { return found.all.time_constant(); } },
      { "contact iterations", "1",
        [](const Case &found) {
          return found.contact ? std::optional<double>(found.contact->solution.n_iterations) : std::nullopt;
        } },
      { spin_of_fall, "rad/s",
        [](const Case &found)
        { return found.all.fall ? std::optional(found.all.fall->omega) : std::nullopt; } },
      { "moment ratio at which it falls over", "1", [](const Case &found) {
         return found.all.fall ? std::optional(found.all.fall->state.moment_ratio) : std::nullopt;
       } } });
  return quantities;
}

/// The cases of a sweep as variants, each made when it is asked for.
struct Cases
{
  std::size_t size() const { return indices.size(); }
  Variant operator[](std::size_t i) const
  {
    return { "", "", mesh_for_goal(plan.study_of(indices[i]), executor).study };
  }

  const SweepPlan &plan;
  const std::vector<std::size_t> &indices;
  const Executor &executor;
};

CaseResult failed_case(const std::exception_ptr &failure)
try
{
  std::rethrow_exception(failure);
}
catch (const fem::ContactFailure &contact)
{
  return { fem::to_string(contact.outcome), failure_sentence(), {} };
}
catch (...)
{
  return { "", failure_sentence(), {} };
}

/// Whether a case is one that all ranks solve together, after another: a solid body. False for cases that
/// cannot even be read.
bool needs_all_ranks(const SweepPlan &plan, std::size_t index)
try
{
  return is_collective(plan.study_of(index));
}
catch (const BadInput &)
{
  return false;
}

/// Solves cases of this rank, or of all ranks @p together.
void solve_part(const SweepPlan &plan, const std::vector<std::size_t> &indices, unsigned int n_threads,
                bool together, CaseLog &log, const std::function<void()> &watch)
{
  fem::ComplianceCache cache;
  const Executor within_case(cache);
  Executor executor(cache, together ? 1 : n_threads);
  executor.keeps_all_failures = !together || n_ranks() == 1;
  auto last_watched = std::chrono::steady_clock::now();
  const auto finish = [&](std::size_t i, const Solved<CaseResult> &solved)
  {
    const CaseResult result = solved.answer ? *solved.answer : failed_case(solved.failure);
    const auto append = [&] { log.append(indices[i], result); };
    together ? on_first_rank(append) : append();
    const auto now = std::chrono::steady_clock::now();
    if (now - last_watched < std::chrono::milliseconds(200))
      return;
    last_watched = now;
    watch();
  };
  const auto result_of = [&](const Variant &variant, const std::shared_ptr<ElasticFoot> &foot)
  { return case_result(variant.study, foot, within_case); };
  watch();
  solve(Cases{ plan, indices, within_case }, nullptr, result_of, executor, finish);
  watch();
}

} // namespace

const std::vector<SweepQuantity> &sweep_quantities()
{
  static const std::vector<SweepQuantity> quantities = make_quantities();
  return quantities;
}

std::size_t quantity_index(const std::string &name)
{
  for (std::size_t i = 0; i < sweep_quantities().size(); ++i)
    if (sweep_quantities()[i].name == name)
      return i;
  throw std::logic_error("a sweep has no quantity " + name);
}

std::optional<double> CaseResult::value(std::size_t quantity) const
{
  return is_solved() ? values.at(quantity) : std::nullopt;
}

bool CaseResult::falls_over() const
{
  return value(quantity_index(spin_of_fall)).has_value();
}

CaseResult case_result(const Study &study, const std::shared_ptr<ElasticFoot> &foot, const Executor &executor)
{
  const SharedLoad load = find_load(study, foot);
  SpinQuestion question = spin_question(study);
  question.with_minima = false;
  const std::vector<LoadedRow> rows =
    rows_by_harmonics(study, foot, *load, question, executor, silent_progress(), Depth::answer);
  const SpinRow &first = rows.front().row, &all = rows.back().row;
  const FoundCase found = {
    study, load->report(), load->contact(0), first, all, budget_rows(study, foot, { first, all }, executor)
  };
  CaseResult result;
  if (found.contact)
    result.outcome = fem::to_string(found.contact->solution.outcome);
  for (const SweepQuantity &quantity : sweep_quantities())
  {
    const std::optional<double> value = quantity.value(found);
    if (value && !std::isfinite(*value))
      throw std::runtime_error("The result " + quantity.name +
                               " is not a finite number; please report this study.");
    result.values.push_back(value ? std::optional(*value + 0.) : std::nullopt); // no -0
  }
  return result;
}

void solve_cases(const SweepPlan &plan, const FinishedCases &finished, unsigned int n_threads, CaseLog &log,
                 const std::function<void()> &watch)
{
  std::vector<std::size_t> own, common;
  std::size_t n_single = 0;
  for (std::size_t index = 0; index < plan.cases.size(); ++index)
    if (finished.count(index) > 0)
      continue;
    else if (needs_all_ranks(plan, index))
      common.push_back(index);
    else if (n_single++ % n_ranks() == this_rank()) // neighbours take about equally long
      own.push_back(index);
  on_every_rank([&] { solve_part(plan, own, n_threads, false, log, watch); });
  solve_part(plan, common, n_threads, true, log, watch);
}

} // namespace stemware::pipeline
