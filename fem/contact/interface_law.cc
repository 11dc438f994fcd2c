#include "fem/contact/interface_law.h"

#include "fem/geometry/require.h"

#include <cmath>

namespace stemware::fem
{

void require_positive(const char *name, double value, const char *unit, const char *example)
{
  require(std::isfinite(value) && value > 0, name, " = ", value, " ", unit,
          " is not allowed; give a finite number greater than 0 (", example, ").");
}

} // namespace stemware::fem
