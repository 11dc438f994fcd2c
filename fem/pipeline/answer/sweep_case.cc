#include "fem/pipeline/answer/sweep_case.h"

#include "fem/contact/contact_newton.h"
#include "fem/pipeline/analysis/budget.h"
#include "fem/pipeline/answer/case_list.h"
#include "fem/pipeline/answer/threaded_executor.h"
#include "fem/pipeline/coupling/study_load.h"
#include "fem/pipeline/feet/failure_sentence.h"
#include "fem/pipeline/refinement/goal_mesh.h"
#include "fem/pipeline/refinement/quantities_of_interest.h"
#include "fem/pipeline/support/failures.h"
#include "ring_model/no_balance.h"
#include "ring_model/spin/torque_effect.h"

#include <cmath>
#include <exception>
#include <new>
#include <stdexcept>
#include <utility>

namespace stemware::pipeline
{

namespace
{

/// Case with its load and the rows of the first harmonic alone and of all.
struct SolvedCase
{
  const Study &study;
  const LoadReport load;
  const std::optional<fem::ContactState> contact; ///< at rest
  const ring::Answer first, all;
  const ring::TorqueEffects effects; ///< of all harmonics, without curves

  HarmonicEffect harmonics() const
  {
    return harmonic_effect(first.omega_terminal(), all.omega_terminal(), spin_scale(study));
  }

  /// Effect of all harmonics on tau_z at one of the spins of a TorqueEffect [N m], or over |tau_z| at rest.
  std::optional<double> torque_change(std::optional<ring::TorqueEffect::AtSpin> ring::TorqueEffect::*spin,
                                      bool is_relative) const
  {
    const auto &at_spin = effects.rows.back().*spin;
    if (!at_spin || (is_relative && effects.torque_at_rest == 0))
      return std::nullopt;
    return at_spin->change / (is_relative ? effects.torque_at_rest : 1);
  }

  /// Terminal spin of a first harmonic on a ring of the contact radius.
  std::optional<double> omega_on_ring(ring::Closure closure) const
  {
    return ring::answer(first_harmonic_load(study, closure), { study.motion.orbit }).omega_terminal();
  }
};

using Case = SolvedCase;
using Effect = ring::TorqueEffect;
using Number = std::optional<double>;

/// Number of a case with its key.
struct CaseNumber
{
  std::string key;
  std::function<Number(const Case &)> value;
};

std::vector<CaseNumber> make_numbers()
{
  std::vector<CaseNumber> numbers = {
    { "omega_terminal", [](const Case &found) { return found.all.omega_terminal(); } },
    { "omega_first_harmonic", [](const Case &found) { return found.first.omega_terminal(); } },
    { "omega_on_ring", [](const Case &found) { return found.omega_on_ring(found.study.motion.closure); } },
    { "omega_paper", [](const Case &found) { return found.omega_on_ring(ring::Closure::paper); } },
    { "harmonic_effect", [](const Case &found) { return found.harmonics().absolute; } },
    { "harmonic_effect_relative", [](const Case &found) { return found.harmonics().relative; } },
    { "torque_change_half", [](const Case &found) { return found.torque_change(&Effect::half, false); } },
    { "torque_change_half_relative",
      [](const Case &found) { return found.torque_change(&Effect::half, true); } },
    { "torque_change_terminal",
      [](const Case &found) { return found.torque_change(&Effect::terminal, false); } },
    { "torque_change_terminal_relative",
      [](const Case &found) { return found.torque_change(&Effect::terminal, true); } },
    { "time_constant", [](const Case &found) { return found.all.time_constant(); } },
    { "held",
      [](const Case &found)
      {
        return found.study.motion.grip_torque > 0 && found.all.terminal
                 ? Number(found.all.terminal->held ? 1 : 0)
                 : std::nullopt;
      } },
    { "omega_fall",
      [](const Case &found) { return found.all.fall ? Number(found.all.fall->omega) : std::nullopt; } },
    { "moment_ratio_at_fall", [](const Case &found)
      { return found.all.fall ? Number(found.all.fall->state.moment_ratio) : std::nullopt; } },
    { "tau_at_rest", [](const Case &found) { return found.all.at_rest->friction.torque; } },
    { "normal_force", [](const Case &found) { return found.load.normal_force; } },
    { "moment_ratio", [](const Case &found) { return found.load.moment_ratio; } },
    { "contact_fraction", [](const Case &found) { return found.load.contact_fraction; } },
    { "load_minimum", [](const Case &found) { return found.load.minimum; } },
    { "ring_radius", [](const Case &found) { return found.load.rings.radius(); } },
    { "mean_radius", [](const Case &found) { return found.load.mean_radius; } },
    { "contact_iterations", [](const Case &found)
      { return found.contact ? Number(found.contact->solution.n_iterations) : std::nullopt; } },
    { "mean_load", [](const Case &found) { return found.load.rings.a(0); } }
  };
  for (unsigned int i = 0; i < 2 * n_harmonics_of_interest; ++i) // a_1/a_0, b_1/a_0, a_2/a_0, ...
    numbers.push_back({ load_quantities(LoadReport())[i].key,
                        [i](const Case &found) { return load_quantities(found.load)[i].value; } });
  return numbers;
}

const std::vector<CaseNumber> &case_numbers()
{
  static const std::vector<CaseNumber> numbers = make_numbers();
  return numbers;
}

/// Some cases of a list as variants, each made when it is asked for.
struct CaseVariants
{
  std::size_t size() const { return indices.size(); }
  Variant operator[](std::size_t i) const
  {
    const Study study = list.study_of(indices[i]);
    return { "", "", study, mesh_for_goal(study, executor).discretisation };
  }

  const CaseList &list;
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
  return {
    fem::to_string(contact.outcome), failure_sentence(), {}, contact.outcome == fem::ContactOutcome::tipping
  };
}
catch (const ring::Tipping &)
{
  return { "", failure_sentence(), {}, true };
}
catch (const std::bad_alloc &)
{
  throw;
}
catch (const OutputFailure &)
{
  throw;
}
catch (...)
{
  return { "", failure_sentence() };
}

/// True if a case takes all threads. False for one that cannot even be read.
bool is_collective_case(const CaseList &list, std::size_t index)
try
{
  return is_collective(list.study_of(index));
}
catch (const BadInput &)
{
  return false;
}

} // namespace

const std::vector<std::string> &sweep_keys()
{
  static const std::vector<std::string> keys = []
  {
    std::vector<std::string> list;
    for (const CaseNumber &number : case_numbers())
      list.push_back(number.key);
    return list;
  }();
  return keys;
}

std::optional<double> CaseResult::value(const std::string &key) const
{
  const auto found = values.find(key);
  return found == values.end() ? std::nullopt : std::optional(found->second);
}

CaseResult case_result(const Study &study, const std::shared_ptr<ElasticFoot> &foot, const Executor &executor,
                       Progress &progress)
{
  const BalancedLoad load = find_load(study, foot, progress);
  ring::Question question = spin_question(study);
  question.with_minima = false;
  const std::vector<LoadedRow> rows =
    rows_by_harmonics(study, foot, load, question, executor, progress, Depth::answer).by_harmonics;
  const SolvedCase found = {
    study,           load.report(),
    load.contact(0), rows.front().row,
    rows.back().row, ring::torque_effects(load, study.motion.orbit, rows.back().row, { load.n_harmonics() })
  };
  CaseResult result;
  if (found.contact)
    result.outcome = fem::to_string(found.contact->solution.outcome);
  for (const auto &[key, value_of] : case_numbers())
    if (const std::optional<double> value = value_of(found))
    {
      if (!std::isfinite(*value))
        throw std::runtime_error("The result " + key + " is not a finite number; please report this study.");
      result.values[key] = *value + 0.; // no -0
    }
  return result;
}

CaseResult case_result(const Study &study, const Executor &executor, Progress &progress,
                       std::shared_ptr<ElasticFoot> *start)
{
  const Variant variant = { "", "", study, mesh_for_goal(study, executor).discretisation };
  const auto foot = foot_of(variant, start ? *start : nullptr, executor);
  CaseResult result = case_result(study, foot, executor, progress);
  if (start)
    *start = foot;
  return result;
}

void solve_cases(const CaseList &list, const std::vector<std::size_t> &wanted, unsigned int n_threads,
                 const std::function<void(std::size_t, const CaseResult &)> &finish)
{
  std::vector<std::size_t> single, collective;
  for (const std::size_t index : wanted)
    (is_collective_case(list, index) ? collective : single).push_back(index);
  fem::ComplianceCache cache;
  const ThreadedExecutor within_case(cache);
  for (const auto &[indices, threads] : { std::pair(single, n_threads), std::pair(collective, 1u) })
  {
    ThreadedExecutor executor(cache, threads);
    executor.keeps_all_failures = true;
    const auto result_of = [&](const Variant &variant, const std::shared_ptr<ElasticFoot> &foot)
    { return case_result(variant.study, foot, within_case); };
    const auto done = [&, &indices = indices](std::size_t i, const Solved<CaseResult> &solved)
    { finish(indices[i], solved.answer ? *solved.answer : failed_case(solved.failure)); };
    solve(CaseVariants{ list, indices, within_case }, nullptr, result_of, executor, done);
  }
}

} // namespace stemware::pipeline
