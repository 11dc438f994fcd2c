#pragma once

#include "fem/geometry/meridian_section.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace stemware::fem
{

/// A point of the land beside the circle through all of them, lengths in m.
struct RimPoint
{
  double radius = 0;
  double height = 0;   ///< above the lowest point of the circle
  double distance = 0; ///< from the circle, positive inside it: above a rim's lowest part
  double weight = 0;   ///< in the fit, (0, 1]
};

/// A circle through the points of a rim, and how well they fix it, lengths in m.
struct RimCircle
{
  double contact_radius = 0; ///< of its lowest point
  double crown_radius = 0;

  std::vector<RimPoint> points = {}; ///< of the land, each of them once
  std::size_t n_repeated = 0;        ///< points of the land that stood in the list again

  double scatter = 0; ///< of the points about the circle: rms distance over the degrees of freedom
  double freedom = 0; ///< effective degrees of freedom of the scatter; 0: the points tell nothing about it
  /// Covariance of contact radius and crown radius [m^2]. A standard error, the root of a diagonal entry, is
  /// wider by Student's factor for these degrees of freedom: it holds the truth in 68 % of all cases.
  std::array<std::array<double, 2>, 2> covariance = {};

  double contact_radius_error() const { return std::sqrt(covariance[0][0]); } ///< standard error [m]
  double crown_radius_error() const { return std::sqrt(covariance[1][1]); }   ///< standard error [m]
  /// Whether there is a scatter that is more than rounding, and something that it leaves open.
  bool has_scatter() const;
};

/// The circle nearest to the points of the underside of @p polyline near its lowest place (least squares of
/// the distances). A point counts fully up to 0.85 of @p land_width / 2 from the lowest place of the circle
/// itself, half at the whole, and not at all from 1.15 of it on; so no point enters or leaves by a jump, and
/// what the choice of the points adds to the covariance follows from the derivative of the weights
/// (docs/method/profile.md).
///
/// Nothing where fewer than three points are there, where they bulge downwards by less than a thousandth of
/// their extent, or where no circle that is open upwards fits.
std::optional<RimCircle> fit_rim_circle(const std::vector<SectionVertex> &polyline, double land_width);

} // namespace stemware::fem
