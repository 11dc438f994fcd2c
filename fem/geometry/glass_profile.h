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

/// Rounding between the top of a foot and its stem: an arc whose centre lies outside the glass. Lengths in m.
struct Fillet
{
  double radius = 0;
  double centre_radius = 0; ///< distance of the arc's centre from the axis
  double centre_height = 0; ///< height of the arc's centre, and of its end at the stem, above the land
  double middle_radius = 0; ///< radius of the point half-way along the arc
  double middle_height = 0;
  double end_radius = 0; ///< radius at which the arc meets the top of the foot
};

/// Foot of the glass as a profile of revolution, SI units (m); formulas in docs/method/profile.md.
///
/// Land of every shape: r within contact_radius -/+ land_width/2, z = 0. The crown is not geometry but gap().
///
/// GlassShape::step: the land is land_height high, the foot (r <= foot_radius) above the land is
/// foot_thickness thick, and the stem (r <= stem_radius) stands on the foot.
///
/// GlassShape::foot: the underside leaves the land tangentially and rises to underside_rise at the axis and
/// to land_height at the outer edge. The top is a cone, foot_thickness above the underside at stem_radius and
/// edge_thickness above it at foot_radius, rounded into the stem with fillet_radius.
///
/// In both shapes the stem cut is stem_height above the top of the foot.
///
/// GlassShape::profile: `section` replaces all lengths but contact_radius, land_width and crown_radius. On
/// the land the underside is lowered to z = 0; beside it the lowering fades out over half a land width.
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
  /// Returns the height of the foot's top at the stem before rounding [m]; undefined for GlassShape::profile.
  double foot_top() const;
  /// Returns the height of the stem cut above the land [m].
  double height() const;
  /// Returns the radius of the foot's edge [m].
  double outer_radius() const;
  /// Returns the thickness of the foot near the stem [m], the length scale of its cells.
  double thickness() const;

  /// Returns the underside's height at @p radius <= outer_radius() [m]. A step's land includes its borders.
  double underside(double radius) const;
  /// Returns the height of the upper surface at @p radius <= outer_radius() [m]; if < stem_radius, height().
  double topside(double radius) const;
  /// Returns the rounding between foot and stem; the corner point for a step or if fillet_radius is 0; for a
  /// profile the part near 45 degrees, not necessarily an arc (radius 0).
  Fillet fillet() const;
  /// Returns the radius of the stem at @p height [m], from the middle of the fillet up to the cut.
  double stem_surface(double height) const;

  /// Returns the distance of the unloaded rim from a plane table [m]: (r - contact_radius)^2 / (2
  /// crown_radius), 0 for a flat land (docs/method.md, "The gap").
  double gap(double radius) const;

  /// Throws std::invalid_argument, naming lengths as a study file does, unless all lengths are finite and
  /// positive (crown, rise, fillet: >= 0), stem_radius < land_inner_radius() and land_outer_radius() <
  /// foot_radius; for a foot, the fillet ends between stem and land, below the cut, and the thickness is
  /// positive everywhere; for a profile, the lowest part is on the land.
  void validate() const;

private:
  double cone_slope() const;
  double cone(double radius) const;
  void validate_foot() const;
  void validate_section() const;
};

} // namespace stemware::fem
