#pragma once

#include <array>
#include <vector>

namespace stemware::fem
{

/// Corners (r, z) of a polygon of a section [m], in cyclic order.
using SectionPolygon = std::vector<std::array<double, 2>>;

/// Lengths of a foot, measured on the cells of its section [m].
struct SectionLengths
{
  double outer_radius = 0;
  double height = 0;      ///< height of the stem's cut
  double stem_radius = 0; ///< radius at the stem's cut
  double thickness = 0;   ///< thickness of the glass at the radius of lengths_of()
};

/// Returns the lengths of a section of one or more cells, with the thickness at @p radius [m].
SectionLengths lengths_of(const std::vector<SectionPolygon> &cells, double radius);

/// Point of a loaded section: coordinate across the axis, height, displacement [m]; von Mises stress [Pa].
struct StressedPoint
{
  double x = 0, z = 0;
  double displacement_x = 0, displacement_z = 0;
  double von_mises = 0;
};

/// Grid of points over a cell of a loaded section, row by row.
using StressedPatch = std::vector<std::vector<StressedPoint>>;

} // namespace stemware::fem
