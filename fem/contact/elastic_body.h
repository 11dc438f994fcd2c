#pragma once

#include "fem/contact/linear_conditions.h"

#include <Eigen/SparseCore>

namespace stemware::fem
{

/// Newton increment of a body and of the table under it.
struct NewtonIncrement
{
  Eigen::VectorXd displacement; ///< change of u_z at the contact nodes [m]
  Eigen::Vector3d motion;       ///< change of the table motions q0 [m], q1, q2 [rad]
  /// du . K u [J]
  double energy_slope = 0;
  double energy_curvature = 0; ///< du . K du [J]
  unsigned int linear_iterations = 0;
  /// Stability margin det(R - H) / det R, with the stiffness R = L'T(Q - B(K + B'TB)^-1 B'TQ) of body and
  /// table against table motions and the weight's H of LinearConditions. Negative: no stable balance. 1
  /// without tilt, or if not computed.
  double stability_margin = 1;
};

/// Elastic foot with clamped stem cut, seen from its contact nodes (docs/method.md, "Newton's method"). Nodal
/// values come in the two layouts of ContactSurface. The state is the displacement u with the elastic forces
/// K u. B selects the vertical displacement of the contact nodes; Q = (1, x, y) there.
class ElasticBody
{
public:
  virtual ~ElasticBody() = default;

  virtual const ContactSurface &contact_surface() const = 0;

  /// Returns B u, the vertical displacement of the contact nodes, upward > 0 [m].
  virtual Eigen::VectorXd contact_displacement() const = 0;

  /// Solves [K + B'TB, B'TQ; L'TB, L'TQ - H] [du; dq] = [B' forces - K u; L' forces + H q - t], with @p
  /// tangent T as in ContactForces, L, H and t of @p conditions, and q = @p motion. The matrix is symmetric
  /// positive definite for L = Q and H = 0 unless the loaded nodes are on one line. Throws ContactFailure
  /// if the linear solver does not converge or the system is singular.
  virtual NewtonIncrement solve(const Eigen::SparseMatrix<double> &tangent, const Eigen::VectorXd &forces,
                                const LinearConditions &conditions, const Eigen::Vector3d &motion) = 0;

  /// Adds @p step_length of the last step to the state.
  virtual void update(double step_length) = 0;

  /// Resets the state: u = 0.
  virtual void reset() = 0;

  /// Returns the nodal forces whose response is the displacement, which fulfil the conditions to rounding
  /// after a full step, if the body stores them; else the table law's @p forces.
  virtual Eigen::VectorXd elastic_forces(const Eigen::VectorXd &forces) const { return forces; }

  /// Returns |B' forces - K u| / |B' forces|.
  virtual double equilibrium_residual(const Eigen::VectorXd &forces) const = 0;
};

} // namespace stemware::fem
