#pragma once

#include "fem/contact/linear_conditions.h"
#include "ring_model/load/load_functional.h"

#include <vector>

namespace stemware::fem
{

/// Required resultants of the contact: a normal force N and the moment
///
///   M_N = moment + (friction_x, friction_y)(load) + tilt_moment (-q2, +q1),
///
/// the prescribed moment, the moment of the load's own friction, and the moment of the weight of a glass
/// tilted by q1, q2 (docs/theory/closures.md). Plain resultants have the first only.
struct ContactDemand : Resultants
{
  ContactDemand() = default;
  ContactDemand(const Resultants &resultants) // NOLINT(google-explicit-constructor): resultants are a demand
      : Resultants(resultants)
  {
  }
  ContactDemand(double normal_force, double moment_x, double moment_y)
      : Resultants{ normal_force, moment_x, moment_y }
  {
  }

  /// Radii of the load's rings, ascending [m]. Empty: one ring with the load's moment and first harmonic.
  std::vector<double> ring_radii;
  unsigned int n_harmonics = 0; ///< harmonics of the load; 0: as many as the contact resolves
  /// Moment of the load's friction [N m], functionals of the load on `ring_radii`; empty: none.
  ring::LoadFunctional friction_x;
  ring::LoadFunctional friction_y;
  double tilt_moment = 0; ///< N z_CM [N m]; for a filled glass N times ring::Motion::overturning_height()

  bool has_friction() const { return friction_x.a.size() > 0; }

  /// Returns this demand in axes rotated counter-clockwise by @p angle [rad].
  ContactDemand in_rotated_axes(double angle) const;
};

/// Returns @p function of a unit force on each node, projected onto @p ring_radii [m]; shape [n_nodes].
Eigen::VectorXd node_values(const ContactSurface &surface, const std::vector<double> &ring_radii,
                            const ring::LoadFunctional &function);

/// Returns the demand as linear conditions on the nodal forces of @p surface and the table motions. Throws
/// std::invalid_argument unless N > 0 and all numbers are finite.
LinearConditions conditions_of(const ContactSurface &surface, const ContactDemand &demand);

} // namespace stemware::fem
