#pragma once

#include "fem/contact/linear_conditions.h"
#include "ring_model/load/load_functional.h"

#include <vector>

namespace stemware::fem
{

/// Resultants that the contact has to carry: a normal force N, and the moment
///
///   M_N = moment + (friction_x, friction_y)(load) + tilt_moment (-q2, +q1),
///
/// the sum of what is prescribed, of what the friction of the load itself adds, and of the weight of a glass
/// that leans by the table motions q1, q2 (docs/theory/closures.md). Plain resultants are the case without
/// the last two.
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

  /// Radii of the rings on which the load is gathered, ascending [m]; empty: the one ring that has the load's
  /// moment and first harmonic.
  std::vector<double> ring_radii;
  unsigned int n_harmonics = 0; ///< of the load; 0: as many as the contact resolves
  /// Moment of the load's friction [N m] as functions of the load on `ring_radii`; empty: none.
  ring::LoadFunctional friction_x;
  ring::LoadFunctional friction_y;
  double tilt_moment = 0; ///< N z_CM [N m]

  bool has_friction() const { return !friction_x.a.empty(); }

  /// This demand in axes turned counter-clockwise by @p angle [rad]: the load's azimuths count from there.
  ContactDemand in_axes_turned_by(double angle) const;
};

/// Value of @p function under a unit force on each contact node of @p surface, gathered on rings of radii @p
/// ring_radii [m]. Shape [n_nodes].
Eigen::VectorXd node_values(const ContactSurface &surface, const std::vector<double> &ring_radii,
                            const ring::LoadFunctional &function);

/// The demand as linear conditions on the nodal forces of @p surface and the table motions. Throws
/// std::invalid_argument unless N > 0 and all is finite.
LinearConditions conditions_of(const ContactSurface &surface, const ContactDemand &demand);

} // namespace stemware::fem
