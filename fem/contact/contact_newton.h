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
  double residual = 0; ///< relative residual: of the body's forces and of the resultants, whichever is larger
  double step_length = 0; ///< length of the step over the length of the Newton step
  unsigned int linear_iterations = 0;
};

/// Initial guess of a contact solve: the table motions, and the normal displacement at which the table law
/// is first evaluated. The latter may differ from the displacement of body and table, for example after a
/// change of friction or of the law's stiffness.
struct ContactStart
{
  Eigen::Vector3d motion;
  Eigen::VectorXd normal_displacement;  ///< values at the contact nodes [m]
  unsigned int n_steps = 0;             ///< Newton steps already taken by a continued solve
  unsigned int n_linear_iterations = 0; ///< linear iterations of those steps
  /// Expected elastic forces of the body [N]; empty: the present forces. The error of an inexact Newton step
  /// is limited to a share of the distance between these forces and the solution.
  Eigen::VectorXd forces = {};
};

/// Stopping rule and limits of the contact driver.
struct ContactControl
{
  /// Tolerance of the relative residual of the conditions, and of the gap of a hard interface.
  double tolerance = 1e-11;
  /// Tolerance of the body's relative residual. Its rounding floor grows with the mesh.
  double equilibrium_tolerance = 1e-9;
  /// Tolerance of the final check: |sum f - N| / N, and the residuals of the two moments over N R.
  double resultant_tolerance = 1e-9;
  unsigned int max_steps = 100; ///< bound of the total number of Newton steps
  /// Residual above which a start is abandoned after six steps (outcome too_many_steps).
  double divergence_residual = std::numeric_limits<double>::infinity();
  /// Disables the line search: for starts close to the solution, and for conditions without an energy.
  bool full_steps = false;
  /// True if convergence requires an unchanged active set and a recurring set is a failure (complementarity
  /// at nodes); false for a pressure integrated along lines, which depends smoothly on the edges of the
  /// contact.
  bool requires_unchanged_set = true;
  std::function<void(const ContactIteration &)> progress; ///< called after each step, may be empty
  /// Callback after each step; true accepts the iterate with any residual. May be empty.
  std::function<bool(const ContactSolution &)> accepts_iterate;
};

/// Returns the stopping rule for a penalty law that approximates a hard interface, integrated along contact
/// lines: the tolerance of the resultants decides.
inline ContactControl penalty_control()
{
  ContactControl control;
  control.requires_unchanged_set = false;
  control.tolerance = control.resultant_tolerance;
  return control;
}

/// Presses @p body on the table described by @p law until the normal forces fulfil @p conditions, by a
/// damped Newton method.
///
///     const auto conditions = prescribed_resultants(body.contact_surface(), { N, M_x, M_y });
///     const ContactSolution solution = solve_contact(body, law, conditions, contact_radius);
///     solution.forces; // nodal forces [N], shape [n_nodes]
///
/// The initial guess is the body's present displacement if @p start is given, else the solution of the
/// rigid foot. Under prescribed resultants the step length minimises the convex energy of body and table.
/// Other conditions have no energy: the step is halved until the residual falls. @p radius is the length R
/// that scales moments. Throws ContactFailure for every outcome but `converged` and `narrow_contact`.
ContactSolution solve_contact(ElasticBody &body, TableLaw &law, const LinearConditions &conditions,
                              double radius, const ContactControl &control = {},
                              const ContactStart *start = nullptr);

/// Returns the table motions under a rigid foot, starting from @p first. Throws ContactFailure.
Eigen::Vector3d rigid_foot_motion(const ContactSurface &surface, TableLaw &law,
                                  const LinearConditions &conditions, double radius,
                                  const Eigen::Vector3d &first);

/// Calls solve_contact() with the prescribed resultants @p load. Throws std::invalid_argument unless N > 0
/// and all numbers are finite.
inline ContactSolution solve_contact(ElasticBody &body, TableLaw &law, const Resultants &load, double radius,
                                     const ContactControl &control = {}, const ContactStart *start = nullptr)
{
  return solve_contact(body, law, prescribed_resultants(body.contact_surface(), load), radius, control,
                       start);
}

} // namespace stemware::fem
