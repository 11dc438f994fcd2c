#include "fem/geometry/waviness.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace stemware::fem
{

namespace
{
double sum(const std::vector<GapHarmonic> &harmonics, double radius_ratio, double azimuth)
{
  double value = 0;
  for (const GapHarmonic &harmonic : harmonics)
    value += (harmonic.n == 1 ? radius_ratio : 1) * (harmonic.cosine * std::cos(harmonic.n * azimuth) +
                                                     harmonic.sine * std::sin(harmonic.n * azimuth));
  return value;
}
} // namespace

double RimImperfection::gap(double radius_ratio, double theta, const FootOrientation &phase) const
{
  return sum(glass, radius_ratio, theta - phase.glass) + sum(table, radius_ratio, theta - phase.table);
}

void RimImperfection::validate() const
{
  for (const auto *harmonics : { &glass, &table })
    for (const GapHarmonic &harmonic : *harmonics)
      if (!(std::isfinite(harmonic.cosine) && std::isfinite(harmonic.sine)))
        throw std::invalid_argument("The gap harmonic n = " + std::to_string(harmonic.n) +
                                    " has an amplitude that is not a finite length; give it in metres.");
}

} // namespace stemware::fem
