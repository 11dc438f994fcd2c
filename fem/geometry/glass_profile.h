#pragma once

#include <memory>

namespace stemware::fem
{

class MeridianSection;

/// Kind of section that a GlassProfile describes.
enum class GlassShape
{
  step,   ///< three cylinders: land, foot, stem; every corner is sharp
  foot,   ///< the foot of a wine glass: concave below, tapering to its edge, rounded into the stem
  profile ///< polyline given by the user: GlassProfile::section
};

/// Rounding between the top of a foot and its stem: an arc of the fillet's radius whose centre lies outside
/// the glass. Lengths in m.
struct Fillet
{
  double radius = 0;
  double centre_radius = 0; ///< distance of the arc's centre from the axis
  double centre_height = 0; ///< height of the arc's centre, and of the arc's end at the stem, above the land
  double middle_radius = 0; ///< radius of the point half-way along the arc
  double middle_height = 0;
  double end_radius = 0; ///< radius at which the arc meets the top of the foot
};

/// Foot of the glass as a profile of revolution, SI units (m); formulas in docs/method/profile.md.
///
/// Land, in every shape: r within contact_radius -/+ land_width/2, lower face at z = 0. The crown is a gap
/// (see gap()), not geometry: a crown of 3 mm rises 0.7 mm at the border of a 4 mm land, where contact never
/// occurs.
///
/// GlassShape::step: the land is land_height high, the foot (r <= foot_radius) above the land is
/// foot_thickness thick, and the stem (r <= stem_radius) stands on the foot.
///
/// GlassShape::foot: the underside leaves the land tangentially, rises to underside_rise at the axis and to
/// land_height at the outer edge. The top is a cone from foot_thickness above the underside at r =
/// stem_radius to edge_thickness above it at r = foot_radius, rounded into the stem with fillet_radius.
///
/// In both shapes the stem ends stem_height above the top of the foot, at the stem cut.
///
/// GlassShape::profile: underside, top and stem come from `section`, which also gives the outer radius and
/// the height of the cut; only the lengths contact_radius, land_width and crown_radius are used. On the
/// land the underside is lowered to z = 0; beside the land the lowering fades out over half a land width.
struct GlassProfile
{
  GlassShape shape = GlassShape::step;
  double contact_radius = 0.030;
  double foot_radius = 0.034;
  double foot_thickness = 0.004; ///< thickness of a foot at the stem's surface, before rounding
  double land_width = 0.004;
  double land_height = 0.001;  ///< height of a foot's underside at the outer edge
  double crown_radius = 0.003; ///< radius of the rim's rounding; 0 means a flat land
  double stem_radius = 0.005;
  double stem_height = 0.010; ///< height of the stem from the top of the foot to the cut

  double underside_rise = 0.003;  ///< height of a foot's underside on the axis
  double edge_thickness = 0.0015; ///< thickness of a foot at the outer edge
  double fillet_radius = 0.005;   ///< rounding between the top of a foot and the stem; 0: a sharp corner

  std::shared_ptr<const MeridianSection> section = {}; ///< section of a user-defined profile

  /// Returns the inner border of the land [m].
  double land_inner_radius() const { return contact_radius - land_width / 2; }
  /// Returns the outer border of the land [m].
  double land_outer_radius() const { return contact_radius + land_width / 2; }
  /// Returns the height of the foot's top at the stem's surface, before rounding [m]; undefined for
  /// GlassShape::profile.
  double foot_top() const;
  /// Returns the height of the stem cut above the land [m].
  double height() const;
  /// Returns the radius of the foot's edge [m].
  double outer_radius() const;
  /// Returns the thickness of the foot near the stem [m], the length scale of its cells.
  double thickness() const;

  /// Returns the height of the lower surface at @p radius <= outer_radius() [m]. The borders of a step's land
  /// belong to the land.
  double underside(double radius) const;
  /// Returns the height of the upper surface at @p radius <= outer_radius() [m]; for r < stem_radius the
  /// height of the stem cut.
  double topside(double radius) const;
  /// Returns the rounding between foot and stem; a point (the corner) for a step or if fillet_radius is 0.
  /// For a profile: the part near 45 degrees between foot and stem, not necessarily an arc (radius 0).
  Fillet fillet() const;
  /// Returns the radius of the stem at @p height [m], from the middle of the fillet up to the cut.
  double stem_surface(double height) const;

  /// Returns the distance of the unloaded rim from a plane table [m]: (r - contact_radius)^2 / (2
  /// crown_radius), 0 for a flat land (docs/method.md, "The gap"). With a parabola, the penetration of
  /// quadratic elements is a polynomial along r.
  double gap(double radius) const;

  /// Throws std::invalid_argument, with lengths named as in a study file, if a length is not positive and
  /// finite (crown, rise and fillet may be 0) or the parts do not fit: stem_radius < land_inner_radius(),
  /// land_outer_radius() < foot_radius; for a foot also a fillet that ends between stem and land and below
  /// the cut, and a positive thickness everywhere; for a profile a lowest part that lies on the land.
  void validate() const;

private:
  double cone_slope() const;
  double cone(double radius) const;
  void validate_foot() const;
  void validate_section() const;
};

} // namespace stemware::fem
