#include "fem/pipeline/analysis/phase_study.h"

#include "ring_model/yaw_motion.h"

#include <algorithm>
#include <cmath>

namespace stemware::pipeline
{

namespace
{

ring::PhasedTorqueFunction torque_of(const PhaseLoads &loads, const ring::Motion &motion,
                                     unsigned int n_harmonics)
{
  const ring::CoulombRing friction(motion.friction_coefficient);
  return [&loads, motion, n_harmonics, friction](double time, double yaw_angle, double omega)
  {
    const ring::RingStack load = loads.at(omega, phase_of_marks(motion, time, yaw_angle));
    return friction.wrench(load.truncated(n_harmonics), omega, motion.orbit_speed).torque;
  };
}

double half_range(const std::vector<double> &values)
{
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return (*most - *least) / 2;
}

/// Time over which the mean spin is taken: a good dozen of the slowest repetition of the phase, which in a
/// glass that nearly follows its orbit may take for ever, and of the time in which the spin forgets its
/// start.
double window_of(const PhasePeriods &periods, const ring::Motion &motion, const ring::TerminalSpin &terminal)
{
  const double orbit = std::abs(motion.orbit_rate());
  double slowest = periods.table / orbit;
  if (periods.glass > 0)
    slowest = std::max(slowest,
                       periods.glass / std::max(std::abs(terminal.omega - motion.orbit_rate()), 0.1 * orbit));
  return std::max(16 * slowest, 8 * std::min(terminal.time_constant, 100 / orbit));
}

std::vector<double> torques_at(double omega, const PhaseLoads &loads, const ring::Motion &motion)
{
  const ring::CoulombRing friction(motion.friction_coefficient);
  std::vector<double> torques;
  for (const ring::RingStack &load : loads.samples(omega))
    torques.push_back(friction.wrench(load, omega, motion.orbit_speed).torque);
  return torques;
}

/// The worst of all phases instead of the mean load's.
void take_worst(TruncationRow &row, double omega, const PhaseLoads &loads, const ring::Motion &motion)
{
  const ring::CoulombRing friction(motion.friction_coefficient);
  for (const ring::RingStack &load : loads.samples(omega))
    row.bound =
      std::max(row.bound, friction.truncation_bound(load, row.harmonics, omega, motion.orbit_speed));
  for (const ring::RingStack &load : loads.samples(0))
    row.load_minimum = std::min(row.load_minimum, load.truncated(row.harmonics).minimum());
}

} // namespace

YawStudy study_yaw(const PhasedLoad &load, const PhasePeriods &periods, const ring::Motion &motion,
                   PhaseFigures &figures)
{
  constexpr double accuracy = 1e-9;
  const PhaseLoads &loads = *load.at_phase;
  const LoadAtSpin &mean = load.load.at_spin;
  YawStudy study = study_yaw(mean, motion);
  const double scale = spin_scale(load.load.at_rest, motion);
  const double window = window_of(periods, motion, study.terminal);
  figures.zero_of_mean_torque = study.terminal.omega;

  // From the zero of the mean torque, which is near.
  const auto long_time = [&](const TruncationRow &row)
  {
    return ring::long_time_spin(torque_of(loads, motion, row.harmonics), motion.yaw_inertia,
                                row.omega_terminal, window, accuracy, scale);
  };
  const ring::LongTimeSpin spin = long_time(study.truncations.back());
  study.terminal.omega = spin.mean;
  study.at_terminal =
    ring::CoulombRing(motion.friction_coefficient).wrench(mean(spin.mean), spin.mean, motion.orbit_speed);
  for (TruncationRow &row : study.truncations)
  {
    row.omega_terminal = &row == &study.truncations.back() ? spin.mean : long_time(row).mean;
    if (row.relative_change)
      row.relative_change = (row.omega_terminal - spin.mean) / spin.mean + 0.; // no -0
    take_worst(row, spin.mean, loads, motion);
  }

  figures.spin_ripple = spin.ripple;
  figures.spin_uncertainty = spin.uncertainty;
  figures.least_load = load.least_load;
  figures.least_contact_fraction = load.least_contact_fraction;
  figures.n_glass_phases = loads.phases().glass.size();
  figures.n_table_phases = loads.phases().table.size();
  figures.n_spins = loads.n_spins();
  figures.interpolation_error = loads.error();
  for (unsigned int i = 0; i < loads.phases().size(); ++i)
    figures.phases.push_back(loads.phases().phase(i));
  figures.torque_at_rest = torques_at(0, loads, motion);
  figures.torque_at_terminal = torques_at(spin.mean, loads, motion);
  figures.torque_ripple = half_range(figures.torque_at_terminal);
  return study;
}

SpinUpCurves spin_up_curves(const PhasedLoad &load, const MotionSection &motion)
{
  constexpr unsigned int n_intervals = 200;
  const ring::Motion &orbit = motion.orbit;
  const PhaseLoads &loads = *load.at_phase;
  const ring::RingStack &at_rest = load.load.at_rest;
  SpinUpCurves curves;
  for (unsigned int i = 0; i <= n_intervals; ++i)
    curves.time.push_back(motion.end_time * i / n_intervals);

  const auto follow = [&](unsigned int n_harmonics)
  {
    return ring::yaw_motion(torque_of(loads, orbit, n_harmonics), orbit.yaw_inertia, 0, curves.time, 1e-10,
                            spin_scale(at_rest, orbit));
  };
  for (const ring::YawSample &sample : follow(at_rest.n_harmonics()))
  {
    curves.adaptive.push_back(sample.omega);
    curves.yaw_angle.push_back(sample.yaw_angle);
  }
  for (const ring::YawSample &sample : follow(1))
    curves.first_harmonic.push_back(sample.omega);

  const unsigned int stride = euler_steps(motion, n_intervals);
  const unsigned int n_steps = stride * n_intervals;
  const auto samples = ring::yaw_motion_euler(torque_of(loads, orbit, at_rest.n_harmonics()),
                                              orbit.yaw_inertia, 0, motion.end_time / n_steps, n_steps);
  for (unsigned int i = 0; i <= n_intervals; ++i)
    curves.euler.push_back(samples[i * stride].omega);
  return curves;
}

} // namespace stemware::pipeline
