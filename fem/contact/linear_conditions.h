#pragma once

#include "fem/contact/contact_surface.h"

namespace stemware::fem
{

/// Resultants of the normal contact forces about the ring's centre on the table.
struct Resultants
{
  double normal_force = 0; ///< N = sum f [N], > 0
  double moment_x = 0;     ///< M_Nx =  sum y f [N m]
  double moment_y = 0;     ///< M_Ny = -sum x f [N m]
};

/// Three linear conditions L'f = t on the nodal forces f of a contact. The first column of L is 1, so that
/// t_0 is the normal force N; the other two are lengths. L = Q = (1, x, y) prescribes the resultants, a
/// moment balance adds to x and y the arm of the friction that the normal forces bring along (PHYSICS §5).
class LinearConditions
{
public:
  /// @p weights L of shape [n_nodes, 3], columns in 1, m, m; @p target t in N, N m, N m. Throws
  /// std::invalid_argument unless the shape is that of @p surface, the first column 1, everything finite and
  /// t_0 > 0.
  LinearConditions(const ContactSurface &surface, Eigen::MatrixX3d weights, const Eigen::Vector3d &target);

  const Eigen::MatrixX3d &weights() const { return L; }
  const Eigen::Vector3d &target() const { return t; }
  double normal_force() const { return t(0); }

  /// Whether L = Q to the last bit: equilibrium then minimises an energy and Newton's matrix is symmetric.
  bool are_resultants() const { return symmetric; }

  /// L'f - t for nodal @p forces [N]: in N, N m, N m.
  Eigen::Vector3d residual(const Eigen::VectorXd &forces) const { return L.transpose() * forces - t; }

private:
  Eigen::MatrixX3d L;
  Eigen::Vector3d t;
  bool symmetric;
};

/// The conditions (1, x, y)'f = (N, -M_Ny, M_Nx). Throws std::invalid_argument unless N > 0 and all is
/// finite.
LinearConditions prescribed_resultants(const ContactSurface &surface, const Resultants &load);

} // namespace stemware::fem
