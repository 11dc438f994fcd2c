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
  /// du . K u [J]: with `energy_curvature` the body's part of the energy along the step.
  double energy_slope = 0;
  double energy_curvature = 0; ///< du . K du [J]
  unsigned int linear_iterations = 0;
  /// Steadiness of the balance: det(R - H) / det R, R = L'T(Q - B(K + B'TB)^-1 B'TQ) the resistance of body
  /// and table to table motions, H the weight's part of the conditions. Beyond the balance in which a leaning
  /// glass stays it is negative; 1 where nothing leans, and of bodies that do not say.
  double steadiness = 1;
};

/// An elastic foot, stem cut clamped, seen from its contact nodes (docs/method.md, "Newton's method").
///
/// Where the contact surface is in parts, numbers at its nodes are of the two kinds of ContactSurface.
///
/// The body keeps its displacement u, K u being its elastic forces, as state; the contact driver asks for
/// increments and accepts a part of each. B picks the vertical displacement of the contact nodes, Q = (1, x,
/// y) there.
class ElasticBody
{
public:
  virtual ~ElasticBody() = default;

  virtual const ContactSurface &contact_surface() const = 0;

  /// B u: vertical displacement of the contact nodes, upward > 0 [m].
  virtual Eigen::VectorXd contact_displacement() const = 0;

  /// Solves [K + B'TB, B'TQ; L'TB, L'TQ - H] [du; dq] = [B' forces - K u; L' forces + H q - t], @p tangent T
  /// as in ContactForces, L, H and t of @p conditions, q = @p motion. Symmetric positive definite where L = Q
  /// and H = 0, as long as the loaded places are not on one line. Throws ContactFailure when the linear
  /// solver does not converge or the system is singular.
  virtual NewtonIncrement solve(const Eigen::SparseMatrix<double> &tangent, const Eigen::VectorXd &forces,
                                const LinearConditions &conditions, const Eigen::Vector3d &motion) = 0;

  /// Adds @p step_length of the last step to the state.
  virtual void update(double step_length) = 0;

  /// Forgets the state: u = 0.
  virtual void reset() = 0;

  /// The nodal forces whose elastic response the displacement is, where the body knows them; they fulfil
  /// the conditions to rounding after a whole step. Else @p forces, those of the table law.
  virtual Eigen::VectorXd elastic_forces(const Eigen::VectorXd &forces) const { return forces; }

  /// |B' forces - K u| / |B' forces|.
  virtual double equilibrium_residual(const Eigen::VectorXd &forces) const = 0;

  virtual unsigned int n_unknowns() const = 0;
};

} // namespace stemware::fem
