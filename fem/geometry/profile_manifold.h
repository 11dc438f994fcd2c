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

/// Point in chart coordinates: radius [m] and level. The foot is the rectangle radius <= foot_radius, 0 <=
/// level <= 1, the stem above it the rectangle radius <= Fillet::middle_radius, 1 <= level <= 2.
struct ChartPoint
{
  double radius = 0;
  double level = 0;
};

/// Coordinates in which the section of a GlassShape::foot is rectangular, for making and refining meshes
/// (docs/method/profile.md, "Mesh").
///
/// In the foot level runs from the underside to the top; under the stem the top is the height of the fillet's
/// middle. In the stem level runs from there to the cut, and radii stretch with the stem's surface. The
/// coordinates are smooth except at radii where the section has a corner or a jump of curvature, and at
/// level 1.
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

/// Returns the manifold of the section in (r, z) with chart coordinates radius and level: points lie on
/// straight lines of the chart, boundary points on the profile.
std::unique_ptr<dealii::ChartManifold<2, 2, 2>> make_section_manifold(const GlassProfile &profile);

/// Returns the manifold of the foot in (x, y, z) for the rings of cells round the axis: straight lines in
/// chart radius, azimuth and level.
std::unique_ptr<dealii::ChartManifold<3, 3, 3>> make_ring_manifold(const GlassProfile &profile);

/// Returns the manifold of the foot in (x, y, z) for the Cartesian core at the axis: straight lines in level
/// and in x and y stretched with the chart radius.
std::unique_ptr<dealii::ChartManifold<3, 3, 3>> make_core_manifold(const GlassProfile &profile);

} // namespace stemware::fem
