#pragma once

#include "fem/geometry/glass_profile.h"

#include <memory>

namespace dealii
{
template <int dim, int spacedim, int chartdim>
class ChartManifold;
}

namespace stemware::fem
{

/// Point of the meridional section of a glass [m].
struct SectionPoint
{
  double radius = 0;
  double height = 0; ///< above the land
};

/// Point in chart coordinates. Foot: radius <= foot_radius [m], 0 <= level <= 1. Stem: radius <=
/// Fillet::middle_radius [m], 1 <= level <= 2.
struct ChartPoint
{
  double radius = 0;
  double level = 0;
};

/// Coordinates in which foot and stem of a GlassShape::foot are rectangles (docs/method/profile.md, "Mesh").
///
/// In the foot, level rises from the underside to the top (under the stem: the height of the fillet's
/// middle); in the stem, from there to the cut, and radii stretch with the stem's surface. The coordinates
/// are smooth except at level 1 and at corners and jumps of curvature of the section.
class ProfileChart
{
public:
  /// @p profile must be valid.
  explicit ProfileChart(const GlassProfile &profile);

  SectionPoint push_forward(const ChartPoint &point) const;
  ChartPoint pull_back(const SectionPoint &point) const;

private:
  bool within_stem(double radius) const;
  double top(double radius) const;

  GlassProfile profile;
  Fillet fillet;
};

/// Returns the manifold of the section in (r, z): straight lines of the chart, the boundary on the profile.
std::unique_ptr<dealii::ChartManifold<2, 2, 2>> make_section_manifold(const GlassProfile &profile);

/// Returns the manifold of the foot for rings of cells: straight lines in chart radius, azimuth and level.
std::unique_ptr<dealii::ChartManifold<3, 3, 3>> make_ring_manifold(const GlassProfile &profile);

/// Returns the manifold of the foot for the core at the axis: straight lines in level, and in x and y
/// stretched with the chart radius.
std::unique_ptr<dealii::ChartManifold<3, 3, 3>> make_core_manifold(const GlassProfile &profile);

} // namespace stemware::fem
