#pragma once

#include <Eigen/Core>

#include <vector>

namespace stemware::fem
{

/// Lagrange polynomials of @p nodes at @p x. Shape [nodes.size()].
Eigen::VectorXd lagrange_values(const Eigen::VectorXd &nodes, double x);

/// Vertical displacement of the contact nodes of a body of revolution under line forces of one harmonic n.
///
/// Forces in cylindrical directions f_z cos(n theta), f_r cos(n theta), f_theta sin(n theta) per radian at
/// the contact circles [N/rad] displace them by u_z cos(n theta), u_z = normal f_z + radial f_r + azimuthal
/// f_theta [m]. The mirror family (sin, sin, -cos) has the same matrices. Shapes [n_nodes, n_nodes], m rad/N.
struct HarmonicCompliance
{
  Eigen::MatrixXd normal;
  Eigen::MatrixXd radial;
  Eigen::MatrixXd azimuthal;
};

/// A body of revolution as the contact sees it: what its contact circles do under forces on them, harmonic by
/// harmonic.
struct ContactCompliance
{
  Eigen::VectorXd radii;                     ///< of the contact nodes, ascending [m]
  unsigned int degree = 0;                   ///< of the displacement along r within an element
  std::vector<HarmonicCompliance> harmonics; ///< n = 0 ... n_harmonics()
  unsigned int n_meridian_unknowns = 0;      ///< degrees of freedom of one meridional problem

  unsigned int n_nodes() const { return static_cast<unsigned int>(radii.size()); }
  unsigned int n_harmonics() const { return static_cast<unsigned int>(harmonics.size()) - 1; }

  /// Values at @p radius of the contact nodes' shape functions: those of the element that it lies in. Outside
  /// the contact zone the nearest element's polynomials go on. Shape [n_nodes].
  Eigen::VectorXd shape_at(double radius) const;

  /// Two bodies pressed together yield the sum of both: @p other is the body below, with z upward in both.
  /// Throws std::invalid_argument unless nodes, degree and number of harmonics agree.
  ContactCompliance &operator+=(const ContactCompliance &other);
};

} // namespace stemware::fem
