#pragma once

#include "fem/contact/linear_conditions.h"
#include "fem/revolution/elastic_response.h"

#include <Eigen/SparseCore>

#include <vector>

namespace stemware::fem
{

/// Smooth functions of r on neighbouring circles, and the response of their amplitudes.
struct SmoothFunctions
{
  Eigen::Index first = 0, size = 0; ///< index of the first circle, number of circles
  bool has_sliding = false;
  Eigen::MatrixXd values; ///< orthonormal polynomials in r, shape [size, n_functions]
  /// Responses by harmonic, shapes [n_functions, n_functions].
  std::vector<HarmonicCompliance> reduced;
};

/// Newton step of the forces on the azimuth lines and of the table.
struct LineIncrement
{
  Eigen::MatrixXd forces; ///< df [N], shape [n_radii, n_lines]
  Eigen::Vector3d motion; ///< dq
  /// Derivative of the conditions by the motions (columns), without LinearConditions::motion_weights().
  Eigen::Matrix3d resistance;
};

/// Returns the Newton step of a body of revolution that fulfils @p conditions. @p residual: residual of @p
/// conditions under the elastic forces. The increment df of these forces solves (1 + T C) df = r - T Q dq
/// with the tangent T of the table law, block diagonal in the lines, the elastic response C, and r, the
/// forces of the law minus the elastic forces. C is a part local to the lines plus a few smooth functions of
/// the radius times the modes up to n_max (ElasticResponse). Eliminating the lines leaves a small dense
/// system for the amplitudes of these functions and the table motions. Polynomials approximate the functions:
/// a step reduces the error of the forces to a fifth or less; the converged solution is exact.
///
/// @p tangent: as in ContactForces. @p unbalanced: r [N], shape [n_radii, n_lines]. Points without tangent
/// are skipped if |r| <= @p negligible [N]. @p cached: reused for the same circles, otherwise overwritten.
/// Throws ContactFailure if no point is under pressure or the system is singular.
LineIncrement line_newton_step(const ElasticResponse &response, const Eigen::SparseMatrix<double> &tangent,
                               const Eigen::MatrixXd &unbalanced, double negligible,
                               const LinearConditions &conditions, const Eigen::Vector3d &residual,
                               SmoothFunctions &cached);

} // namespace stemware::fem
