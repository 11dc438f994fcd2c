#pragma once

#include "fem/contact/linear_conditions.h"
#include "fem/revolution/body_of_revolution.h"

#include <Eigen/SparseCore>

namespace stemware::fem
{

/// A linear function j'f + h'q of nodal forces f and table motions q.
struct ForceFunction
{
  Eigen::VectorXd of_forces; ///< j [J/N], shape [n_nodes]
  Eigen::Vector3d of_motion; ///< h [J/m, J/rad, J/rad]
};

/// How a function of a contact changes with the gap and with the conditions.
struct GapGradient
{
  Eigen::MatrixXd of_gap;        ///< w [J/m], shape [n_radii, n_lines]
  Eigen::Vector3d of_conditions; ///< nu [J/N, J/(N m), J/(N m)]: change with the target t
};

/// The gradient of @p function with respect to the gap at the contact nodes of @p body, where the tangent of
/// the table law is @p tangent: the dual of one Newton step (docs/method/error_bands.md, "The error of one
/// number").
///
/// A gap that grows by dg changes forces and motions by (1 + T R) df = -T (dg + Q dq) and L'df + H dq = 0, T
/// the tangent, R the elastic response with friction, L and H of @p conditions. With s + T R's + T L nu = T j
/// and Q's + H'nu = h the function changes by -s'dg. That system, unsymmetric by friction, is solved by
/// GMRES to 1e-10 after the step without friction (LineNewton). Throws std::runtime_error where that does not
/// converge.
GapGradient gap_gradient(const BodyOfRevolution &body, const Eigen::SparseMatrix<double> &tangent,
                         const LinearConditions &conditions, const ForceFunction &function);

} // namespace stemware::fem
