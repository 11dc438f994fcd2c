// The thin elastic mat: pressure proportional to penetration, never tension.
#include "fem/contact/pressure_law.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace stemware::fem
{

namespace
{

/// Winkler's law p = k d where d > 0, in closed form: only the pieces of a line where d is positive are
/// integrated.
struct WinklerPressure
{
  double modulus; ///< k [Pa/m]

  double pressure(double depth) const { return depth > 0 ? modulus * depth : 0; }
  double stiffness(double) const { return modulus; }

  template <typename Visitor>
  void integrate(const ContactLine &line, const Eigen::Vector3d &depth, const Visitor &visit) const
  {
    for_each_loaded_point(line, depth, visit);
  }
};

} // namespace

std::unique_ptr<TableLaw> make_mat(const ContactSurface &surface, double modulus)
{
  if (!(std::isfinite(modulus) && modulus > 0))
  {
    std::ostringstream message;
    message << "Foundation modulus = " << modulus
            << " Pa/m is not allowed; give a finite number greater than 0 (cork about 1e9, lacquered wood "
               "about 1e11).";
    throw std::invalid_argument(message.str());
  }
  return std::make_unique<PressureLaw<WinklerPressure>>(surface, WinklerPressure{ modulus });
}

} // namespace stemware::fem
