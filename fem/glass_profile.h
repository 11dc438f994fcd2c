#pragma once

namespace stemware::fem
{

/// The foot of the glass as a step profile of revolution, SI units (m).
///
/// Land: r within contact_radius -/+ land_width/2, 0 <= z <= land_height. Foot: r <= foot_radius,
/// foot_thickness above the land. Stem: r <= stem_radius, stem_height above the foot; its upper end is the
/// stem cut. The land's lower face carries the crown only as a gap (see gap()), not as geometry: a crown of 3
/// mm rises 0.7 mm at the border of a 4 mm land, where contact never comes.
struct GlassProfile
{
  double contact_radius = 0.030;
  double foot_radius = 0.034;
  double foot_thickness = 0.004;
  double land_width = 0.004;
  double land_height = 0.001;
  double crown_radius = 0.003; ///< radius of the rim's rounding; 0 means a flat land
  double stem_radius = 0.005;
  double stem_height = 0.010; ///< from the top of the foot to the cut

  /// Inner border of the land [m].
  double land_inner_radius() const { return contact_radius - land_width / 2; }
  /// Outer border of the land [m].
  double land_outer_radius() const { return contact_radius + land_width / 2; }
  /// Height of the stem cut above the land [m].
  double height() const { return land_height + foot_thickness + stem_height; }

  /// Distance of the unloaded rim from a plane table [m]: (r - contact_radius)^2 / (2 crown_radius), 0 for a
  /// flat land (docs/method.md, "The gap"). A parabola on purpose: along r the penetration of a quadratic
  /// element stays a polynomial.
  double gap(double radius) const;

  /// Throws std::invalid_argument with one sentence when a length is not positive and finite (land, crown: as
  /// noted above) or when the parts do not fit: stem_radius < land_inner_radius() and land_outer_radius() <
  /// foot_radius.
  void validate() const;
};

} // namespace stemware::fem
