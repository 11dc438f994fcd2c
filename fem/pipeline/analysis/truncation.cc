#include "fem/pipeline/analysis/truncation.h"

#include "fem/pipeline/analysis/spin.h"
#include "fem/pipeline/coupling/study_load.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <utility>

namespace stemware::pipeline
{

namespace
{

/// The load of a study with some of its harmonics, for any number of them >= 1.
using TruncatedLoads = std::function<BalancedLoad(unsigned int n_harmonics)>;

/// Spins from a little before rest to half as far again as the fastest terminal spin.
std::vector<double> shown_spins(const std::vector<SpinRow> &rows, double spin_scale)
{
  constexpr int n_intervals = 120;
  double fastest = rows.back().terminal->omega;
  for (const SpinRow &row : rows)
    if (row.terminal && std::abs(row.terminal->omega) > std::abs(fastest))
      fastest = row.terminal->omega;
  if (std::abs(fastest) < 0.01 * spin_scale) // a glass that hardly spins up
    fastest = std::copysign(0.1 * spin_scale, fastest);
  std::vector<double> spins;
  for (int i = -n_intervals / 8; i <= n_intervals; ++i)
    spins.push_back(1.5 * fastest * i / n_intervals);
  std::sort(spins.begin(), spins.end());
  return spins;
}

ring::Wrench wrench_or_nan(const BalancedLoad &load, const ring::Motion &motion, double omega)
{
  try
  {
    return wrench(load, motion, omega);
  }
  catch (const std::runtime_error &)
  {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    return { nan, nan, nan }; // the row says what is missing
  }
}

/// Torques of 1, 2, 3 and all harmonics.
TorqueCurve torque_curves(const std::vector<BalancedLoad> &loads, const std::vector<SpinRow> &rows,
                          const ring::Motion &motion)
{
  TorqueCurve curve;
  const double scale = loads.back().spin_scale(motion);
  curve.omega = shown_spins(rows, scale);
  const auto for_plots = [&](const BalancedLoad &load)
  { return load.for_plots(curve.omega.front(), curve.omega.back()); };
  const BalancedLoad all = for_plots(loads.back());
  for (const double omega : curve.omega)
  {
    curve.slip_ratio.push_back(omega / scale);
    curve.friction.push_back(wrench_or_nan(all, motion, omega));
  }
  for (std::size_t i = 0; i + 1 < loads.size() && rows[i].harmonics <= 3; ++i)
  {
    curve.harmonics.push_back(rows[i].harmonics);
    std::vector<double> &torques = curve.truncations.emplace_back();
    const BalancedLoad load = for_plots(loads[i]);
    for (const double omega : curve.omega)
      torques.push_back(wrench_or_nan(load, motion, omega).torque);
  }
  return curve;
}

/// @p on_the_way is the load of all harmonics for thousands of values between rest and the terminal spins;
/// empty: every row interpolates its own. Throws std::runtime_error where all harmonics have no terminal spin
/// or no spin-up.
TruncationTable solve_table(const TruncatedLoads &load_with, const std::optional<BalancedLoad> &on_the_way,
                            unsigned int n_all, SpinQuestion question, const std::function<void()> &row_done)
{
  TruncationTable table;
  std::vector<BalancedLoad> loads;
  for (const unsigned int n : truncation_orders(n_all))
  {
    loads.push_back(load_with(n));
    if (on_the_way)
      question.on_the_way = on_the_way->truncated(n);
    table.rows.push_back(attempt_spin_row(loads.back(), question));
    table.rows.back().harmonics = n;
    table.rows.back().all_harmonics = n == n_all;
    row_done();
  }
  const SpinRow all = table.all();
  if (!all.terminal || all.spin_up.empty())
    throw std::runtime_error(all.reason);
  for (std::size_t i = 0; i < loads.size(); ++i)
    try
    {
      relate_to_all(all, loads[i].whole(all.terminal->omega), question, table.rows[i]);
    }
    catch (const std::runtime_error &failure)
    {
      table.rows[i].reason = failure.what(); // no balance at the terminal spin of all harmonics
    }
  table.torque = torque_curves(loads, table.rows, question.motion);
  return table;
}

/// Why there is no balance with the friction of a truncated load, in one sentence; empty where there is one.
std::string why_no_balance(const Study &study, const std::shared_ptr<ElasticFoot> &foot)
{
  if (study.load.source == LoadSource::first_harmonic)
    return "A first-harmonic load has no harmonics to leave out.";
  if (!foot)
    return "A load from a file does not answer to friction, so there is no balance without its harmonics.";
  if (study.load.is_static())
    return "The moment is given (Load/Moment ratio), so there is no balance of moments for friction to "
           "enter.";
  if (foot->body().capabilities().is_collective && study.load.coupling == LoadCoupling::one_way)
    return "The balance without some harmonics takes a thousand contact solutions; for a solid body it is "
           "computed with Load/Coupling = two-way only.";
  return "";
}

} // namespace

TruncationStudy study_truncations(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                                  const BalancedLoad &load, std::vector<double> omega, Progress &progress)
{
  const ring::Motion &orbit = study.motion.orbit;
  TruncationStudy result;
  result.time = output_times(study.motion.end_time);
  result.paper = paper_spin_up(study, result.time);
  result.why_not = why_no_balance(study, foot);
  result.acts_back = result.why_not.empty() && spin_matters(study);
  result.same_whole_load = !result.acts_back || load.follows_spin();
  result.closures = closure_rows(study);

  const ring::TerminalSpin terminal = terminal_spin(load, orbit).spin;
  result.torque_slope = terminal.torque_slope;
  result.omega = omega.empty() ? std::vector<double>{ terminal.omega / 2, terminal.omega } : std::move(omega);
  const unsigned int n_all = load.n_harmonics();
  const std::size_t n_rows = truncation_orders(n_all).size() * (result.acts_back ? 2 : 1);
  std::size_t n_done = 0;
  const auto row_done = [&] { progress.pieces_done("truncations", ++n_done, n_rows); };

  SpinQuestion question = { orbit, result.omega, result.time };
  // Truncations end near the terminal spin of all harmonics; beyond this margin their loads are exact.
  const double margin = 0.05 * std::abs(terminal.omega);
  const BalancedLoad on_the_way =
    load.interpolated(std::min(0., terminal.omega - margin), std::max(0., terminal.omega + margin));
  result.frozen =
    solve_table([&](unsigned int n) { return load.truncated(n); }, on_the_way, n_all, question, row_done);
  if (!result.why_not.empty())
    return result;
  if (!result.acts_back)
  {
    result.self_consistent = result.frozen;
    return result;
  }
  try
  {
    result.self_consistent =
      solve_table([&](unsigned int n) { return balance(foot, moment_balance(study), load.report(), n); },
                  std::nullopt, n_all, question, row_done);
  }
  catch (const std::runtime_error &failure)
  {
    result.why_not = std::string("There is no balance with all harmonics: ") + failure.what() + ".";
  }
  return result;
}

} // namespace stemware::pipeline
