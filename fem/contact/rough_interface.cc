// The rough interface: two nominally flat rough surfaces whose asperities carry the load.
#include "fem/contact/pressure_law.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace stemware::fem
{

namespace
{

/// p = p0 exp(d / s) down to the mean plane, d = 0, and its tangent p0 (1 + d / s) beyond, where the
/// asperities are flat.
struct AsperityPressure
{
  double reference_pressure; ///< p0 [Pa]
  double decay_length;       ///< s [m]

  double pressure(double depth) const
  {
    const double ratio = depth / decay_length;
    return reference_pressure * (ratio < 0 ? std::exp(ratio) : 1 + ratio);
  }
  double stiffness(double depth) const
  {
    return reference_pressure / decay_length * (depth < 0 ? std::exp(depth / decay_length) : 1);
  }

  /// Under a rounded rim the pressure is a bell of width sqrt(crown radius * s): every panel is as long as
  /// that or shorter.
  template <typename Visitor>
  void integrate(const ContactLine &line, const Eigen::Vector3d &, const Visitor &visit) const
  {
    const double rise = line.gap.maxCoeff() - line.gap.minCoeff();
    const double panels = std::ceil(std::sqrt(2 * rise / decay_length));
    for_each_point(line, static_cast<unsigned int>(std::clamp(panels, 1., 200.)), visit);
  }
};

void require_positive(const char *name, double value, const char *unit, const char *example)
{
  if (std::isfinite(value) && value > 0)
    return;
  std::ostringstream message;
  message << name << " = " << value << " " << unit << " is not allowed; give a finite number greater than 0 ("
          << example << ").";
  throw std::invalid_argument(message.str());
}

} // namespace

std::unique_ptr<TableLaw> make_rough_interface(const ContactSurface &surface, const RoughInterface &interface)
{
  require_positive("Reference pressure", interface.reference_pressure, "Pa",
                   "a tenth of the harder body's E, 1e9 for wood");
  require_positive("Decay length", interface.decay_length, "m",
                   "half the rms roughness, 1e-6 for planed wood");
  return std::make_unique<PressureLaw<AsperityPressure>>(
    surface, AsperityPressure{ interface.reference_pressure, interface.decay_length });
}

} // namespace stemware::fem
