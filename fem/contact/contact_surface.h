#pragma once

#include "fem/contact/surface_parts.h"

#include <Eigen/Core>

#include <vector>

namespace stemware::fem
{

/// Contact line along which the penetration is quadratic and a table law is integrated. Data at the samples
/// -1, 0, 1 of the local coordinate are quadratic in between. A contact face of a solid body has several
/// roughly radial lines, at Gauss points of the other direction; an azimuth line of a body of revolution has
/// one contact line per meridional element.
struct ContactLine
{
  std::vector<unsigned int> nodes; ///< contact nodes whose displacement acts on this line
  /// [sample, node]: displacement at a sample = shape * nodal displacements.
  Eigen::Matrix<double, 3, Eigen::Dynamic> shape;
  bool samples_are_nodes = false;       ///< true if there are three nodes and shape is the identity
  Eigen::Matrix<double, 3, 2> position; ///< (x, y) of the samples [m]
  /// Transverse vector at the samples, quadrature weight included [m].
  Eigen::Matrix<double, 3, 2> transverse_tangent;
  Eigen::Vector3d gap;      ///< distance of the undeformed surface from the plane z = 0 [m]
  double azimuth = 0;       ///< theta of the middle sample [rad]
  double azimuth_width = 0; ///< breadth of the line as an angle [rad]
};

/// Contact zone of a body, or one rank's part: the lines of its cells and their nodes, of which nodes of
/// other parts (ghosts) come last.
///
/// Nodal values come in two layouts. Functions of position (displacements, gaps) are known on every part that
/// has the node. Integrals (forces, tangents) have contributions of own lines only and are to be summed over
/// the parts; so are products of the two layouts.
struct ContactSurface
{
  Eigen::MatrixX2d node_position; ///< (x, y) of the contact nodes [m]
  Eigen::VectorXd node_gap;       ///< distance of the undeformed nodes from the plane z = 0 [m]
  Eigen::VectorXd node_area;      ///< int N_i dA of the whole surface, projected on the table [m^2]
  std::vector<ContactLine> lines;
  /// Index of each line's mirror image at y = 0, equal to the last bit, gap aside; empty: no symmetry.
  std::vector<std::size_t> mirrored_lines;
  /// True if every line has one azimuth; lines of equal azimuth form a cut at theta = const.
  bool lines_are_radial = false;
  unsigned int n_sectors = 0; ///< number of cells round the rim (mean of an irregular mesh)
  /// True if the land is rounded across the rim, so that the contact is a band of load-dependent width.
  bool is_crowned = false;
  /// True if the land is a ring with a hole at the axis.
  bool is_ring = true;

  unsigned int n_ghost_nodes = 0; ///< nodes of other parts, at the end of the lists
  SurfaceParts parts;             ///< communication with the other parts

  unsigned int n_nodes() const { return static_cast<unsigned int>(node_gap.size()); }
  unsigned int n_owned_nodes() const { return n_nodes() - n_ghost_nodes; }
  /// Returns the number of contact nodes of all parts together.
  unsigned int n_global_nodes() const { return parts.sum(std::size_t(n_owned_nodes())); }
  /// Returns the projected area of the whole contact zone [m^2].
  double area() const { return parts.sum(node_area.head(n_owned_nodes()).sum()); }
  /// Returns (1, x, y) at the nodes, the effect of the table motions on the gap; shape [n_nodes, 3].
  Eigen::MatrixX3d motion_modes() const;
  /// Returns the largest number of neighbouring nodes across the rim under @p pressure, shape [n_nodes], in
  /// the whole zone. Nodes within an eighth of a sector count as one radial row.
  unsigned int n_nodes_across(const Eigen::VectorXd &pressure) const;
};

/// Vertical force on the foot at a point of the table, independent of the body's discretisation.
struct PointForce
{
  double x = 0;     ///< [m]
  double y = 0;     ///< [m]
  double force = 0; ///< upward on the foot [N], >= 0
};

/// Returns @p forces rotated counter-clockwise by @p angle [rad].
std::vector<PointForce> rotated_by(std::vector<PointForce> forces, double angle);

} // namespace stemware::fem
