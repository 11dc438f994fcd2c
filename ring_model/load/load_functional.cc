#include "ring_model/load/load_functional.h"

#include "ring_model/load/require.h"

#include <algorithm>
#include <cstddef>

namespace stemware::ring
{
double LoadFunctional::operator()(const RingStack &load) const
{
  const std::vector<RingStack::Ring> &rings = load.rings();
  require(rings.size() == static_cast<std::size_t>(a.cols()), "the load has ", rings.size(),
          " rings, but the functional has ", a.cols());
  double sum = 0.;
  for (std::size_t j = 0; j < rings.size(); ++j)
    for (Eigen::Index n = 0; n < std::min<Eigen::Index>(a.rows(), load.n_harmonics() + 1); ++n)
      sum += a(n, j) * rings[j].a[n] + b(n, j) * rings[j].b[n];
  return sum;
}

LoadFunctional LoadFunctional::of_rotated(double angle) const
{
  const Eigen::ArrayXd turn =
    angle * Eigen::ArrayXd::LinSpaced(a.rows(), 0., static_cast<double>(a.rows() - 1));
  const Eigen::ArrayXd cosine = turn.cos(), sine = turn.sin();
  return { a.colwise() * cosine + b.colwise() * sine, b.colwise() * cosine - a.colwise() * sine };
}
} // namespace stemware::ring
