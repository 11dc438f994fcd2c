#include "fem/geometry/elastic_material.h"

#include "fem/geometry/require.h"

#include <cmath>

namespace stemware::fem
{

void ElasticMaterial::validate() const
{
  require(std::isfinite(young_modulus) && young_modulus > 0, "Young modulus = ", young_modulus,
          " Pa is not allowed; give a finite number greater than 0 (soda-lime glass: 70e9).");
  require(poisson_ratio > -1 && poisson_ratio < 0.5, "Poisson ratio = ", poisson_ratio,
          " is not allowed; give a number above -1 and below 0.5 (soda-lime glass: 0.22).");
}

} // namespace stemware::fem
