#include "fem/pipeline/analysis/spin_study.h"

#include "fem/pipeline/analysis/spin.h"
#include "fem/pipeline/coupling/driven_load.h"
#include "fem/pipeline/coupling/if_balanced.h"
#include "fem/pipeline/coupling/phase_loads.h"
#include "fem/pipeline/coupling/study_load.h"
#include "fem/pipeline/variants/model_variants.h"
#include "ring_model/friction_law.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stemware::pipeline
{

namespace
{

double half_range(const std::vector<double> &values)
{
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return (*most - *least) / 2;
}

std::vector<double> torques_at(double omega, const PhaseLoads &loads, const ring::Motion &motion)
{
  std::vector<double> torques;
  for (const ring::RingStack &load : loads.samples(omega))
    torques.push_back(ring::wrench(motion, load, omega).torque);
  return torques;
}

PhaseStudy study_phases(const PhaseLoads &loads, const SpinRow &row, const ring::Motion &motion)
{
  PhaseStudy study;
  study.spin_ripple = row.ripple;
  study.spin_uncertainty = row.spin_uncertainty;
  study.zero_of_mean_torque = row.zero_of_mean_torque;
  study.least_load = loads.at_rest_extremes().least_load;
  study.least_contact_fraction = loads.at_rest_extremes().least_contact_fraction;
  study.n_glass_phases = loads.phases().glass.size();
  study.n_table_phases = loads.phases().table.size();
  study.n_spins = loads.n_spins();
  study.interpolation_error = loads.error().between;
  for (unsigned int i = 0; i < loads.phases().size(); ++i)
    study.phases.push_back(loads.phases().phase(i));
  study.torque_at_rest = torques_at(0, loads, motion);
  study.torque_at_terminal = torques_at(row.last_spin().value(), loads, motion);
  study.torque_ripple = half_range(study.torque_at_terminal);
  return study;
}

/// Equal steps of the forward Euler method in each of @p n_intervals equal intervals of the spin-up.
unsigned int euler_steps(const MotionSection &motion, unsigned int n_intervals)
{
  const double n_steps = std::ceil(motion.end_time / n_intervals / motion.euler_step - 1e-9);
  return std::max(static_cast<unsigned int>(n_steps), 1u);
}

std::vector<double> spins_of(const std::vector<ring::YawSample> &samples)
{
  std::vector<double> spins;
  for (const ring::YawSample &sample : samples)
    spins.push_back(sample.omega);
  return spins;
}

/// omega(t) [rad/s] under @p load; nothing where it has no balance on the way.
std::vector<double> spins_or_nothing(const BalancedLoad &load, const Study &study,
                                     const std::vector<double> &times)
{
  return if_balanced([&]
                     { return spins_of(spin_up(load, study.motion.orbit, times, study.motion.grip_torque)); })
    .value_or(std::vector<double>());
}

/// @p torque between rest and @p fall, and the same from there on: steps of an integrator reach beyond.
ring::PhasedTorqueFunction up_to_the_fall(const ring::PhasedTorqueFunction &torque,
                                          const std::optional<Fall> &fall)
{
  if (!fall)
    return torque;
  const double lower = std::min(0., fall->omega), upper = std::max(0., fall->omega);
  return [=](double time, double yaw_angle, double omega)
  { return torque(time, yaw_angle, std::clamp(omega, lower, upper)); };
}

/// Leaves out what lies beyond @p fall.
double unless_fallen(double omega, const std::optional<Fall> &fall)
{
  return fall && std::abs(omega) > std::abs(fall->omega) ? std::nan("") : omega;
}

/// @p first and @p all are loads for curves; @p row is the answer to the latter.
SpinUpCurves spin_up_curves(const Study &study, const SharedLoad &first, const BalancedLoad &all,
                            const SpinRow &row)
{
  const ring::Motion &orbit = study.motion.orbit;
  const ring::PhasedTorqueFunction torque =
    up_to_the_fall(torque_function(all, orbit, study.motion.grip_torque), row.fall);
  SpinUpCurves curves;
  curves.time = output_times(study.motion.end_time);
  for (const ring::YawSample &sample : spin_up(torque, orbit, curves.time, all.spin_scale(orbit)))
  {
    curves.adaptive.push_back(unless_fallen(sample.omega, row.fall));
    curves.yaw_angle.push_back(std::isnan(curves.adaptive.back()) ? std::nan("") : sample.yaw_angle);
  }
  if (first)
    curves.first_harmonic = spins_or_nothing(*first, study, curves.time);

  const auto n_intervals = static_cast<unsigned int>(curves.time.size()) - 1;
  const unsigned int stride = euler_steps(study.motion, n_intervals);
  const unsigned int n_steps = stride * n_intervals;
  const auto samples =
    ring::yaw_motion_euler(torque, orbit.yaw_inertia, 0, study.motion.end_time / n_steps, n_steps);
  for (unsigned int i = 0; i <= n_intervals; ++i)
    curves.euler.push_back(unless_fallen(samples[i * stride].omega, row.fall));
  curves.paper = paper_spin_up(study, curves.time);
  return curves;
}

/// The torques on the ring at a spin; NaN where there is no balance: the row says what is missing.
RingState torques_or_nan(const BalancedLoad &load, const Study &study, double omega)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  SpinQuestion question = spin_question(study);
  question.with_minima = false;
  return if_balanced([&] { return ring_state(load, question, omega); })
    .value_or(RingState{ load.report().rings, { nan, nan, nan }, nan, nan });
}

/// All terminal spins, that which is reached from rest as @p all has it; nothing where the glass falls over.
std::vector<ring::TerminalSpin> terminal_spins_of(const Study &study, const BalancedLoad &load,
                                                  const SpinRow &all)
{
  if (!all.terminal || load.phases() ||
      (study.load.is_in_balance() && abilities(study.contact.body).is_collective))
    return {};
  const double unit = load.spin_scale(study.motion.orbit);
  const auto statistics = load.statistics();
  const double error = statistics ? statistics->interpolation_error.value_or(0) : 0;
  std::vector<ring::TerminalSpin> spins =
    all_terminal_spins(load, study.motion.orbit, study.motion.grip_torque);
  const auto is_reached = [&](const ring::TerminalSpin &spin)
  { return std::abs(spin.omega - all.terminal->omega) < std::max(1e-4, 10 * error) * unit; };
  spins.erase(std::remove_if(spins.begin(), spins.end(), is_reached), spins.end());
  spins.push_back(*all.terminal);
  std::sort(spins.begin(), spins.end(),
            [](const ring::TerminalSpin &a, const ring::TerminalSpin &b) { return a.omega < b.omega; });
  return spins;
}

/// The study on one ring of its foot; nothing where it has no other.
std::optional<Variant> variant_on_one_ring(const Study &study)
{
  if (!study.load.is_from_contact() || study.contact.rings == 1)
    return std::nullopt;
  Variant one_ring = { "one_ring", "one ring", study };
  one_ring.study.contact.rings = 1;
  one_ring.on_same_foot = one_ring.on_other_rings = true; // the contact of rest does not depend on the rings
  return one_ring;
}

SpinRow related_to_all(SpinRow one_ring, const SpinRow &all)
{
  one_ring.harmonics = all.harmonics;
  if (one_ring.terminal && all.relative_change)
    one_ring.relative_change = one_ring.terminal->omega / all.terminal->omega - 1;
  return one_ring;
}

} // namespace

std::optional<double> TorqueCurve::spin_unit() const
{
  for (std::size_t i = 0; i < omega.size(); ++i)
    if (std::abs(slip_ratio.at(i)) > 1e-6)
      return omega[i] / slip_ratio[i];
  return std::nullopt;
}

std::vector<double> shown_spins(const Study &study, const std::vector<LoadedRow> &rows)
{
  constexpr int n_intervals = 120;
  const SpinRow &all = rows.back().row;
  double last = 0;
  if (all.fall)
    last = all.fall->omega;
  else
  {
    double fastest = *all.omega_terminal();
    for (const LoadedRow &row : rows)
      if (std::abs(row.row.omega_terminal().value_or(0)) > std::abs(fastest))
        fastest = *row.row.omega_terminal();
    last = 1.5 * shown_spin(study, all, fastest);
  }
  if (last == 0) // it falls over as soon as it turns
    last = 1e-3 * spin_unit(study);
  std::vector<double> spins;
  for (int i = -n_intervals / 8; i <= n_intervals; ++i)
    spins.push_back(last * i / n_intervals);
  std::sort(spins.begin(), spins.end());
  return spins;
}

TorqueCurve torque_curve(const Study &study, const std::vector<LoadedRow> &rows, unsigned int n_most)
{
  const ring::Motion &motion = study.motion.orbit;
  TorqueCurve curve;
  curve.omega = shown_spins(study, rows);
  for (const double omega : curve.omega)
  {
    curve.slip_ratio.push_back(omega / rows.back().load->spin_scale(motion));
    const RingState state = torques_or_nan(*rows.back().load, study, omega);
    curve.friction.push_back(state.friction);
    curve.lean_torque.push_back(state.lean_torque);
    curve.grip_torque.push_back(state.grip_torque);
    curve.sum.push_back(state.torque());
  }
  for (std::size_t i = 0; i + 1 < rows.size() && rows[i].row.harmonics <= n_most; ++i)
  {
    if (!rows[i].load)
      continue;
    curve.harmonics.push_back(rows[i].row.harmonics);
    std::vector<double> &torques = curve.truncations.emplace_back();
    for (const double omega : curve.omega)
      torques.push_back(torques_or_nan(*rows[i].load, study, omega).friction.torque);
  }
  return curve;
}

std::vector<double> paper_spin_up(const Study &study, const std::vector<double> &times)
{
  const Study paper = paper_study(study);
  return spins_of(spin_up(*find_load(paper, nullptr), paper.motion.orbit, times));
}

/// omega(t) [rad/s] from rest at @p times while the hand leads the glass with @p speeds.
std::vector<double> driven_spins(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                                 const ring::OrbitSpeedTable &speeds, const std::vector<double> &times,
                                 double accuracy)
{
  const ring::PhasedTorqueFunction table_torque = driven_torque(study, foot, speeds);
  const auto torque = [&](double time, double yaw_angle, double omega)
  { return against_grip(table_torque(time, yaw_angle, omega), omega, study.motion.grip_torque); };
  return spins_of(
    ring::yaw_motion(torque, study.motion.orbit.yaw_inertia, 0, times, accuracy, spin_unit(study)));
}

std::optional<DrivenSpinUp> driven_spin_up(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                                           const std::vector<double> &times)
{
  if (!study.motion.orbit_speeds)
    return std::nullopt;
  // A contact is known to 1e-10 of its load: the step control is not to chase what lies below.
  const double accuracy = study.load.is_from_contact() ? 1e-9 : 1e-10;
  constexpr double accuracy_of_change = 1e-7; // acceleration jumps where lines meet
  const ring::OrbitSpeedTable &speeds = *study.motion.orbit_speeds;
  DrivenSpinUp driven;
  driven.time = times;
  for (const double time : times)
  {
    driven.speed.push_back(speeds.speed(time));
    driven.acceleration.push_back(speeds.acceleration(time));
  }
  driven.omega = driven_spins(study, foot, speeds, times, accuracy);
  const Study rigid = first_harmonic_study(study);
  const std::vector<double> cubic = driven_spins(rigid, nullptr, speeds, times, accuracy_of_change),
                            lines = driven_spins(rigid, nullptr, speeds.joined_by_lines(), times,
                                                 accuracy_of_change);
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    driven.interpolation_change_at_end = std::abs(lines[i] - cubic[i]);
    driven.interpolation_change = std::max(driven.interpolation_change, driven.interpolation_change_at_end);
  }
  return driven;
}

SpinStudy study_spin(const Study &study, const std::shared_ptr<ElasticFoot> &foot, const BalancedLoad &load,
                     const Executor &executor, Progress &progress, Depth depth)
{
  SpinStudy result;
  const std::optional<Variant> one_ring = variant_on_one_ring(study);
  RowsBeside models = { [&](const SpinRow &all)
                        {
                          std::vector<Variant> variants = budget_variants(study, all);
                          if (one_ring)
                            variants.push_back(*one_ring);
                          return variants;
                        } };
  const auto solve = [&]
  {
    return rows_by_harmonics(study, foot, load, spin_question(study), executor, progress, depth,
                             depth == Depth::full ? &models : nullptr);
  };
  std::vector<LoadedRow> solved = solve();
  std::vector<double> shown = shown_spins(study, solved);
  const auto interpolate = [&](unsigned int n_most)
  { interpolate_loads(shown.front(), shown.back(), n_most, executor, solved); };
  interpolate(0); // the first harmonic's curve is told by how it differs from that of all
  // The curve may meet a fall that the search has stepped over, and that of the next one another.
  constexpr unsigned int most_falls = 8;
  for (unsigned int i = 0; i < most_falls && load.fall_before(solved.back().row.last_spin().value_or(0)); ++i)
  {
    solved = solve();
    shown = shown_spins(study, solved);
    interpolate(0);
  }
  for (const LoadedRow &row : solved)
    result.rows.push_back(row.row);
  if (load.phases())
    result.phases = study_phases(*load.phases(), result.all(), study.motion.orbit);
  if (one_ring && depth == Depth::full)
  {
    result.one_ring = related_to_all(models.answers.back().row, result.all());
    models.answers.pop_back();
  }

  const SharedLoad all = solved.back().load;
  if (const auto statistics = all->statistics())
    result.curve_error = statistics->interpolation_error;
  const auto curves_and_scan = [&](std::size_t i)
  {
    if (i == 0)
      result.terminal_spins = terminal_spins_of(study, *all, result.all());
    else
      interpolate(1);
  };
  executor.for_each(2, curves_and_scan, is_collective(study));
  if (depth == Depth::full)
    result.budget = find_budget(study, solved, models.answers, executor);
  else
    result.budget.harmonics =
      harmonic_effect(result.rows.front().omega_terminal(), result.all().omega_terminal(), spin_scale(study));
  result.torque = torque_curve(study, solved, 1);
  result.spin_up = spin_up_curves(study, solved.front().load, *solved.back().load, result.all());
  result.spin_up.driven = driven_spin_up(study, foot, result.spin_up.time);
  return result;
}

} // namespace stemware::pipeline
