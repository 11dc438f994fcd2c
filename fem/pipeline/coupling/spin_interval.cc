#include "fem/pipeline/coupling/spin_interval.h"

#include <boost/math/constants/constants.hpp>

#include <cmath>
#include <stdexcept>

namespace stemware::pipeline
{

SpinInterval::SpinInterval(double lower, double upper, unsigned int n_steps)
    : lower(lower)
    , upper(upper)
    , n_steps(n_steps)
{
  if (!(lower < upper) || n_steps == 0)
    throw std::logic_error("an interval of spins has two ends and at least one step");
}

double SpinInterval::at(double place) const
{
  const double share = (1 - std::cos(boost::math::double_constants::pi * place / n_steps)) / 2;
  return lower * (1 - share) + upper * share;
}

Eigen::VectorXd SpinInterval::weights(double omega) const
{
  Eigen::VectorXd values(size());
  for (unsigned int k = 0; k <= n_steps; ++k)
  {
    const double distance = omega - node(k);
    if (distance == 0)
      return Eigen::VectorXd::Unit(size(), k);
    values(k) = (k % 2 == 0 ? 1. : -1.) * (k == 0 || k == n_steps ? 0.5 : 1.) / distance;
  }
  return values / values.sum();
}

std::vector<double> SpinInterval::nodes() const
{
  std::vector<double> spins;
  for (unsigned int i = 0; i < size(); ++i)
    spins.push_back(node(i));
  return spins;
}

std::vector<double> SpinInterval::between() const
{
  std::vector<double> spins;
  for (unsigned int k = 0; k < n_steps; ++k)
    spins.push_back(at(k + 0.5));
  return spins;
}

} // namespace stemware::pipeline
