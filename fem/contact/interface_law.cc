#include "fem/contact/interface_law.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace stemware::fem
{

void require_positive(const char *name, double value, const char *unit, const char *example)
{
  if (std::isfinite(value) && value > 0)
    return;
  std::ostringstream message;
  message << name << " = " << value << " " << unit << " is not allowed; give a finite number greater than 0 ("
          << example << ").";
  throw std::invalid_argument(message.str());
}

} // namespace stemware::fem
