#include "fem/pipeline/analysis/yaw_study.h"

#include "ring_model/yaw_dynamics.h"
#include "ring_model/yaw_motion.h"

#include <algorithm>
#include <cmath>

namespace stemware::pipeline
{

namespace
{

ring::TorqueFunction torque_of(const LoadAtSpin &load, const ring::Motion &motion, unsigned int n_harmonics)
{
  const ring::CoulombRing friction(motion.friction_coefficient);
  return [=](double omega)
  { return friction.wrench(load(omega).truncated(n_harmonics), omega, motion.orbit_speed).torque; };
}

} // namespace

double spin_scale(const ring::RingStack &load, const ring::Motion &motion)
{
  return motion.orbit_speed / load.radius();
}

std::vector<unsigned int> truncation_orders(unsigned int n_all)
{
  std::vector<unsigned int> orders;
  for (const unsigned int n : { 1u, 2u, 3u })
    if (n < n_all)
      orders.push_back(n);
  for (unsigned int octave = 4; octave < n_all; octave *= 2)
    for (const unsigned int n : { octave, octave + octave / 2 })
      if (n < n_all)
        orders.push_back(n);
  orders.push_back(n_all);
  return orders;
}

ring::TerminalSpin truncated_terminal_spin(const LoadAtSpin &load, const ring::Motion &motion,
                                           unsigned int n_harmonics)
{
  return ring::terminal_spin(torque_of(load, motion, n_harmonics), motion.yaw_inertia,
                             spin_scale(load(0), motion));
}

YawStudy study_yaw(const LoadAtSpin &load, const ring::Motion &motion)
{
  const ring::CoulombRing friction(motion.friction_coefficient);
  const ring::RingStack at_rest = load(0);
  const double scale = spin_scale(at_rest, motion);
  const unsigned int n_all = at_rest.n_harmonics();

  YawStudy study;
  study.terminal = ring::terminal_spin(torque_of(load, motion, n_all), motion.yaw_inertia, scale);
  const double omega = study.terminal.omega;
  study.at_rest = friction.wrench(at_rest, 0, motion.orbit_speed);
  study.at_terminal = friction.wrench(load(omega), omega, motion.orbit_speed);
  if (std::isfinite(study.terminal.time_constant))
    study.time_constant = study.terminal.time_constant;

  // Without a moment the glass does not spin up; rounding makes that a tiny spin, to which nothing can be
  // related.
  const bool spins = std::abs(omega) > 1e-12 * scale;
  for (const unsigned int n : truncation_orders(n_all))
  {
    TruncationRow row;
    row.harmonics = n;
    row.tau_at_rest = friction.wrench(at_rest.truncated(n), 0, motion.orbit_speed).torque;
    row.omega_terminal = n == n_all ? omega : ring::terminal_omega(torque_of(load, motion, n), scale);
    if (spins)
      row.relative_change = (row.omega_terminal - omega) / omega + 0.; // no -0
    row.bound = friction.truncation_bound(load(omega), n, omega, motion.orbit_speed);
    row.load_minimum = at_rest.truncated(n).minimum();
    study.truncations.push_back(row);
  }
  return study;
}

TorqueCurve torque_curve(const LoadAtSpin &load, const ring::Motion &motion)
{
  constexpr int n_half = 120;
  const ring::CoulombRing friction(motion.friction_coefficient);
  const ring::RingStack at_rest = load(0);
  TorqueCurve curve;
  for (int i = -n_half; i <= n_half; ++i)
  {
    // Multiples of an exact step from the middle: the curve is sampled at rest, and symmetrically.
    const double slip_ratio = 1.5 * i / n_half;
    curve.slip_ratio.push_back(slip_ratio);
    curve.omega.push_back(slip_ratio * spin_scale(at_rest, motion));
    curve.friction.push_back(
      friction.wrench(load(curve.omega.back()), curve.omega.back(), motion.orbit_speed));
  }
  curve.harmonics = truncation_orders(at_rest.n_harmonics());
  curve.harmonics.pop_back();
  for (const unsigned int n : curve.harmonics)
  {
    const ring::TorqueFunction torque = torque_of(load, motion, n);
    std::vector<double> &torques = curve.truncations.emplace_back();
    for (const double omega : curve.omega)
      torques.push_back(torque(omega));
  }
  return curve;
}

unsigned int euler_steps(const MotionSection &motion, unsigned int n_intervals)
{
  const double n_steps = std::ceil(motion.end_time / n_intervals / motion.euler_step - 1e-9);
  return std::max(static_cast<unsigned int>(n_steps), 1u);
}

SpinUpCurves spin_up_curves(const LoadAtSpin &load, const MotionSection &motion, const LoadAtSpin &beside)
{
  constexpr unsigned int n_intervals = 200;
  const ring::Motion &orbit = motion.orbit;
  const ring::RingStack at_rest = load(0);
  SpinUpCurves curves;
  for (unsigned int i = 0; i <= n_intervals; ++i)
    curves.time.push_back(motion.end_time * i / n_intervals);

  const LoadAtSpin &load_beside = beside ? beside : load;
  const auto adaptive = [&](const LoadAtSpin &at_spin, unsigned int n_harmonics)
  {
    const ring::TorqueFunction torque = torque_of(at_spin, orbit, n_harmonics);
    std::vector<double> spins;
    for (const auto &sample :
         ring::spin_up([&](double, double omega) { return torque(omega); }, orbit.yaw_inertia, 0, curves.time,
                       1e-10, spin_scale(at_rest, orbit)))
      spins.push_back(sample.omega);
    return spins;
  };
  curves.adaptive = adaptive(load, at_rest.n_harmonics());
  curves.first_harmonic = adaptive(load_beside, 1);
  const ring::TorqueFunction torque = torque_of(load_beside, orbit, at_rest.n_harmonics());
  for (const auto &sample :
       ring::yaw_motion([&](double, double, double omega) { return torque(omega); }, orbit.yaw_inertia, 0,
                        curves.time, 1e-10, spin_scale(at_rest, orbit)))
    curves.yaw_angle.push_back(sample.yaw_angle);

  const unsigned int stride = euler_steps(motion, n_intervals);
  const unsigned int n_steps = stride * n_intervals;
  const auto samples = ring::spin_up_euler(torque_of(load_beside, orbit, at_rest.n_harmonics()),
                                           orbit.yaw_inertia, 0, motion.end_time / n_steps, n_steps);
  for (unsigned int i = 0; i <= n_intervals; ++i)
    curves.euler.push_back(samples[i * stride].omega);
  return curves;
}

} // namespace stemware::pipeline
