#pragma once

#include "fem/contact/contact_surface.h"

#include <Eigen/SparseCore>

#include <vector>

namespace stemware::fem
{

/// Positions of the 3 x 3 tangents of contact lines in the sparse tangent of a surface, computed once.
class LinePattern
{
public:
  /// Keeps a reference to @p surface, whose lines must keep their nodes and shapes.
  explicit LinePattern(const ContactSurface &surface);

  /// Sets @p tangent, empty or filled by this pattern before, to zero entries for nodes on common lines.
  void set_zero(Eigen::SparseMatrix<double> &tangent) const;

  /// Adds forces [N] and tangent [N/m] at the samples of @p line to its nodes and, if @p image is another
  /// line, to the nodes of this mirror image. @p tangent must come from set_zero().
  void add(std::size_t line, std::size_t image, const Eigen::Vector3d &sample_forces,
           const Eigen::Matrix3d &sample_tangent, Eigen::VectorXd &forces,
           Eigen::SparseMatrix<double> &tangent) const;

private:
  /// Adds the forces and the tangent of the nodes of a line, and of its mirror image, to the surface's.
  template <typename Forces, typename Tangent>
  void add_at_nodes(std::size_t line, std::size_t image, const Forces &line_forces,
                    const Tangent &line_tangent, Eigen::VectorXd &forces,
                    Eigen::SparseMatrix<double> &tangent) const;

  const ContactSurface &surface;
  Eigen::SparseMatrix<double> empty;
  /// Positions of each line's node pairs (row-major) among the values of the sparse matrix.
  std::vector<std::vector<int>> places;
};

} // namespace stemware::fem
