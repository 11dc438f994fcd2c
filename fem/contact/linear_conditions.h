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

/// Three linear conditions L'f + H q = t on the nodal forces f of a contact and the table motions q. L = Q =
/// (1, x, y) and H = 0 prescribe the resultants, t_0 the normal force. A moment balance adds the lever arm of
/// the friction to x and y; H is the moment of the weight of a tilted glass (docs/theory/closures.md).
class LinearConditions
{
public:
  /// @p weights L of shape [n_nodes, 3], columns in 1, m, m; @p target t in N, N m, N m; @p motion_weights H,
  /// columns per m, rad, rad. Throws std::invalid_argument unless the shape fits @p surface, the first column
  /// of L is 1, all is finite and t_0 > 0.
  LinearConditions(const ContactSurface &surface, Eigen::MatrixX3d weights, const Eigen::Vector3d &target,
                   const Eigen::Matrix3d &motion_weights = Eigen::Matrix3d::Zero());

  const Eigen::MatrixX3d &weights() const { return L; }
  const Eigen::Vector3d &target() const { return t; }
  const Eigen::Matrix3d &motion_weights() const { return H; }
  double normal_force() const { return t(0); }

  /// Returns whether L = Q to the last bit and H = 0: then there is an energy, and a symmetric Newton matrix.
  bool are_resultants() const { return symmetric; }

  /// Returns these conditions on @p surface with moments, friction arm and H times @p share (0: axisymmetric
  /// load), for continuation.
  LinearConditions with_scaled_moment(const ContactSurface &surface, double share) const;

  /// Returns L'f + H q - t [N, N m, N m] of all parts for nodal @p forces [N] and @p motion [m, rad, rad].
  Eigen::Vector3d residual(const Eigen::VectorXd &forces, const Eigen::Vector3d &motion) const
  {
    return parts.sum(L.transpose() * forces) + H * motion - t;
  }

  /// Throws TippingDemand if the required centre of pressure lies outside the convex hull of the contact
  /// nodes. @p radius: R, for the message [m]; @p is_ring as in ContactSurface.
  void require_possible(double radius, bool is_ring) const;

private:
  Eigen::MatrixX3d L;
  Eigen::Vector3d t;
  Eigen::Matrix3d H;
  bool symmetric;
  SurfaceParts parts;
};

/// Returns (1, x, y)'f = (N, -M_Ny, M_Nx). Throws std::invalid_argument unless all is finite and N > 0.
LinearConditions prescribed_resultants(const ContactSurface &surface, const Resultants &load);

} // namespace stemware::fem
