#pragma once

#include "ring_model/liquid.h"

#include <Eigen/Core>

namespace stemware::ring
{
/// Direction of the orbit, seen from above.
enum class OrbitSense
{
  counterclockwise, ///< the orbit's centre lies to the left of the motion (+y)
  clockwise         ///< the orbit's centre lies to the right of the motion (-y)
};

/// Dependence of the friction coefficient on the slip speed.
enum class FrictionLawKind
{
  coulomb, ///< constant coefficient
  stribeck ///< mu = mu_k + (mu_s - mu_k) exp(-(|v_rel| / v_s)^2) + c |v_rel|
};

/// Glass, orbit and friction; by default the paper's values, unless marked. Mass, inertia and centre of mass
/// are those of the empty glass.
struct Motion
{
  double mass = 0.30;                  ///< m [kg]
  double yaw_inertia = 3.0e-4;         ///< I_z about the glass's axis [kg m^2]; not in the paper
  double centre_of_mass_height = 0.08; ///< z_CM above the table [m]; not in the paper
  double force_offset = -0.05;         ///< Delta z = height of the hand's force - z_CM [m]
  double orbit_radius = 0.15;          ///< rho [m]
  double orbit_speed = 0.35;           ///< v > 0 [m/s]
  double orbit_acceleration = 0.; ///< dv/dt along the motion [m/s^2]; the moment balance `paper` ignores it
  OrbitSense orbit_sense = OrbitSense::counterclockwise;
  double friction_coefficient = 0.30; ///< mu; of Stribeck's law the kinetic one, mu_k
  FrictionLawKind friction_law = FrictionLawKind::coulomb;
  double static_coefficient = 0.40;   ///< mu_s of Stribeck's law
  double friction_decay_speed = 0.10; ///< v_s of Stribeck's law [m/s]
  double viscous_friction = 0.;       ///< c of Stribeck's law [s/m]
  double gravity = 9.81;              ///< g [m/s^2]
  Liquid liquid;                      ///< liquid in the glass; no liquid by default

  /// Throws std::invalid_argument with one sentence about the first inadmissible value.
  void validate() const;

  /// Returns the mass of glass and liquid [kg].
  double total_mass() const { return mass + liquid.mass; }

  /// Returns N = m g of glass and liquid [N].
  double normal_force() const { return total_mass() * gravity; }

  /// Returns the height of the centre of mass of glass and liquid above the table [m].
  double total_centre_height() const;

  /// Returns the height [m] at which the total mass as a rigid body has the overturning moment of glass and
  /// liquid (the liquid acts at its metacentre). Without liquid: centre_of_mass_height.
  double overturning_height() const;

  /// Returns mu at the slip speed |v_rel| >= 0 [m/s].
  double friction_at(double slip_speed) const;

  /// Returns mu without spin, where every point of the rim slips with the orbit speed.
  double friction_at_rest() const { return friction_at(orbit_speed); }

  /// Returns whether mu is the same at every slip speed.
  bool has_constant_friction() const;

  /// Returns +1 for a counter-clockwise orbit, -1 for a clockwise one.
  double sense_sign() const { return orbit_sense == OrbitSense::counterclockwise ? 1. : -1.; }

  /// Returns Omega = +- v / rho [rad/s], the rate at which the slip frame turns.
  double orbit_rate() const { return sense_sign() * orbit_speed / orbit_radius; }

  /// Returns the acceleration of the glass in the slip frame [m/s^2]: (dv/dt, sense_sign() v^2/rho).
  Eigen::Vector2d acceleration() const;
};
} // namespace stemware::ring
