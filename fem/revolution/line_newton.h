#pragma once

#include "fem/contact/linear_conditions.h"
#include "fem/revolution/elastic_response.h"

#include <Eigen/SparseCore>

#include <vector>

namespace stemware::fem
{

/// One Newton step of a body of revolution on its azimuth lines.
///
/// The elastic forces change by df with (1 + T C) df = r - T Q dq: T the tangent of the table law, block
/// diagonal in the lines, C the elastic response, r what the law's forces differ from the elastic ones. C is
/// local to the lines but for few smooth functions of r times the modes up to n_max (ElasticResponse); the
/// lines are eliminated one by one, and a small dense system for the amplitudes of these functions and the
/// table motions is left. Polynomials in r stand for the smooth functions: the step is that of a Newton
/// method to 1e-4 or better, while what it solves for is exact.
class LineNewton
{
public:
  /// @p tangent as in ContactForces, @p unbalanced r on the lines, shape [n_radii, n_lines] [N]; places
  /// without tangent where it is @p negligible [N] or less are left alone.
  LineNewton(const ElasticResponse &response, const Eigen::SparseMatrix<double> &tangent,
             const Eigen::MatrixXd &unbalanced, double negligible = 0);

  struct Increment
  {
    Eigen::MatrixXd forces; ///< df [N], shape [n_radii, n_lines]
    Eigen::Vector3d motion; ///< dq
    /// Resistance of body and table to motions of the table: the residuals of the conditions by motion, as
    /// columns, without the weight that LinearConditions::motion_weights() adds.
    Eigen::Matrix3d resistance;
  };

  /// The step to forces that fulfil @p conditions, of which @p residual is what the law's forces miss. Throws
  /// std::runtime_error when the system is singular.
  Increment solve(const LinearConditions &conditions, const Eigen::Vector3d &residual) const;

private:
  /// Circles of one line that carry force or are about to.
  struct Line
  {
    Eigen::Index first = 0;
    Eigen::Index size = 0;
    Eigen::MatrixXd answer;   ///< (1 + T D)^-1 T times the functions
    Eigen::MatrixXd moved;    ///< (1 + T D)^-1 T Q
    Eigen::VectorXd balanced; ///< (1 + T D)^-1 r
  };

  void find_lines(const Eigen::SparseMatrix<double> &tangent, const Eigen::MatrixXd &unbalanced,
                  double negligible);
  void choose_functions();
  void eliminate_lines(const Eigen::SparseMatrix<double> &tangent, const Eigen::MatrixXd &unbalanced);
  auto functions_on(const Line &line) const
  {
    return functions.middleRows(line.first - first_circle, line.size);
  }

  const ElasticResponse &response;
  std::vector<Line> lines;
  Eigen::Index first_circle = 0; ///< of all lines together
  Eigen::Index n_circles = 0;
  Eigen::MatrixXd functions; ///< orthonormal polynomials in r, shape [n_circles, n_functions]
  /// Response of the functions' amplitudes by harmonic, shapes [n_functions, n_functions].
  std::vector<HarmonicCompliance> reduced;
};

} // namespace stemware::fem
