#include "fem/pipeline/analysis/spin_up.h"

#include "ring_model/yaw_motion.h"

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace stemware::pipeline
{

namespace
{

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

std::vector<ring::YawSample> samples_of(const SpinUpTorque &torque, double spin_scale, double step)
{
  constexpr double accuracy = 1e-10;
  std::vector<double> times;
  for (int i = 0; i <= SpinUp::n_steps; ++i)
    times.push_back(i * step);
  return ring::yaw_motion([&](double, double, double omega) { return torque(omega); }, torque.yaw_inertia, 0,
                          times, accuracy, spin_scale);
}

std::vector<double> values_of(const std::vector<ring::YawSample> &samples, double ring::YawSample::*value)
{
  std::vector<double> values;
  for (const ring::YawSample &sample : samples)
    values.push_back(sample.*value);
  return values;
}

/// Values at the Chebyshev points to coefficients of the polynomials, without those that are rounding.
VectorXd coefficients_of(const VectorXd &values)
{
  static const MatrixXd transform = []
  {
    constexpr Index n = TorqueBySpin::n_points - 1;
    MatrixXd cosines(n + 1, n + 1);
    for (Index k = 0; k <= n; ++k)
      for (Index i = 0; i <= n; ++i)
      {
        const double ends = (k == 0 || k == n ? 0.5 : 1) * (i == 0 || i == n ? 0.5 : 1);
        // The points ascend, so that point i has the angle pi (n - i) / n.
        cosines(k, i) = 2. / static_cast<double>(n) * ends *
                        std::cos(boost::math::double_constants::pi * static_cast<double>(k * (n - i)) /
                                 static_cast<double>(n));
      }
    return cosines;
  }();
  VectorXd coefficients = transform * values;
  const double negligible = 1e-13 * coefficients.lpNorm<Eigen::Infinity>();
  Index n = coefficients.size();
  while (n > 1 && std::abs(coefficients(n - 1)) <= negligible)
    --n;
  return coefficients.head(n);
}

/// Coefficients of the derivative of a sum of Chebyshev polynomials.
VectorXd derivative(const VectorXd &coefficients)
{
  const Index n = coefficients.size();
  VectorXd slopes = VectorXd::Zero(n + 2);
  for (Index k = n - 1; k >= 1; --k)
    slopes(k - 1) = slopes(k + 1) + 2. * static_cast<double>(k) * coefficients(k);
  slopes(0) /= 2;
  return slopes.head(std::max<Index>(n - 1, 1));
}

/// Sum of Chebyshev polynomials at @p x, by Clenshaw's recurrence.
double sum_of(const VectorXd &coefficients, double x)
{
  double above = 0, next = 0;
  for (Index k = coefficients.size() - 1; k >= 1; --k)
  {
    const double now = 2 * x * next - above + coefficients(k);
    above = next;
    next = now;
  }
  return x * next - above + coefficients(0);
}

} // namespace

const VectorXd &TorqueBySpin::shares()
{
  static const VectorXd points = []
  {
    VectorXd shares(n_points);
    for (Index i = 0; i < n_points; ++i)
      shares(i) = (1 - std::cos(boost::math::double_constants::pi * static_cast<double>(i) /
                                static_cast<double>(n_points - 1))) /
                  2;
    return shares;
  }();
  return points;
}

TorqueBySpin::TorqueBySpin(double last, const VectorXd &values)
    : last(last)
    , coefficients(coefficients_of(values))
    , of_slope(derivative(coefficients))
{
}

double TorqueBySpin::operator()(double omega) const
{
  return sum_of(coefficients, std::clamp(2 * omega / last - 1, -1., 1.));
}

double TorqueBySpin::slope(double omega) const
{
  return 2 / last * sum_of(of_slope, std::clamp(2 * omega / last - 1, -1., 1.));
}

SpinCourse::SpinCourse(const std::vector<double> &spins, const std::vector<double> &angles, double step)
    : end(step * static_cast<double>(spins.size() - 1))
    , last_spin(spins.back())
    , last_angle(angles.back())
    , of_spin(spins.begin(), spins.end(), 0., step)
    , of_angle(angles.begin(), angles.end(), 0., step)
{
}

double SpinUpTorque::operator()(double omega) const
{
  const double torque = free(omega);
  return torque + ring::grip_torque(torque, omega, grip);
}

SpinUp::SpinUp(const SpinUpTorque &torque, double spin_scale, double step)
    : SpinUp(torque, samples_of(torque, spin_scale, step), step)
{
}

SpinUp::SpinUp(const SpinUpTorque &torque, const std::vector<ring::YawSample> &samples, double step)
    : SpinCourse(values_of(samples, &ring::YawSample::omega), values_of(samples, &ring::YawSample::yaw_angle),
                 step)
    , given(torque)
    , step(step)
{
}

SpinCourse SpinUp::derivative(const std::function<double(double omega)> &torque_change) const
{
  // Of (spin, angle): d/dt (s, a) = (slope s + change, s).
  struct Rate
  {
    double slope, change;
    double at(double s) const { return slope * s + change; }
  };
  const auto rate_at = [&](double time) -> Rate
  {
    const double omega = spin(time);
    return { given.free.slope(omega) / given.yaw_inertia, torque_change(omega) / given.yaw_inertia };
  };
  const bool turns = given(0) != 0; // the grip does not hold it
  std::vector<double> spins = { 0 }, angles = { 0 };
  Rate from = rate_at(0);
  for (int i = 0; i < n_steps; ++i)
  {
    const Rate middle = rate_at((i + 0.5) * step), to = rate_at((i + 1) * step);
    const double s = spins.back(), r1 = from.at(s), r2 = middle.at(s + step / 2 * r1),
                 r3 = middle.at(s + step / 2 * r2), r4 = to.at(s + step * r3);
    spins.push_back(turns ? s + step / 6 * (r1 + 2 * r2 + 2 * r3 + r4) : 0);
    angles.push_back(turns ? angles.back() + step * s + step * step / 6 * (r1 + r2 + r3) : 0);
    from = to;
  }
  return { spins, angles, step };
}

} // namespace stemware::pipeline
