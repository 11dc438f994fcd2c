#pragma once

#include "fem/geometry/triangulation.h"

#include <array>
#include <map>
#include <vector>

namespace stemware::fem
{

/// Size, contact zone and quality of a foot mesh. Lengths in m.
struct MeshCheck
{
  unsigned int n_cells = 0;
  unsigned int n_vertices = 0;
  std::map<unsigned int, unsigned int> n_faces; ///< faces of the surface by boundary id (FootBoundary)
  std::array<double, 3> lower = {}, upper = {}; ///< box round all vertices

  double inner_radius = 0, outer_radius = 0; ///< distances of the contact zone's vertices from the axis
  double lowest = 0, highest = 0;            ///< z of the contact zone's vertices
  double contact_area = 0;                   ///< area of the contact faces, edges taken as straight [m^2]
  double upward_share = 0;                   ///< share of contact_area that faces up
  double sideways_share = 0;                 ///< share of contact_area that faces neither up nor down
  unsigned int n_zones = 0;                  ///< number of parts of the contact zone without a common edge
  std::array<double, 2> centre = {};         ///< centroid of the contact zone (x, y)
  std::array<double, 2> rim_centre = {};     ///< centre of the circle fitted to the outer border
  double rim_deviation = 0; ///< largest distance of the outer border from this circle, over its radius
  double mean_height = 0;   ///< mean height of the contact faces

  double stem_height = 0; ///< mean z of the faces of the stem cut
  /// Largest distance of the stem cut's vertices from the axis.
  double stem_radius = 0;
  unsigned int n_disconnected = 0;               ///< cells that are not joined to the stem cut by faces
  std::array<double, 3> disconnected_place = {}; ///< centre of one disconnected cell

  double min_jacobian = 1; ///< smallest scaled Jacobian of all cells
  double mean_jacobian = 1;
  std::array<double, 3> worst_place = {}; ///< centre of the cell with the smallest scaled Jacobian
  unsigned int n_inverted = 0;            ///< cells with a scaled Jacobian of 0 or less
};

/// Evaluates a mesh with at least one cell and one face of the contact zone.
MeshCheck check_mesh(const dealii::Triangulation<3, 3> &triangulation);

/// Returns the scaled Jacobian of each active cell: minimum over its corners of the edges' triple product
/// over their lengths (Knupp, SIAM J. Sci. Comput. 23 (2001) 193); 1: brick, <= 0: flat or inverted.
std::vector<double> scaled_jacobians(const dealii::Triangulation<3, 3> &triangulation);

/// Returns the largest divisor n of the number of contact faces for which a rotation by 2 pi / n about the z
/// axis maps vertices to vertices, to 1e-7 of the mesh's radius; 1 without symmetry. Vertices inside the
/// contact zone's inner radius are ignored.
unsigned int n_symmetry_sectors(const dealii::Triangulation<3, 3> &triangulation);

/// Closed polyline in (x, y) [m].
using Outline = std::vector<std::array<double, 2>>;

/// Returns the borders of the contact zone, the longest first.
std::vector<Outline> contact_outlines(const dealii::Triangulation<3, 3> &triangulation);

} // namespace stemware::fem
