#pragma once

#include <vector>

namespace stemware::fem
{

/// Point of a drawn meridian [m].
struct SectionVertex
{
  double radius = 0;
  double height = 0;
  unsigned int line = 0; ///< where it stands in its file, for messages
};

/// y over x, straight between points of strictly increasing x.
struct PiecewiseLinear
{
  std::vector<double> x, y;
  std::vector<unsigned int> lines; ///< of a file, where the points stand

  void add(double at, double value, unsigned int line);

  /// Constant before the first and after the last point.
  double operator()(double at) const;
};

/// Section of a foot between its axis and a polyline, as three curves: the underside over r, the top of
/// the foot over r, the stem's surface over z. Heights count from the lowest point of the polyline.
///
/// The polyline begins on the axis under the foot, runs outwards along the underside, round the edge, back
/// over the top, up the stem, and ends on the axis with the horizontal cut through the stem; the other way
/// round is as good. Where the foot turns into the stem is the last place, seen from the edge, below which it
/// rises by less than 45 degrees. An edge is cut off where the foot is thinner than a twentieth of its
/// thickness above its lowest point.
class MeridianSection
{
public:
  /// Points closer than 1e-5 of the largest radius to the line between their neighbours are left out first.
  /// Throws std::invalid_argument with one sentence that names the point and its line for a polyline that is
  /// open, upside down, crosses itself, or whose underside or top has two heights at one radius.
  explicit MeridianSection(std::vector<SectionVertex> polyline);

  /// Height of the lower surface at @p radius [m].
  double underside(double radius) const { return lower(radius); }
  /// Height of the upper surface of the foot at @p radius >= middle_radius() [m].
  double topside(double radius) const { return upper(radius); }
  /// Radius of the stem at @p height >= middle_height() [m].
  double stem_surface(double height) const { return stem(height); }

  /// Radius at which the foot ends [m].
  double outer_radius() const { return edge; }
  /// Height of the cut [m].
  double height() const { return stem.x.back(); }
  /// Thickness where the top of the foot begins to turn into the stem [m].
  double thickness() const { return upper(fillet_end) - lower(fillet_end); }
  /// Point between foot and stem [m].
  double middle_radius() const { return upper.x.front(); }
  double middle_height() const { return upper.y.front(); }
  /// Radius where the top of the foot begins to turn into the stem, and height where the stem begins to be
  /// steep [m]; those of the meeting point where there is no rounding.
  double fillet_end_radius() const { return fillet_end; }
  double stem_begin() const { return stem_start; }

  /// Radii outside the rounding where underside or top bend by more than 0.2 rad, ascending [m].
  std::vector<double> corner_radii() const;

  /// Points of the underside no higher than @p height [m]: of the lowest part.
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
