#pragma once

#include <array>
#include <vector>

namespace dealii
{
template <int dim, int spacedim>
class Triangulation;
}

namespace stemware::fem
{

/// Corners (r, z) of a piece of a section [m], in turn.
using SectionPolygon = std::vector<std::array<double, 2>>;

/// Lengths of a foot, measured on the cells of its section [m].
struct SectionLengths
{
  double outer_radius = 0;
  double height = 0;      ///< of the stem's cut
  double stem_radius = 0; ///< at the stem's cut
  double thickness = 0;   ///< of the glass above some radius
};

/// Lengths of a section of one cell or more, its thickness above @p radius [m].
SectionLengths lengths_of(const std::vector<SectionPolygon> &cells, double radius);

/// Place of a loaded section: its coordinate across the axis and height, how far it goes [m], and the
/// stress of von Mises [Pa].
struct StressedPoint
{
  double x = 0, z = 0;
  double displacement_x = 0, displacement_z = 0;
  double von_mises = 0;
};

/// Grid of places over a cell of a loaded section, row by row.
using StressedPatch = std::vector<std::vector<StressedPoint>>;

/// Cells of a meridional mesh, edges straight.
std::vector<SectionPolygon> section_cells(const dealii::Triangulation<2, 2> &triangulation);

/// Section of the cells of a foot, edges straight, with the half-plane at @p azimuth [rad] through the axis.
/// A mesh that is spread over ranks is cut whole on each of them.
std::vector<SectionPolygon> section_cells(const dealii::Triangulation<3, 3> &triangulation, double azimuth);

} // namespace stemware::fem
