#pragma once

#include <Eigen/Core>

#include <stdexcept>
#include <string>

namespace stemware::fem
{

/// Outcome of a contact solve, in the order of to_string(). All but `converged` and `narrow_contact` are
/// thrown as a ContactFailure.
enum class ContactOutcome
{
  converged,
  narrow_contact, ///< converged, but fewer than four nodes carry load side by side: the pressure across the
                  ///< rim is not resolved
  tipping,        ///< no distribution of pushing forces on the contact zone has these resultants
  repeated_set,   ///< the active set came back without the residual falling
  singular_set,   ///< the loaded places no longer support the foot (fewer than three, or on one line)
  too_many_steps, ///< the allowed number of Newton steps was not enough
  unbalanced,     ///< the resultants of the normal forces miss the prescribed ones
  linear_solver_failed, ///< the body could not solve its linear system
  inverted_cells,       ///< halving cells of the mesh turns others inside out
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

/// Exception of a contact solve without a solution; what() is one sentence with numbers and advice.
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

/// Exception of a demand whose centre of pressure lies beyond the foot: no foot there stands, elastic or not.
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
  Eigen::VectorXd
    force_mismatch; ///< what these have more than the table law's: its balance with the body is not exact [N]
  Eigen::VectorXd normal_displacement;              ///< u_z + Q q at the contact nodes [m]
  Eigen::Vector3d motion = Eigen::Vector3d::Zero(); ///< q0 [m], q1, q2 [rad] of the table
  unsigned int n_iterations = 0;
  unsigned int n_linear_iterations = 0;
  unsigned int n_loaded_nodes = 0; ///< contact nodes under pressure
  unsigned int n_nodes_across = 0; ///< ContactSurface::n_nodes_across()
  double force_residual = 0;       ///< |sum f - N| / N
  double moment_residual = 0;      ///< |sum r x f - M_N| / (N R), or that of the conditions in its place
  double equilibrium_residual = 0; ///< |B'f - K u| / |B'f|
  double stability_margin = 1;     ///< NewtonIncrement::stability_margin of the last step
};

} // namespace stemware::fem
