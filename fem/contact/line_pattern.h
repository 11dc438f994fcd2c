#pragma once

#include "fem/contact/contact_surface.h"

#include <Eigen/SparseCore>

#include <vector>

namespace stemware::fem
{

/// Positions of the 3 x 3 tangents of contact lines in the sparse tangent of a surface, computed once
/// because laws assemble at every Newton step.
class LinePattern
{
public:
  /// Keeps a reference to @p surface, whose lines must keep their nodes and shapes.
  explicit LinePattern(const ContactSurface &surface);

  /// Sets @p tangent to the sparsity pattern of nodes on common lines, with zero entries. @p tangent must be
  /// empty or have been filled by this pattern.
  void set_zero(Eigen::SparseMatrix<double> &tangent) const;

  /// Adds the forces [N] and the tangent [N/m] of @p line, given at its samples, to the nodes of @p line, and
  /// to the nodes of its mirror @p image if that is another line. @p tangent must come from set_zero().
  void add(std::size_t line, std::size_t image, const Eigen::Vector3d &sample_forces,
           const Eigen::Matrix3d &sample_tangent, Eigen::VectorXd &forces,
           Eigen::SparseMatrix<double> &tangent) const;

private:
  /// Adds the forces and the tangent of a line's nodes to the surface's.
  template <typename Forces, typename Tangent>
  void add_at_nodes(std::size_t line, const Forces &line_forces, const Tangent &line_tangent,
                    Eigen::VectorXd &forces, Eigen::SparseMatrix<double> &tangent) const;

  const ContactSurface &surface;
  Eigen::SparseMatrix<double> empty;
  /// Positions of each line's node pairs (row-major) among the values of the sparse matrix.
  std::vector<std::vector<int>> places;
};

} // namespace stemware::fem
