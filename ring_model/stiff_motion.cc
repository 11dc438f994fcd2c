#include "ring_model/stiff_motion.h"

#include "ring_model/failures.h"
#include "ring_model/load/require.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace stemware::ring
{
StiffMotion::StiffMotion(PhasedTorqueFunction torque, double yaw_inertia, double accuracy, double spin_scale)
    : torque(std::move(torque))
    , yaw_inertia(yaw_inertia)
    , accuracy(accuracy)
    , spin_scale(spin_scale)
{
}

bool StiffMotion::is_stiff(const YawSample &start, double end, std::size_t n_times) const
{
  // Number of time constants per output above which implicit steps are cheaper: an implicit step costs about
  // 30 torque evaluations, and stable explicit steps need about two evaluations per time constant.
  constexpr double min_time_constants = 20.;
  // The torque may jump at spin 0, so the slope is taken on the side towards which the glass turns.
  YawSample beside = start;
  beside.omega += std::copysign(2e-5 * spin_scale, torque(start.time, start.yaw_angle, start.omega));
  return -slopes(beside).spin / yaw_inertia * end > min_time_constants * static_cast<double>(n_times);
}

YawSample StiffMotion::after_step(const YawSample &state, double end, double &step) const
{
  constexpr double safety = 0.9, max_growth = 5., max_shrinkage = 0.2;
  for (;;)
  {
    const bool is_last = state.time + 1.01 * step >= end;
    const double tried = is_last ? end - state.time : step;
    const Slopes slope = slopes(state);
    if (state.time + tried == state.time)
      throw NoBalance(sentence("the spin follows its torque with a time constant of ",
                               -yaw_inertia / slope.spin, " s and was not found beyond t = ", state.time,
                               " s; increase the yaw inertia"));
    const std::optional<YawSample> whole = collocated(state, slope, tried);
    std::optional<YawSample> halves = collocated(state, slope, tried / 2.);
    if (halves)
      halves = collocated(*halves, slope, tried / 2.);
    const double error =
      whole && halves ? relative_difference(*whole, *halves) : std::numeric_limits<double>::infinity();
    const double growth =
      std::clamp(safety * std::pow(error, -1. / 6.), max_shrinkage, max_growth); // local error O(h^6)
    if (!is_last || growth < 1.)
      step = tried * growth;
    if (error > 1.)
      continue;
    if (is_last)
      halves->time = end;
    return *halves;
  }
}

YawSample StiffMotion::within_step(const YawSample &state, double step) const
{
  const std::optional<YawSample> found = collocated(state, slopes(state), step);
  if (!found)
    throw NoBalance(sentence("the spin was not found beyond t = ", state.time, " s"));
  return *found;
}

StiffMotion::Slopes StiffMotion::slopes(const YawSample &at) const
{
  constexpr double angle_step = 1e-5;
  const double spin_step = 1e-5 * spin_scale;
  return { (torque(at.time, at.yaw_angle + angle_step, at.omega) -
            torque(at.time, at.yaw_angle - angle_step, at.omega)) /
             (2. * angle_step),
           (torque(at.time, at.yaw_angle, at.omega + spin_step) -
            torque(at.time, at.yaw_angle, at.omega - spin_step)) /
             (2. * spin_step) };
}

double StiffMotion::relative_difference(const YawSample &a, const YawSample &b) const
{
  return std::max(std::abs(a.yaw_angle - b.yaw_angle) / (1. + std::abs(b.yaw_angle)),
                  std::abs(a.omega - b.omega) / (spin_scale + std::abs(b.omega))) /
         accuracy;
}

std::optional<YawSample> StiffMotion::collocated(const YawSample &start, const Slopes &slope,
                                                 double step) const
{
  static const double root = std::sqrt(6.);
  static const Eigen::Vector3d nodes((4. - root) / 10., (4. + root) / 10., 1.);
  static const Eigen::Matrix3d weights = []
  {
    Eigen::Matrix3d a;
    a << (88. - 7. * root) / 360., (296. - 169. * root) / 1800., (-2. + 3. * root) / 225., //
      (296. + 169. * root) / 1800., (88. + 7. * root) / 360., (-2. - 3. * root) / 225.,    //
      (16. - root) / 36., (16. + root) / 36., 1. / 9.;
    return a;
  }();
  static const Eigen::Matrix3d differences = weights.inverse();
  constexpr unsigned int max_increments = 12;
  const Eigen::Matrix3d inertia = yaw_inertia / step * differences;
  const Eigen::PartialPivLU<Eigen::Matrix3d> newton(inertia - slope.spin * Eigen::Matrix3d::Identity() -
                                                    slope.angle * step * weights);
  Eigen::Vector3d spins = Eigen::Vector3d::Constant(start.omega);
  for (unsigned int n = 0; n < max_increments; ++n)
  {
    const Eigen::Vector3d turned = step * (weights * spins);
    Eigen::Vector3d residual = -inertia * (spins.array() - start.omega).matrix();
    for (unsigned int i = 0; i < 3; ++i)
      residual(i) += torque(start.time + nodes(i) * step, start.yaw_angle + turned(i), spins(i));
    const Eigen::Vector3d increment = newton.solve(residual);
    spins += increment;
    if (!spins.allFinite())
      return std::nullopt;
    if (increment.lpNorm<Eigen::Infinity>() <= 0.03 * accuracy * spin_scale)
      return YawSample{ start.time + step, start.yaw_angle + step * weights.row(2).dot(spins), spins(2) };
  }
  return std::nullopt;
}
} // namespace stemware::ring
