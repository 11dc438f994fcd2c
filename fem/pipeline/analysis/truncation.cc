#include "fem/pipeline/analysis/truncation.h"

#include <utility>

namespace stemware::pipeline
{

TruncationStudy study_truncations(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                                  const BalancedLoad &load, std::vector<double> omega,
                                  const Executor &executor, Progress &progress)
{
  TruncationStudy result;
  result.time = output_times(study.motion.end_time);
  result.paper = paper_spin_up(study, result.time);
  SpinQuestion question = spin_question(study);
  question.times = result.time;
  std::vector<LoadedRow> solved = rows_by_harmonics(study, foot, load, question, executor, progress);

  if (!solved.back().row.terminal)
    throw ring::NoBalance(solved.back().row.reason +
                          ": no terminal spin to compare with; stemware run shows it");
  const ring::TerminalSpin terminal = *solved.back().row.terminal;
  result.torque_slope = terminal.torque_slope;
  result.omega = omega.empty() ? std::vector<double>{ terminal.omega / 2, terminal.omega } : std::move(omega);
  for (LoadedRow &answer : solved)
  {
    if (answer.load)
      answer.row.torques =
        friction_torques(*answer.load, study.motion.orbit, result.omega, answer.row.reason);
    result.rows.push_back(answer.row);
  }
  result.budget = budget_rows(study, foot, result.rows, executor);
  result.harmonics = harmonic_effect(result.rows.front().omega_terminal(), terminal.omega, spin_scale(study));

  constexpr unsigned int n_most_shown = 3;
  const std::vector<double> shown = shown_spins(study, solved);
  interpolate_loads(shown.front(), shown.back(), n_most_shown, executor, solved);
  result.torque = torque_curve(study, solved, n_most_shown);
  return result;
}

} // namespace stemware::pipeline
