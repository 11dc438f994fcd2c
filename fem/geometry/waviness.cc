#include "fem/geometry/waviness.h"

#include "fem/geometry/require.h"

#include <cmath>

namespace stemware::fem
{

namespace
{
double sum(const std::vector<WavinessHarmonic> &harmonics, double radius_ratio, double azimuth)
{
  double value = 0;
  for (const WavinessHarmonic &harmonic : harmonics)
    value += (harmonic.n == 1 ? radius_ratio : 1) * harmonic.amplitude *
             std::cos(harmonic.n * (azimuth - harmonic.azimuth));
  return value;
}
} // namespace

double RimImperfection::gap(double radius_ratio, double theta, double of_glass, double of_table) const
{
  return sum(glass, radius_ratio, theta - of_glass) + sum(table, radius_ratio, theta - of_table);
}

double RimImperfection::max_amplitude() const
{
  double sum = 0;
  for (const auto &harmonics : { glass, table })
    for (const WavinessHarmonic &harmonic : harmonics)
      sum += std::abs(harmonic.amplitude);
  return sum;
}

void RimImperfection::validate() const
{
  for (const auto *harmonics : { &glass, &table })
    for (const WavinessHarmonic &harmonic : *harmonics)
      require(std::isfinite(harmonic.amplitude) && std::isfinite(harmonic.azimuth),
              "The waviness n = ", harmonic.n,
              " has an amplitude or azimuth that is not finite; give metres and radians.");
}

} // namespace stemware::fem
