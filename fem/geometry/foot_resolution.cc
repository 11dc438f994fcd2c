#include "fem/geometry/foot_mesh.h"

#include <sstream>
#include <stdexcept>

namespace stemware::fem
{

void FootResolution::validate() const
{
  std::ostringstream message;
  if (azimuthal_cells < 8 || azimuthal_cells % 4 != 0)
    message << "Contact/Azimuthal cells = " << azimuthal_cells
            << " is not allowed; give a multiple of 4, at least 8.";
  else if (radial_cells < 2 || radial_cells % 2 != 0)
    message << "Contact/Radial cells = " << radial_cells
            << " is not allowed; give an even number, at least 2.";
  else if (foot_layers < 1)
    message << "Contact/Foot layers = " << foot_layers << " is not allowed; give at least 1.";
  if (!message.str().empty())
    throw std::invalid_argument(message.str());
}

} // namespace stemware::fem
