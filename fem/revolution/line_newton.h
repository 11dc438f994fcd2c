#pragma once

#include "fem/contact/linear_conditions.h"
#include "fem/revolution/elastic_response.h"
#include "fem/revolution/line_bundle.h"

#include <Eigen/SparseCore>

#include <vector>

namespace stemware::fem
{

/// Newton step of a body of revolution on its azimuth lines. The increment df of the elastic forces solves (1
/// + T C) df = r - T Q dq with the tangent T of the table law, block diagonal in the lines, the elastic
/// response C, and r, the forces of the law minus the elastic forces. C is a part local to the lines plus a
/// few smooth functions of the radius times the modes up to n_max (ElasticResponse). Eliminating the lines
/// leaves a small dense system for the amplitudes of these functions and the table motions. Polynomials
/// approximate the functions: a step reduces the error of the forces to a fifth or less; the converged
/// solution is exact.
class LineNewton
{
public:
  /// Smooth functions of r on neighbouring circles, and the response of their amplitudes.
  struct Functions
  {
    Eigen::Index first = 0, size = 0; ///< index of the first circle, number of circles
    bool has_sliding = false;
    Eigen::MatrixXd values; ///< orthonormal polynomials in r, shape [size, n_functions]
    /// Responses by harmonic, shapes [n_functions, n_functions].
    std::vector<HarmonicCompliance> reduced;
  };

  /// @p tangent: as in ContactForces. @p unbalanced: r [N], shape [n_radii, n_lines]. Points without tangent
  /// are skipped if |r| <= @p negligible [N]. @p cached: reused for the same circles, otherwise overwritten.
  LineNewton(const ElasticResponse &response, const Eigen::SparseMatrix<double> &tangent,
             const Eigen::MatrixXd &unbalanced, Functions &cached, double negligible = 0);

  /// Newton step of the forces and the table.
  struct Increment
  {
    Eigen::MatrixXd forces; ///< df [N], shape [n_radii, n_lines]
    Eigen::Vector3d motion; ///< dq
    /// Derivative of the conditions by the motions (columns), without LinearConditions::motion_weights().
    Eigen::Matrix3d resistance;
  };

  /// Returns the step that fulfils @p conditions; @p residual is the residual of the law's forces. Throws
  /// std::runtime_error if the system is singular.
  Increment solve(const LinearConditions &conditions, const Eigen::Vector3d &residual) const;

private:
  /// Range of circles with present or expected forces.
  struct Range
  {
    Eigen::Index first = 0;
    Eigen::Index size = 0;
  };
  /// Lines that are eliminated together, on the union of their circles.
  struct Bundle
  {
    Eigen::Index first_line;
    Range circles;
    /// (1 + T D)^-1 of T times the functions, of T Q and of r: shape [circles.size, n_functions + 3 + 1].
    LaneTable solution;
  };

  void find_lines(const Eigen::SparseMatrix<double> &tangent, const Eigen::MatrixXd &unbalanced,
                  double negligible);
  Functions chosen_functions() const;
  void eliminate_lines(const Eigen::SparseMatrix<double> &tangent, const Eigen::MatrixXd &unbalanced);
  /// Returns the sums over a bundle's circles of the solution times the functions, the functions with
  /// tractions, and @p weights of the conditions; shape [n_kinds n_functions + 3, n_functions + 4].
  LaneTable tested(const Bundle &bundle, const Eigen::MatrixX3d &weights) const;
  /// Returns tested() of each line as a column, row index fastest: a matrix per kind of force with the
  /// responses to p functions, motions and residual, shape [p * (p + 4), n_lines]; last, of the conditions,
  /// shape [3 * (p + 4), n_lines].
  std::vector<Eigen::MatrixXd> sums_on_lines(const LinearConditions &conditions) const;
  /// Returns the system of the amplitudes for a fixed table, and the columns of motions and residual: shape
  /// [n_modes * p, n_modes * p + 4].
  RowMatrix system_of_amplitudes(const std::vector<Eigen::MatrixXd> &on_lines) const;
  /// Returns df for @p amplitudes, shape [p, n_modes], and the table @p motion.
  Eigen::MatrixXd forces_of(const Eigen::MatrixXd &amplitudes, const Eigen::Vector3d &motion) const;
  /// Returns the number of kinds of force: normal, radial and azimuthal, or normal only.
  Eigen::Index n_kinds() const { return response.has_sliding() ? 3 : 1; }

  const ElasticResponse &response;
  std::vector<Range> lines;
  std::vector<Bundle> bundles;
  Range circles; ///< circles of all lines together
  const Functions &smooth;
};

} // namespace stemware::fem
