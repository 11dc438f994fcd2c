#pragma once

#include <Eigen/SparseCore>

#include <utility>
#include <vector>

namespace stemware::fem
{

/// Tangent of a table law on a body of revolution, line by line: nodes of different azimuth lines do not act
/// on each other.
struct LineTangents
{
  /// From a tangent between nodes j * n_radii + i (circle i, line j). @p needed circles are taken as loaded
  /// even where the tangent is zero.
  LineTangents(const Eigen::SparseMatrix<double> &tangent, unsigned int n_radii, unsigned int n_lines,
               const std::vector<bool> &needed);

  std::vector<unsigned int> circles; ///< contact circles that carry load, ascending
  /// Positions p <= q in `circles` that act on each other.
  std::vector<std::pair<unsigned int, unsigned int>> coupled_pairs;
  Eigen::MatrixXd values; ///< tangent of each coupled pair on each line [N/m], [n_pairs, n_lines]

  /// Whether line j and its mirror image -j agree to @p tolerance of the largest value.
  bool is_even(double tolerance) const;
};

} // namespace stemware::fem
