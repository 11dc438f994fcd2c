#pragma once

#include <Eigen/Core>

#include <stdexcept>
#include <string>

namespace stemware::fem
{

/// Outcome of a contact solve; all but `converged` and `narrow_contact` are thrown as a ContactFailure.
enum class ContactOutcome
{
  converged,
  narrow_contact,       ///< converged, but fewer than four loaded nodes across the rim
  tipping,              ///< no compressive forces on the contact zone have these resultants
  repeated_set,         ///< the active set recurred without a smaller residual
  singular_set,         ///< the loaded points no longer support the foot (fewer than three, or collinear)
  too_many_steps,       ///< no convergence within the allowed number of Newton steps
  unbalanced,           ///< the resultants of the normal forces miss the prescribed ones
  linear_solver_failed, ///< the body could not solve its linear system
  inverted_cells,       ///< refining cells of the mesh inverts others
  overflow              ///< forces or displacements left the range of floating-point numbers
};

/// Returns the outcome's name as used in messages and in summary.json.
inline std::string to_string(ContactOutcome outcome)
{
  static constexpr const char *names[] = { "converged",
                                           "narrow contact",
                                           "tipping",
                                           "repeated contact set",
                                           "singular contact set",
                                           "too many contact steps",
                                           "unbalanced contact forces",
                                           "linear solver failed",
                                           "cells inside out",
                                           "overflow" };
  return names[static_cast<std::size_t>(outcome)];
}

/// Exception of a contact solve; what() has numbers and advice.
class ContactFailure : public std::runtime_error
{
public:
  ContactFailure(ContactOutcome outcome, const std::string &message)
      : std::runtime_error(to_string(outcome) + ": " + message)
      , outcome(outcome)
      , message(message)
  {
  }
  const ContactOutcome outcome;
  const std::string message; ///< what() without the outcome
};

/// Exception for a centre of pressure outside the foot: the glass tips, with any elasticity.
class TippingDemand : public ContactFailure
{
public:
  explicit TippingDemand(const std::string &message)
      : ContactFailure(ContactOutcome::tipping, message)
  {
  }
};

/// Equilibrium of a foot on the table.
struct ContactSolution
{
  ContactOutcome outcome = ContactOutcome::converged; ///< converged or narrow_contact
  Eigen::VectorXd forces;                             ///< upward forces on the foot at the contact nodes [N]
  Eigen::VectorXd force_mismatch;      ///< forces minus the table law's forces, the final residual [N]
  Eigen::VectorXd normal_displacement; ///< u_z + Q q at the contact nodes [m]
  Eigen::Vector3d motion = Eigen::Vector3d::Zero(); ///< q0 [m], q1, q2 [rad] of the table
  unsigned int n_iterations = 0;
  unsigned int n_linear_iterations = 0;
  unsigned int n_loaded_nodes = 0; ///< contact nodes under pressure
  unsigned int n_nodes_across = 0; ///< ContactSurface::n_nodes_across()
  double force_residual = 0;       ///< |sum f - N| / N
  double moment_residual = 0;      ///< |sum r x f - M_N| / (N R), or the residual of the conditions
  double equilibrium_residual = 0; ///< |B'f - K u| / |B'f|
  double stability_margin = 1;     ///< NewtonIncrement::stability_margin of the last step
};

} // namespace stemware::fem
