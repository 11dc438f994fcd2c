#pragma once

#include "fem/contact/elastic_body.h"
#include "fem/contact/table_law.h"

#include <functional>
#include <limits>

namespace stemware::fem
{

/// One line of the progress table.
struct ContactIteration
{
  unsigned int number = 0;
  unsigned int n_loaded = 0;  ///< size of the active set
  unsigned int n_changed = 0; ///< how many of its members differ from the iteration before
  double residual = 0; ///< relative residual: of the body's forces and of the resultants, whichever is larger
  double step_length = 0; ///< share of the Newton step that was taken
  unsigned int linear_iterations = 0;
};

/// Where a contact solve begins: the table motions, and the normal displacement at which the table law is
/// first evaluated. That need not be what body and table make of it at the moment: a body that answers
/// otherwise than before, because friction has turned or the table law has become stiffer, then starts from
/// the places that carried load.
struct ContactStart
{
  Eigen::Vector3d motion;
  Eigen::VectorXd normal_displacement;  ///< at the contact nodes [m]
  unsigned int n_steps = 0;             ///< Newton steps taken before, of a solve that goes on
  unsigned int n_linear_iterations = 0; ///< and what they took
  /// Elastic forces of the body that are expected with it [N]; empty: those that the body has. A body whose
  /// Newton step is not exact errs by a share of how far its forces are from the solution.
  Eigen::VectorXd forces = {};
};

/// Stopping rule and limits of the contact driver.
struct ContactControl
{
  /// Tolerance of the relative residual of the conditions, and of the gap left by a hard interface.
  double tolerance = 1e-11;
  /// Tolerance of the body's relative residual, whose rounding floor grows with the mesh.
  double equilibrium_tolerance = 1e-9;
  /// Final check of the conditions: |sum f - N| / N and the other two over N R.
  double resultant_tolerance = 1e-9;
  unsigned int max_steps = 100; ///< Newton steps in all
  /// Residual after six steps above which a start counts as too far away; ends like too many steps.
  double hopeless_residual = std::numeric_limits<double>::infinity();
  /// Whether every step is taken whole: what a start close to the solution asks for, and where there is no
  /// energy to descend.
  bool whole_steps = false;
  /// Whether the active set has to stay what it is for convergence, and may not come back: complementarity at
  /// nodes. A pressure that is integrated along lines depends on its edges smoothly.
  bool set_matters = true;
  std::function<void(const ContactIteration &)> progress; ///< called after each step, may be empty
  /// Asked after each step: whether what has been found is enough, whatever the tolerances on the residual
  /// say; may be empty.
  std::function<bool(const ContactSolution &)> is_enough;
};

/// The rule for a stiff spring in the place of a hard interface, integrated along lines: its resultants are
/// as exact as the final check asks.
inline ContactControl control_of_spring()
{
  ContactControl control;
  control.set_matters = false;
  control.tolerance = control.resultant_tolerance;
  return control;
}

/// Presses @p body on the table described by @p law until the normal forces fulfil @p conditions.
///
/// Damped Newton method, started from the body's present displacement when @p start is given, else from rest
/// with the solution of the rigid foot. Under prescribed resultants the
/// step length minimises the energy of body and table, which is convex; under other conditions there is no
/// energy, and it is halved until the residual falls. @p radius is the length R that scales moments. Throws
/// ContactFailure for every named outcome but `converged` and `narrow_contact`.
ContactSolution solve_contact(ElasticBody &body, TableLaw &law, const LinearConditions &conditions,
                              double radius, const ContactControl &control = {},
                              const ContactStart *start = nullptr);

/// Table motions under a foot that does not deform, found from @p first. Throws ContactFailure.
Eigen::Vector3d rigid_foot_motion(const ContactSurface &surface, TableLaw &law,
                                  const LinearConditions &conditions, double radius,
                                  const Eigen::Vector3d &first);

/// solve_contact() under the prescribed resultants @p load. Throws std::invalid_argument unless N > 0 and all
/// is finite.
inline ContactSolution solve_contact(ElasticBody &body, TableLaw &law, const Resultants &load, double radius,
                                     const ContactControl &control = {}, const ContactStart *start = nullptr)
{
  return solve_contact(body, law, prescribed_resultants(body.contact_surface(), load), radius, control,
                       start);
}

} // namespace stemware::fem
