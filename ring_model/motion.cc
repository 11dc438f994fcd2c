#include "ring_model/motion.h"

#include "ring_model/friction_law.h"
#include "ring_model/load/require.h"

namespace stemware::ring
{
void Motion::validate() const
{
  require_positive(mass, "the mass of the glass", "kg");
  require_positive(yaw_inertia, "the yaw inertia", "kg m^2");
  require_finite(force_offset, "the force offset Delta z [m]");
  require(std::isfinite(centre_of_mass_height) && centre_of_mass_height >= 0., "the centre of mass is ",
          centre_of_mass_height, " m above the table, but must be at a finite height that is not negative");
  require_positive(orbit_radius, "the orbit radius", "m");
  require_positive(orbit_speed, "the orbit speed", "m/s (the orbit sense says which way round)");
  require_finite(orbit_acceleration, "the acceleration along the orbit [m/s^2]");
  require(std::isfinite(friction_coefficient) && friction_coefficient >= 0., "the friction coefficient is ",
          friction_coefficient, ", but must be finite and not negative");
  if (friction_law == FrictionLawKind::stribeck)
    friction_law_of(*this); // throws for invalid parameters
  require_positive(gravity, "gravity", "m/s^2");
  liquid.validate(acceleration().norm() / gravity);
}

double Motion::total_centre_height() const
{
  // The liquid is added as a correction, so that a liquid of zero mass leaves the height exactly unchanged.
  const double height = liquid.mass > 0. ? liquid.centre_height(acceleration().norm() / gravity) : 0.;
  return centre_of_mass_height + liquid.mass / total_mass() * (height - centre_of_mass_height);
}

double Motion::overturning_height() const
{
  return total_centre_height() + liquid.mass / total_mass() * liquid.metacentric_radius();
}

double Motion::friction_at(double slip_speed) const
{
  return friction_law_of(*this).coefficient(slip_speed);
}

bool Motion::has_constant_friction() const
{
  return friction_law_of(*this).is_constant();
}

Eigen::Vector2d Motion::acceleration() const
{
  return { orbit_acceleration, sense_sign() * orbit_speed * orbit_speed / orbit_radius };
}
} // namespace stemware::ring
