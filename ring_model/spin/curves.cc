#include "ring_model/spin/curves.h"

#include "ring_model/failures.h"
#include "ring_model/friction_functionals.h"
#include "ring_model/load/constants.h"
#include "ring_model/spin/phase_loads.h"
#include "ring_model/yaw_motion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>

namespace stemware::ring
{
namespace
{
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Returns friction plus lean torque [N m] as a function of time, angle and spin. It is constant beyond the
/// spin at which the glass tips (@p fall), because time steps may exceed this spin.
PhasedTorqueFunction torque_until(const std::optional<RingState> &fall, const Load &load,
                                  const Question &question)
{
  const double lower = fall ? std::min(0., fall->omega) : -HUGE_VAL,
               upper = fall ? std::max(0., fall->omega) : HUGE_VAL;
  const auto torque = [=, &load, &motion = question.motion](double time, double yaw_angle, double omega)
  {
    return yaw_torque(load, motion, std::clamp(omega, lower, upper),
                      orientation_of_marks(motion, time, yaw_angle));
  };
  return observed(torque, question.observer);
}

YawSample nan_after_tipping(YawSample sample, const std::optional<RingState> &fall)
{
  if (fall && std::abs(sample.omega) > std::abs(fall->omega))
    sample.omega = sample.yaw_angle = unknown;
  return sample;
}
} // namespace

std::vector<Torques> torque_curve(const Load &load, const Question &question,
                                  const std::vector<double> &spins, std::string *reason)
{
  std::vector<Torques> torques;
  for (const double omega : spins)
  {
    const auto find = [&] { return torques_at(load.at(omega), question, omega); };
    torques.push_back(
      find_or_nullopt(find, reason).value_or(Torques{ { unknown, unknown, unknown }, unknown, unknown }));
  }
  return torques;
}

std::vector<YawSample> spin_up(const Load &load, const Question &question, const std::vector<double> &times,
                               const std::optional<RingState> &fall)
{
  constexpr double accuracy = 1e-10; // accuracy of omega(t), relative to v / R
  std::vector<YawSample> samples =
    yaw_motion(torque_until(fall, load, question), question.motion.yaw_inertia, 0, times, accuracy,
               load.spin_scale(question.motion), question.grip_torque);
  for (YawSample &sample : samples)
    sample = nan_after_tipping(sample, fall);
  return samples;
}

std::vector<YawSample> euler_spin_up(const Load &load, const Question &question,
                                     const std::vector<double> &times, double longest,
                                     const std::optional<RingState> &fall)
{
  const auto n_intervals = static_cast<unsigned int>(times.size()) - 1;
  const double n_least = std::ceil(times.back() / n_intervals / longest - 1e-9);
  const unsigned int stride = std::max(static_cast<unsigned int>(n_least), 1u),
                     n_steps = stride * n_intervals;
  const std::vector<YawSample> samples =
    yaw_motion_euler(torque_until(fall, load, question), question.motion.yaw_inertia, 0,
                     times.back() / n_steps, n_steps, question.grip_torque);
  std::vector<YawSample> wanted;
  for (unsigned int i = 0; i <= n_intervals; ++i)
    wanted.push_back(nan_after_tipping(samples[i * stride], fall));
  return wanted;
}

PhasedTorqueFunction tabulated_torque(const Load &load, const Motion &motion, double middle, double reach,
                                      double tolerance)
{
  const PhaseGrids &grids = load.phases()->phases();
  // The load is a piecewise polynomial in the spin with kinks between the pieces. The table covers one piece.
  const auto [slowest, fastest] = load.phases()->polynomial_range(middle);
  const double lower = std::max(middle - reach, slowest), upper = std::min(middle + reach, fastest);
  const auto at_phases = [&](double omega)
  {
    Eigen::VectorXd torques(grids.size());
    Eigen::Index i = 0;
    for (const Sample &all : load.phases()->samples(omega))
      torques(i++) = yaw_torque(all.truncated(load.n_harmonics()), motion, omega);
    return torques;
  };
  const auto error = [](double, const Eigen::VectorXd &interpolated, const Eigen::VectorXd &exact)
  { return (interpolated - exact).lpNorm<Eigen::Infinity>(); };
  constexpr std::size_t max_samples = 100;
  std::shared_ptr<const AdaptiveCurve> table;
  if (lower < upper)
    table = std::make_shared<AdaptiveCurve>(CurveSource{ at_phases, error }, lower, upper,
                                            CurveTolerance{ tolerance, tolerance, max_samples, max_samples });
  if (table && table->error() > tolerance)
    table = nullptr;
  return [&load, &motion, &grids, table](double time, double yaw_angle, double omega)
  {
    const Orientation marks = orientation_of_marks(motion, time, yaw_angle);
    return table && table->covers(omega) ? grids.weights(marks).dot((*table)(omega))
                                         : yaw_torque(load, motion, omega, marks);
  };
}

std::vector<Instant> instants_of(const std::vector<YawSample> &spin_up, const Load &load,
                                 const Question &question)
{
  constexpr std::size_t n_intervals = 24;
  constexpr double near = 0.995; // fraction of the final spin at the last instant
  std::size_t n = 0;
  while (n < spin_up.size() && std::isfinite(spin_up[n].omega))
    ++n;
  std::vector<Instant> instants;
  if (n == 0)
    return instants;
  std::size_t last = 0;
  while (last + 1 < n && std::abs(spin_up[last].omega) < near * std::abs(spin_up[n - 1].omega))
    ++last;
  const std::size_t n_steps = std::min(n_intervals, last);
  for (std::size_t i = 0; i <= n_steps; ++i)
  {
    const YawSample &sample = spin_up[n_steps == 0 ? 0 : i * last / n_steps];
    instants.push_back({ sample, ring_state(load.at(sample.omega), question, sample.omega) });
  }
  return instants;
}

std::vector<double> torques_by_phase(const PhaseSampledLoad &phases, const Motion &motion, double omega)
{
  std::vector<double> torques;
  for (const RingStack &load : phases.samples(omega))
    torques.push_back(wrench(motion, load, omega).torque);
  return torques;
}

Load interpolated_for_curves(const Load &load, const Answer &found, double lower, double upper,
                             const Load *similar)
{
  const auto between = [&](double one, double other, const CurveTolerance &tolerance = {})
  {
    return find_or_nullopt(
      [&] { return load.interpolated(std::min(one, other), std::max(one, other), tolerance, similar); });
  };
  // The load changes steeply near the spin at which the glass tips. A tight tolerance would need too many
  // samples.
  CurveTolerance near_fall;
  near_fall.relaxed = 1e-3;
  if (found.fall)
    return between(0, found.fall->omega, near_fall).value_or(load);
  if (const std::optional<Load> curve = between(lower, upper))
    return *curve;
  const double terminal = found.omega_terminal().value_or(0), margin = 0.02 * std::abs(terminal);
  return between(std::min(0., terminal - margin), std::max(0., terminal + margin)).value_or(load);
}

std::vector<double> output_times(double end)
{
  constexpr unsigned int n_intervals = 200;
  std::vector<double> times;
  for (unsigned int i = 0; i <= n_intervals; ++i)
    times.push_back(end * i / n_intervals);
  return times;
}

std::vector<RimSlip> rim_slip(const Motion &motion, double radius, const RingStack &load, double omega)
{
  constexpr unsigned int n_places = 24;
  const double mean = motion.friction_at_rest() * load.a(0);
  std::vector<RimSlip> places;
  for (unsigned int i = 0; i < n_places; ++i)
  {
    const double theta = 2 * pi * i / n_places;
    const double slip_x = motion.orbit_speed - omega * radius * std::sin(theta),
                 slip_y = omega * radius * std::cos(theta), slip = std::hypot(slip_x, slip_y);
    const double share = slip > 0 ? -motion.friction_at(slip) * std::max(0., load(theta)) / (mean * slip) : 0;
    places.push_back(
      { theta, slip_x / motion.orbit_speed, slip_y / motion.orbit_speed, share * slip_x, share * slip_y });
  }
  return places;
}
} // namespace stemware::ring
