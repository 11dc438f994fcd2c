#pragma once

#include "fem/revolution/contact_compliance.h"
#include "fem/revolution/fourier_basis.h"
#include "fem/revolution/line_tangents.h"

#include <Eigen/Core>

#include <optional>

namespace stemware::fem
{

/// Modes of forces or displacements on the loaded circles, one column a mode; all of shape [n_circles,
/// n_used_modes].
using ModeMatrix = Eigen::MatrixXd;

/// The three conditions L'f = t on the forces as Newton's system takes them.
struct NewtonConditions
{
  Eigen::Vector3d residual; ///< L'f - t
  /// L'T in modes, shape [3, n_circles * n_used_modes], circle running fastest; none where L = Q, so that it
  /// follows from the tangent.
  std::optional<Eigen::MatrixXd> rows;
  Eigen::Matrix3d corner = Eigen::Matrix3d::Zero(); ///< L'TQ, read where there are rows
};

/// Newton's linear system of a body of revolution, dense in the modes of its loaded circles.
///
/// With the body's stiffness S (block diagonal, the inverse of the compliance on the loaded circles), the
/// law's tangent T and the table motions Q in modes, [S + T, TQ; L'T, L'TQ] [du; dq] = [residual; L'f - t],
/// symmetric positive definite where L = Q. Sliding friction adds S C_t T_t to the first row, where T_t is
/// the tangent of the tangential forces and C_t their compliance; the matrix is then unsymmetric.
class HarmonicNewton
{
public:
  /// Reads the loaded circles' part of the compliance; the tangents decide which circles, @p even whether
  /// sine modes are left out.
  HarmonicNewton(const FourierBasis &basis, const ContactCompliance &compliance, const LineTangents &tangents,
                 bool even);

  /// Tangential forces per normal force on all contact circles and lines, shape [n_radii, n_lines] each.
  void add_sliding(const Eigen::MatrixXd &radial, const Eigen::MatrixXd &azimuthal);

  /// Modes that take part, as indices into FourierBasis.
  const std::vector<unsigned int> &modes() const { return used_modes; }

  struct Result
  {
    Eigen::Vector3d motion;      ///< dq
    ModeMatrix normal_decrement; ///< T (du + Q dq): what the normal forces lose on the loaded circles
    ModeMatrix radial_decrement; ///< the same of the tangential forces; empty without friction
    ModeMatrix azimuthal_decrement;
  };

  /// @p residual of the normal forces with S times the displacement by unbalanced tangential forces already
  /// added. Throws std::runtime_error when the matrix is singular.
  Result solve(const ModeMatrix &residual, const NewtonConditions &conditions) const;

  /// S times displacement modes.
  ModeMatrix stiffness_times(const ModeMatrix &displacement) const;

private:
  Eigen::Index size() const { return static_cast<Eigen::Index>(n_circles * used_modes.size()); }
  Eigen::MatrixXd assemble(const FourierProducts &products, bool with_conjugate) const;
  Eigen::MatrixXd motion_modes() const;
  Eigen::MatrixXd on_circles(const Eigen::MatrixXd &whole) const;
  /// S C_t T_t: the rows of used mode k.
  Eigen::MatrixXd sliding_response(unsigned int k) const;
  Eigen::MatrixXd bordered_matrix(const Eigen::MatrixXd &motions) const;
  /// Replaces the last rows of a bordered_matrix(), made for L = Q, by those of @p conditions; tilts and
  /// their conditions count per @p length.
  static void set_conditions(const NewtonConditions &conditions, double length, Eigen::MatrixXd &matrix);
  bool has_sliding() const { return radial_tangent.size() > 0; }

  const FourierBasis &basis;
  const ContactCompliance &compliance;
  const LineTangents &tangents;
  const bool even;
  const unsigned int n_circles;
  std::vector<unsigned int> used_modes;
  std::vector<Eigen::MatrixXd> stiffness; ///< S per used mode
  Eigen::MatrixXd normal_tangent;         ///< T in modes
  Eigen::MatrixXd radial_tangent;         ///< of the tangential forces; empty without friction
  Eigen::MatrixXd azimuthal_tangent;
};

} // namespace stemware::fem
