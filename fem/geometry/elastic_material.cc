#include "fem/geometry/elastic_material.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace stemware::fem
{

void ElasticMaterial::validate() const
{
  std::ostringstream message;
  if (!(std::isfinite(young_modulus) && young_modulus > 0))
    message << "Young modulus = " << young_modulus
            << " Pa is not allowed; give a finite number greater than 0 (soda-lime glass: 70e9).";
  else if (!(poisson_ratio > -1 && poisson_ratio < 0.5))
    message << "Poisson ratio = " << poisson_ratio
            << " is not allowed; give a number above -1 and below 0.5 (soda-lime glass: 0.22).";
  if (!message.str().empty())
    throw std::invalid_argument(message.str());
}

} // namespace stemware::fem
