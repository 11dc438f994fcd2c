#pragma once

#include "fem/contact/elastic_body.h"
#include "fem/contact/table_law.h"

#include <functional>
#include <stdexcept>
#include <string>

namespace stemware::fem
{

/// Resultants of the normal contact forces about the ring's centre on the table.
struct ContactLoad
{
  double normal_force = 0; ///< N = sum f [N], > 0
  double moment_x = 0;     ///< M_Nx =  sum y f [N m]
  double moment_y = 0;     ///< M_Ny = -sum x f [N m]
};

/// How a contact solve ended; everything but `converged` and `narrow_contact` is thrown as a ContactFailure.
enum class ContactOutcome
{
  converged,
  narrow_contact, ///< converged, but fewer than four nodes carry load side by side: the pressure across the
                  ///< rim is not resolved
  tipping,        ///< no distribution of pushing forces on the contact zone has these resultants
  repeated_set,   ///< the contact set came back without the residual falling
  singular_set,   ///< the loaded places no longer support the foot (fewer than three, or on one line)
  too_many_steps, ///< the allowed number of Newton steps was not enough
  unbalanced,     ///< the resultants of the normal forces miss the prescribed ones
  linear_solver_failed, ///< the body could not solve its linear system
  overflow              ///< forces or displacements left the range of floating-point numbers
};

/// The outcome's name as used in messages and in summary.json.
std::string to_string(ContactOutcome outcome);

/// Thrown when a contact solve ends without a solution; what() is a sentence with figures and advice.
class ContactFailure : public std::runtime_error
{
public:
  ContactFailure(ContactOutcome outcome, const std::string &message)
      : std::runtime_error(to_string(outcome) + ": " + message)
      , outcome(outcome)
  {
  }
  const ContactOutcome outcome;
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

/// A foot at rest on the table.
struct ContactSolution
{
  ContactOutcome outcome = ContactOutcome::converged; ///< converged or narrow_contact
  Eigen::VectorXd forces;                             ///< upward forces on the foot at the contact nodes [N]
  Eigen::VectorXd approach;                           ///< u_z + Q q at the contact nodes [m]
  Eigen::Vector3d motion = Eigen::Vector3d::Zero();   ///< q0 [m], q1, q2 [rad] of the table
  unsigned int n_iterations = 0;
  unsigned int n_linear_iterations = 0;
  unsigned int n_loaded_nodes = 0; ///< contact nodes under pressure
  unsigned int n_nodes_across = 0; ///< ContactSurface::n_nodes_across()
  double force_residual = 0;       ///< |sum f - N| / N
  double moment_residual = 0;      ///< |sum r x f - M_N| / (N R)
  double equilibrium_residual = 0; ///< |B'f - K u| / |B'f|
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
