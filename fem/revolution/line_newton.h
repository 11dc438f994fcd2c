#pragma once

#include "fem/contact/linear_conditions.h"
#include "fem/revolution/elastic_response.h"
#include "fem/revolution/line_bundle.h"

#include <Eigen/SparseCore>

#include <vector>

namespace stemware::fem
{

/// Newton step of a body of revolution on its azimuth lines.
///
/// The increment df of the elastic forces solves (1 + T C) df = r - T Q dq: T is the tangent of the table
/// law, block diagonal in the lines, C the elastic response, r the law's forces minus the elastic forces. C
/// is the sum of a part local to the lines and of a few smooth functions of r times the modes up to n_max
/// (ElasticResponse). The lines are eliminated one by one; a small dense system remains for the amplitudes of
/// these functions and the table motions. Polynomials in r approximate the smooth functions: the step is
/// accurate to 1e-4, or reduces the error of the forces to a fifth; the converged solution is exact.
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

  /// @p tangent as in ContactForces, @p unbalanced r on the lines, shape [n_radii, n_lines] [N]. Points
  /// without tangent are skipped if |r| is at most @p negligible [N]. Functions of @p cached are reused if
  /// they belong to the same circles, and are replaced otherwise.
  LineNewton(const ElasticResponse &response, const Eigen::SparseMatrix<double> &tangent,
             const Eigen::MatrixXd &unbalanced, Functions &cached, double negligible = 0);

  /// Newton step of the forces and the table.
  struct Increment
  {
    Eigen::MatrixXd forces; ///< df [N], shape [n_radii, n_lines]
    Eigen::Vector3d motion; ///< dq
    /// Derivative of the residuals of the conditions with respect to the table motions, as columns, without
    /// LinearConditions::motion_weights().
    Eigen::Matrix3d resistance;
  };

  /// Returns the step to forces that fulfil @p conditions; @p residual is the residual of the law's forces.
  /// Throws std::runtime_error if the system is singular.
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
  /// Returns the sums over the circles of a bundle of its solution times the functions, times functions and
  /// tractions, and times @p weights of the conditions; shape [n_kinds n_functions + 3, n_functions + 4].
  LaneTable tested(const Bundle &bundle, const Eigen::MatrixX3d &weights) const;
  /// Returns tested() of each line as a column, with the row index fastest: one matrix per kind of force with
  /// the responses to the p functions, the table motions and the residual, shape [p * (p + 4), n_lines], and
  /// a last matrix for the conditions, shape [3 * (p + 4), n_lines].
  std::vector<Eigen::MatrixXd> sums_on_lines(const LinearConditions &conditions) const;
  /// Returns the system of the amplitudes for a fixed table, followed by the columns of the motions and of
  /// the residual: shape [n_modes * p, n_modes * p + 4].
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
