#pragma once

#include <vector>

namespace stemware::fem
{

/// Point of a meridian given by the user [m].
struct SectionVertex
{
  double radius = 0;
  double height = 0;
  unsigned int line = 0; ///< line in the file, for messages
};

/// Piecewise linear function y(x) with strictly increasing x.
struct PiecewiseLinear
{
  std::vector<double> x, y;
  std::vector<unsigned int> lines; ///< lines of the points in the file

  void add(double at, double value, unsigned int line);

  /// Returns y(@p at): linear between the points, constant outside them.
  double operator()(double at) const;
};

/// Section of a foot between its axis and a polyline, as three curves: the underside over r, the top of
/// the foot over r, the stem's surface over z. Heights count from the lowest point of the polyline.
///
/// The polyline begins on the axis under the foot, runs along the underside, edge, top and stem, and ends on
/// the axis with the horizontal cut; or in reverse. Foot and stem meet at the innermost point up to which the
/// top, seen from the edge, rises by less than 45 degrees. The edge is cut off where the foot is thinner than
/// a twentieth of its thickness above its lowest point.
class MeridianSection
{
public:
  /// Removes points within 1e-5 of the largest radius of the line between their neighbours. Throws
  /// std::invalid_argument, naming point and line in the file, for a polyline that is open, upside down,
  /// crosses itself, or has two heights of underside or top at one radius.
  explicit MeridianSection(std::vector<SectionVertex> polyline);

  /// Returns the height of the lower surface at @p radius [m].
  double underside(double radius) const { return lower(radius); }
  /// Returns the height of the upper surface of the foot at @p radius >= middle_radius() [m].
  double topside(double radius) const { return upper(radius); }
  /// Returns the radius of the stem at @p height >= middle_height() [m].
  double stem_surface(double height) const { return stem(height); }

  /// Returns the outer radius of the foot [m].
  double outer_radius() const { return edge; }
  /// Returns the height of the cut [m].
  double height() const { return stem.x.back(); }
  /// Returns the thickness of the foot at the beginning of the fillet [m].
  double thickness() const { return upper(fillet_end) - lower(fillet_end); }
  /// Returns the radius and the height of the point between foot and stem [m].
  double middle_radius() const { return upper.x.front(); }
  double middle_height() const { return upper.y.front(); }
  /// Returns the radius [m] of the fillet's end on the foot (stem_begin(): height of its end on the stem).
  double fillet_end_radius() const { return fillet_end; }
  double stem_begin() const { return stem_start; }

  /// Returns the radii outside the fillet at which underside or top bend by more than 0.2 rad, ascending [m].
  std::vector<double> corner_radii() const;

  /// Returns the points of the lowest part of the underside, up to @p height [m].
  std::vector<SectionVertex> points_below(double height) const;

private:
  void split(const std::vector<SectionVertex> &polyline);
  void require_glass_everywhere() const;
  void cut_edge();
  void find_rounding();

  PiecewiseLinear lower, upper, stem;
  double edge = 0, fillet_end = 0, stem_start = 0;
};

} // namespace stemware::fem
