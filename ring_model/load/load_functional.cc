#include "ring_model/load/load_functional.h"

#include "ring_model/load/require.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace stemware::ring
{
double LoadFunctional::operator()(const RingStack &load) const
{
  const std::vector<RingStack::Ring> &rings = load.rings();
  require(rings.size() == a.size(), "the load has ", rings.size(), " rings, but the functional has ",
          a.size());
  double sum = 0.;
  for (std::size_t j = 0; j < a.size(); ++j)
  {
    const std::size_t n_common = std::min(a[j].size(), rings[j].a.size());
    for (std::size_t n = 0; n < n_common; ++n)
      sum += a[j][n] * rings[j].a[n] + b[j][n] * rings[j].b[n];
  }
  return sum;
}

LoadFunctional LoadFunctional::of_rotated(double angle) const
{
  LoadFunctional result = *this;
  for (std::size_t j = 0; j < a.size(); ++j)
    for (std::size_t n = 0; n < a[j].size(); ++n)
    {
      const double turn = static_cast<double>(n) * angle, cosine = std::cos(turn), sine = std::sin(turn);
      result.a[j][n] = a[j][n] * cosine + b[j][n] * sine;
      result.b[j][n] = b[j][n] * cosine - a[j][n] * sine;
    }
  return result;
}

LoadFunctional operator*(double factor, LoadFunctional functional)
{
  for (auto *part : { &functional.a, &functional.b })
    for (std::vector<double> &ring : *part)
      for (double &coefficient : ring)
        coefficient *= factor;
  return functional;
}

LoadFunctional operator+(LoadFunctional one, const LoadFunctional &other)
{
  for (std::size_t j = 0; j < one.a.size(); ++j)
    for (std::size_t n = 0; n < one.a[j].size(); ++n)
    {
      one.a[j][n] += other.a[j][n];
      one.b[j][n] += other.b[j][n];
    }
  return one;
}
} // namespace stemware::ring
