#pragma once

#include "fem/geometry/glass_profile.h"

#include <deal.II/base/point.h>

#include <memory>

namespace dealii
{
template <int dim, int spacedim, int chartdim>
class ChartManifold;
}

namespace stemware::fem
{

/// Coordinates (radius, level) in which foot and stem of a GlassShape::foot are rectangles
/// (docs/method/profile.md, "Mesh"). Foot: radius <= foot_radius [m], 0 <= level <= 1. Stem: radius <=
/// Fillet::middle_radius [m], 1 <= level <= 2. Points of the section are (r, z) [m].
///
/// In the foot, level rises from the underside to the top (under the stem: the height of the fillet's
/// middle); in the stem, from there to the cut, and radii stretch with the stem's surface. The coordinates
/// are smooth except at level 1 and at corners and jumps of curvature of the section.
class ProfileChart
{
public:
  /// @p profile must be valid.
  explicit ProfileChart(const GlassProfile &profile);

  /// Returns the point of the section at @p point of the chart.
  dealii::Point<2> push_forward(const dealii::Point<2> &point) const;
  /// Returns the point of the chart at @p point of the section.
  dealii::Point<2> pull_back(const dealii::Point<2> &point) const;

private:
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
