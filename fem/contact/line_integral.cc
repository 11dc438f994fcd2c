#include "fem/contact/line_integral.h"

#include <boost/math/quadrature/gauss.hpp>

#include <cmath>

namespace stemware::fem
{

namespace
{
/// Finds the roots of c0 + c1 x + c2 x^2 in (-1, 1), ascending, without cancellation. Returns their number.
unsigned int interior_roots(double c0, double c1, double c2, std::array<double, 2> &roots)
{
  const double discriminant = c1 * c1 - 4 * c2 * c0;
  if (!(discriminant > 0))
    return 0;
  const double q = -(c1 + std::copysign(std::sqrt(discriminant), c1)) / 2;
  const std::array<double, 2> candidates = { c2 != 0 ? q / c2 : 2., q != 0 ? c0 / q : 2. };
  unsigned int n_roots = 0;
  for (const double candidate : candidates)
    if (candidate > -1 && candidate < 1)
      roots[n_roots++] = candidate;
  if (n_roots == 2 && roots[0] > roots[1])
    std::swap(roots[0], roots[1]);
  return n_roots;
}
} // namespace

// Defined here so that Boost's slow header is compiled only once.
template <unsigned int n_points>
const std::vector<double>
  GaussRule<n_points>::abscissas = boost::math::quadrature::gauss<double, n_points>::abscissa();
template <unsigned int n_points>
const std::vector<double>
  GaussRule<n_points>::weights = boost::math::quadrature::gauss<double, n_points>::weights();

template struct GaussRule<2>;
template struct GaussRule<4>;
template struct GaussRule<6>;

PositiveSegments::PositiveSegments(const Eigen::Vector3d &samples)
{
  // A quadratic does not exceed its largest Bezier control point. This check skips most (unloaded) lines.
  const double control = 2 * samples(1) - (samples(0) + samples(2)) / 2;
  if (samples(0) <= 0 && samples(2) <= 0 && control <= 0)
    return;
  const Eigen::Vector3d coefficients = quadratic_through(samples);
  std::array<double, 2> roots{};
  const unsigned int n_roots = interior_roots(coefficients(0), coefficients(1), coefficients(2), roots);

  double begin = -1;
  for (unsigned int i = 0; i <= n_roots; ++i)
  {
    const double end = i < n_roots ? roots[i] : 1;
    if (value_at(coefficients, (begin + end) / 2) > 0)
      segments[n_segments++] = { begin, end };
    begin = end;
  }
}

} // namespace stemware::fem
