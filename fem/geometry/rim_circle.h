#pragma once

#include "fem/geometry/meridian_section.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace stemware::fem
{

/// Circle through the points of a rim, lengths in m.
struct RimCircle
{
  double contact_radius = 0; ///< distance of its lowest point from the axis
  double crown_radius = 0;
  double rms_distance = 0;  ///< weighted rms distance of the points from the circle
  std::size_t n_points = 0; ///< points of the land, each counted once
};

/// Returns the least-squares circle through the points of the underside of @p polyline near its lowest point.
/// Weights fall from 1 to 0 between 0.85 and 1.15 of @p land_width / 2 from the circle's lowest point, for a
/// continuous result (docs/method/profile.md). Returns std::nullopt for fewer than three points, a bulge
/// below a thousandth of its width, or no fitting circle open upwards.
std::optional<RimCircle> fit_rim_circle(const std::vector<SectionVertex> &polyline, double land_width);

} // namespace stemware::fem
