#pragma once

namespace stemware::ring
{
/// Liquid at rest in a bowl, an upright circular cylinder that moves without turning. The surface of the
/// liquid is a plane that rises opposite to the acceleration a, by tan(alpha) = |a| / g
/// (docs/theory/liquid.md). SI units.
struct Liquid
{
  double mass = 0.;           ///< [kg]; 0: the bowl is empty
  double density = 990.;      ///< [kg/m^3]
  double bowl_radius = 0.035; ///< R_b, inner radius at the surface [m]
  double bowl_height = 0.09;  ///< height of the bowl's bottom above the table [m]
  double bowl_depth = 0.09;   ///< depth from the bottom to the brim [m]
  bool surface_leans = true;  ///< false: the liquid is a solid with a level surface

  /// Returns the depth h of the liquid under a level surface [m].
  double level() const;

  /// Returns the height of the centre of mass above the table [m] if the surface leans by @p slope =
  /// tan(alpha).
  double centre_height(double slope) const;

  /// Returns the distance R_b^2 / (4 h) [m] from the centre of mass up to the metacentre. Times tan(alpha) it
  /// is the outward displacement of the centre of mass. 0 if the surface does not lean.
  double metacentric_radius() const;

  /// Throws std::invalid_argument with one sentence for values that are not allowed, for liquid that leaves
  /// the bowl, and for a surface that meets the bottom, at @p slope = tan(alpha).
  void validate(double slope) const;
};
} // namespace stemware::ring
