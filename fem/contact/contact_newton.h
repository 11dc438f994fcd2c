#pragma once

#include "fem/contact/elastic_body.h"
#include "fem/contact/table_law.h"

#include <functional>
#include <limits>

namespace stemware::fem
{

/// Row of the progress table.
struct ContactIteration
{
  unsigned int number = 0;
  unsigned int n_loaded = 0;  ///< size of the active set
  unsigned int n_changed = 0; ///< members of the active set that changed in this iteration
  double residual = 0;        ///< larger relative residual of body forces and resultants
  double step_length = 0;     ///< length of the step over the length of the Newton step
  unsigned int linear_iterations = 0;
};

/// Initial guess of a contact solve: table motions, and the normal displacement at which the table law is
/// first evaluated, which differs from that of body and table after a change of friction.
struct ContactStart
{
  Eigen::Vector3d motion;
  Eigen::VectorXd normal_displacement;  ///< values at the contact nodes [m]
  unsigned int n_steps = 0;             ///< Newton steps already taken by a continued solve
  unsigned int n_linear_iterations = 0; ///< linear iterations of those steps
  /// Expected elastic forces of the body [N]; empty: the present forces. Their distance to the solution
  /// scales the tolerance of an inexact Newton step.
  Eigen::VectorXd forces = {};
};

/// Stopping rule and limits of the contact driver.
struct ContactControl
{
  /// Tolerance of the relative residual of the conditions, and of the gap of a hard interface.
  double tolerance = 1e-11;
  /// Tolerance of the body's relative residual. Its rounding floor grows with the mesh.
  double equilibrium_tolerance = 1e-9;
  /// Tolerance of the final check: |sum f - N| / N, and residual moments over N R.
  double resultant_tolerance = 1e-9;
  unsigned int max_steps = 100; ///< bound of the total number of Newton steps
  /// Residual above which a start is abandoned after six steps (outcome too_many_steps).
  double divergence_residual = std::numeric_limits<double>::infinity();
  /// Disables the line search, for starts close to the solution and conditions without an energy.
  bool full_steps = false;
  /// True if convergence requires an unchanged active set, and a recurring set is a failure (nodal
  /// complementarity); false for a pressure along lines, which depends smoothly on the contact's edges.
  bool requires_unchanged_set = true;
  std::function<void(const ContactIteration &)> progress; ///< called after each step, may be empty
  /// Callback after each step, may be empty; true accepts the iterate with any residual.
  std::function<bool(const ContactSolution &)> accepts_iterate;
};

/// Returns the stopping rule for a penalty law along contact lines: the tolerance of the resultants decides.
inline ContactControl penalty_control()
{
  ContactControl control;
  control.requires_unchanged_set = false;
  control.tolerance = control.resultant_tolerance;
  return control;
}

/// Presses @p body on a table with @p law until the forces fulfil @p conditions, by a damped Newton method.
///
///     const auto conditions = prescribed_resultants(body.contact_surface(), { N, M_x, M_y });
///     const ContactSolution solution = solve_contact(body, law, conditions, contact_radius);
///     solution.forces; // nodal forces [N], shape [n_nodes]
///
/// Starts from @p start and the body's present displacement, or else from the rigid foot. The step length
/// minimises the convex energy of body and table under prescribed resultants; other conditions have no
/// energy, and the step is halved until the residual falls. @p radius: R, which scales moments [m]. Throws
/// ContactFailure for every outcome but `converged` and `narrow_contact`.
ContactSolution solve_contact(ElasticBody &body, TableLaw &law, const LinearConditions &conditions,
                              double radius, const ContactControl &control = {},
                              const ContactStart *start = nullptr);

/// Returns the table motions under a rigid foot, starting from @p first. Throws ContactFailure.
Eigen::Vector3d rigid_foot_motion(const ContactSurface &surface, TableLaw &law,
                                  const LinearConditions &conditions, double radius,
                                  const Eigen::Vector3d &first);

/// Calls solve_contact() under the resultants @p load. Throws std::invalid_argument unless finite and N > 0.
inline ContactSolution solve_contact(ElasticBody &body, TableLaw &law, const Resultants &load, double radius,
                                     const ContactControl &control = {}, const ContactStart *start = nullptr)
{
  return solve_contact(body, law, prescribed_resultants(body.contact_surface(), load), radius, control,
                       start);
}

} // namespace stemware::fem
