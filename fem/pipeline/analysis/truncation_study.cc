#include "fem/pipeline/analysis/truncation_study.h"

#include "fem/pipeline/analysis/truncated_loads.h"
#include "fem/pipeline/coupling/coupled_load.h"
#include "fem/pipeline/coupling/load_curve.h"
#include "ring_model/yaw_dynamics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace stemware::pipeline
{

namespace
{

/// What all answers of one study share.
struct Question
{
  const MotionSection &motion;
  double spin_scale;                ///< v / R [rad/s]
  unsigned int n_all;               ///< harmonics of the load
  const std::vector<double> &omega; ///< where the torque is wanted
  const std::vector<double> &time;
  std::function<void()> one_done; ///< to be called after each truncation

  ring::CoulombRing friction() const { return ring::CoulombRing(motion.orbit.friction_coefficient); }
  ring::Wrench wrench(const ring::RingStack &load, double omega) const
  {
    return friction().wrench(load, omega, motion.orbit.orbit_speed);
  }
  double torque(const ring::RingStack &load, double omega) const { return wrench(load, omega).torque; }
};

ring::TorqueFunction torque_of(const Question &question, const LoadAtSpin &load)
{
  return [&question, load](double omega) { return question.torque(load(omega), omega); };
}

NegativeLoad negative_part(const ring::RingStack &load)
{
  return { load.minimum(), load.pulling_force() / load.normal_force() };
}

/// The load for a spin-up that ends at @p terminal.
LoadAtSpin load_on_the_way(const TruncatedLoad &load, double terminal)
{
  if (load.on_the_way)
    return load.on_the_way;
  RingLoad costly = { load.kept, load.kept(0) };
  costly.is_costly = load.is_costly;
  costly.coupling = std::make_shared<CouplingFigures>();
  const double margin = 0.02 * std::abs(terminal);
  return for_many_spins(costly, std::min(0., terminal - margin), std::max(0., terminal + margin));
}

/// omega(t) from rest; @p terminal is where it ends.
std::vector<double> spin_up(const Question &question, const TruncatedLoad &load, double terminal)
{
  const LoadAtSpin at_spin = load_on_the_way(load, terminal);
  std::vector<double> spins;
  for (const ring::SpinSample &sample :
       ring::spin_up([&](double, double omega) { return question.torque(at_spin(omega), omega); },
                     question.motion.orbit.yaw_inertia, 0, question.time, 1e-10, question.spin_scale))
    spins.push_back(sample.omega);
  return spins;
}

/// Friction under a load that may have no balance at @p omega; NaN there, with the reason in @p trouble.
ring::Wrench wrench_or_nan(const Question &question, const LoadAtSpin &load, double omega,
                           std::string &trouble)
{
  try
  {
    return question.wrench(load(omega), omega);
  }
  catch (const std::runtime_error &failure)
  {
    trouble = failure.what();
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    return { nan, nan, nan };
  }
}

TruncatedAnswer answer(const Question &question, const TruncatedLoad &load, unsigned int n)
{
  TruncatedAnswer answer;
  answer.harmonics = n;
  const ring::RingStack at_rest = load.kept(0);
  answer.amplitude = std::hypot(at_rest.a(n), at_rest.b(n)) / at_rest.a(0);
  answer.tau_at_rest = question.torque(at_rest, 0);
  answer.at_rest = negative_part(at_rest);
  for (const double omega : question.omega)
    answer.torque.push_back(wrench_or_nan(question, load.kept, omega, answer.trouble).torque);
  try
  {
    const double omega = ring::terminal_omega(torque_of(question, load.kept), question.spin_scale);
    answer.omega_terminal = omega;
    answer.load = load.kept(omega);
    answer.at_terminal = negative_part(*answer.load);
    answer.spin_up = spin_up(question, load, omega);
  }
  catch (const std::runtime_error &failure)
  {
    answer.trouble = failure.what();
  }
  return answer;
}

/// What relates an answer to that of all harmonics.
void relate(const Question &question, const TruncatedAnswer &all, const TruncatedLoad &load,
            TruncatedAnswer &answer)
{
  const double omega = *all.omega_terminal;
  // Without a moment the glass does not spin up; rounding makes that a tiny spin, to which nothing can be
  // related.
  if (answer.omega_terminal && std::abs(omega) > 1e-12 * question.spin_scale)
    answer.relative_change = (*answer.omega_terminal - omega) / omega + 0.; // no -0
  if (!answer.spin_up.empty())
  {
    double largest = 0;
    for (std::size_t i = 0; i < answer.spin_up.size(); ++i)
      largest = std::max(largest, std::abs(answer.spin_up[i] - all.spin_up[i]));
    answer.largest_deviation = largest;
    answer.final_deviation = std::abs(answer.spin_up.back() - all.spin_up.back());
  }
  try
  {
    answer.bound = question.friction().truncation_bound(load.whole(omega), answer.harmonics, omega,
                                                        question.motion.orbit.orbit_speed);
  }
  catch (const std::runtime_error &failure)
  {
    answer.trouble = failure.what();
  }
}

/// Spins from a little before rest to half as far again as the fastest terminal spin.
std::vector<double> shown_spins(const Question &question, const TruncationTable &table)
{
  constexpr int n_intervals = 120;
  double fastest = *table.all().omega_terminal;
  for (const TruncatedAnswer &answer : table.answers)
    if (answer.omega_terminal && std::abs(*answer.omega_terminal) > std::abs(fastest))
      fastest = *answer.omega_terminal;
  if (std::abs(fastest) < 0.01 * question.spin_scale) // a glass that hardly spins up
    fastest = std::copysign(0.1 * question.spin_scale, fastest);
  std::vector<double> spins;
  for (int i = -n_intervals / 8; i <= n_intervals; ++i)
    spins.push_back(1.5 * fastest * i / n_intervals);
  std::sort(spins.begin(), spins.end());
  return spins;
}

/// The load for a picture over these spins: interpolated where loads are costly, if it can be.
LoadAtSpin for_a_picture(const TruncatedLoad &load, const std::vector<double> &spins)
{
  if (!load.is_costly)
    return load.kept;
  try
  {
    return sample_load_curve(load.kept, spins.front(), spins.back(), 1e-4, 80).interpolate();
  }
  catch (const std::runtime_error &)
  {
    return load.kept; // kinks of lift-off, or spins without a balance
  }
}

/// Torques of 1, 2, 3 and all harmonics.
TorqueCurve torque_curves(const Question &question, const std::vector<TruncatedLoad> &loads,
                          const TruncationTable &table)
{
  TorqueCurve curve;
  std::string ignored; // the table has a word on what is missing
  curve.omega = shown_spins(question, table);
  const LoadAtSpin all = for_a_picture(loads.back(), curve.omega);
  for (const double omega : curve.omega)
  {
    curve.slip_ratio.push_back(omega / question.spin_scale);
    curve.friction.push_back(wrench_or_nan(question, all, omega, ignored));
  }
  for (std::size_t i = 0; i + 1 < loads.size() && table.answers[i].harmonics <= 3; ++i)
  {
    curve.harmonics.push_back(table.answers[i].harmonics);
    std::vector<double> &torques = curve.truncations.emplace_back();
    const LoadAtSpin load = for_a_picture(loads[i], curve.omega);
    for (const double omega : curve.omega)
      torques.push_back(wrench_or_nan(question, load, omega, ignored).torque);
  }
  return curve;
}

/// Throws std::runtime_error where all harmonics have no terminal spin or no spin-up.
TruncationTable tabulate(const Question &question, const TruncatedLoads &loads)
{
  TruncationTable table;
  std::vector<TruncatedLoad> kept;
  for (const unsigned int n : truncation_orders(question.n_all))
  {
    kept.push_back(loads(n));
    table.answers.push_back(answer(question, kept.back(), n));
    question.one_done();
  }
  const TruncatedAnswer all = table.all();
  if (!all.omega_terminal || all.spin_up.empty())
    throw std::runtime_error(all.trouble);
  for (std::size_t i = 0; i < kept.size(); ++i)
    relate(question, all, kept[i], table.answers[i]);
  table.torque = torque_curves(question, kept, table);
  return table;
}

std::vector<double> output_times(double end)
{
  constexpr unsigned int n_intervals = 200;
  std::vector<double> times;
  for (unsigned int i = 0; i <= n_intervals; ++i)
    times.push_back(end * i / n_intervals);
  return times;
}

/// The table of the contact in balance with the friction of its own load, cut off, where there is one.
void tabulate_balances(const Question &question, const Study &study, const StudyLoad &found,
                       TruncationStudy &result)
{
  if (!result.acts_back)
  {
    result.self_consistent = result.frozen;
    return;
  }
  try
  {
    result.self_consistent = tabulate(question, balanced_truncated_loads(study, found));
  }
  catch (const std::runtime_error &failure)
  {
    result.why_not = std::string("There is no balance with all harmonics: ") + failure.what() + ".";
  }
}

} // namespace

bool TruncatedAnswer::pulls() const
{
  return worst().minimum < 0;
}

NegativeLoad TruncatedAnswer::worst() const
{
  const NegativeLoad terminal = at_terminal.value_or(at_rest);
  return { std::min(at_rest.minimum, terminal.minimum),
           std::max(at_rest.pulling_share, terminal.pulling_share) };
}

TruncationStudy study_truncations(const Study &study, const StudyLoad &found, std::vector<double> omega,
                                  const TruncationProgress &progress)
{
  const RingLoad &load = found.load;
  const ring::Motion &orbit = study.motion.orbit;
  TruncationStudy result;
  result.time = output_times(study.motion.end_time);
  result.why_not = why_no_balance(study);
  result.acts_back = result.why_not.empty() && follows_spin(study);
  result.same_whole_load = !result.acts_back || load.coupling;
  result.closures = compare_closures(orbit, study.glass.profile.contact_radius);
  const unsigned int n_all = load.at_rest.n_harmonics();
  const std::size_t n_answers = truncation_orders(n_all).size() * (result.acts_back ? 2 : 1);
  const Question question = { study.motion,
                              orbit.orbit_speed / load.at_rest.radius(),
                              n_all,
                              result.omega,
                              result.time,
                              [&progress, n_answers, n_done = std::size_t(0)]() mutable
                              {
                                if (++n_done; progress)
                                  progress(n_done, n_answers);
                              } };
  const ring::TerminalSpin terminal =
    ring::terminal_spin(torque_of(question, load.at_spin), orbit.yaw_inertia, question.spin_scale);
  result.torque_slope = terminal.torque_slope;
  result.omega = omega.empty() ? std::vector<double>{ terminal.omega / 2, terminal.omega } : std::move(omega);
  // Truncations end near the terminal spin of all harmonics; beyond this margin their loads are exact.
  const double margin = 0.05 * std::abs(terminal.omega);
  const LoadAtSpin on_the_way =
    for_many_spins(load, std::min(0., terminal.omega - margin), std::max(0., terminal.omega + margin));
  result.frozen = tabulate(question, cut_off_loads(load, on_the_way));
  if (result.why_not.empty())
    tabulate_balances(question, study, found, result);
  return result;
}

} // namespace stemware::pipeline
