#pragma once

#include "fem/contact/elastic_body.h"
#include "fem/contact/table_law.h"

#include <functional>

namespace stemware::fem
{

/// Resultants of the normal contact forces about the ring's centre on the table.
struct ContactLoad
{
  double normal_force = 0; ///< N = sum f [N], > 0
  double moment_x = 0;     ///< M_Nx =  sum y f [N m]
  double moment_y = 0;     ///< M_Ny = -sum x f [N m]
};

/// One line of the progress table.
struct ContactIteration
{
  unsigned int number = 0;
  unsigned int n_loaded = 0;  ///< size of the contact set
  unsigned int n_changed = 0; ///< how many of its members differ from the iteration before
  double residual =
    0; ///< relative imbalance: of the body's forces and of the resultants, whichever is larger
  double step_fraction = 0; ///< share of the Newton step that was taken
  unsigned int linear_iterations = 0;
};

/// Stopping rule and limits of the contact driver.
struct ContactControl
{
  double tolerance = 1e-11; ///< on the resultants' relative residual, and on the gap left by a rigid table
  double equilibrium_tolerance =
    1e-9; ///< on the body's relative residual, whose rounding floor grows with the mesh
  double resultant_tolerance = 1e-9; ///< final check: |sum f - N| / N and |sum r x f - M| / (N R)
  unsigned int max_steps = 100;      ///< Newton steps in all
  std::function<void(const ContactIteration &)> progress; ///< called after each step, may be empty
};

/// Presses @p body on the table described by @p law until the normal forces have the resultants @p load.
///
/// Damped Newton method on the energy of body and table, which is convex: started from the body's present
/// displacement when
/// @p start (the table motions to begin with) is given, else from rest with the solution of the rigid foot.
/// @p radius is the length R that scales moments. Throws ContactFailure for every named outcome but
/// `converged`.
ContactSolution solve_contact(ElasticBody &body, TableLaw &law, const ContactLoad &load, double radius,
                              const ContactControl &control = {}, const Eigen::Vector3d *start = nullptr);

} // namespace stemware::fem
