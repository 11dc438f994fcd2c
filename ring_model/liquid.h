#pragma once

namespace stemware::ring
{
/// Liquid at rest in a bowl, an upright circular cylinder that moves without turning. The liquid's surface is
/// a plane that rises opposite to the acceleration a, tan(alpha) = |a| / g (docs/theory/liquid.md).
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

  /// Returns the height of the centre of mass above the table [m] at the surface slope @p slope = tan(alpha).
  double centre_height(double slope) const;

  /// Returns the metacentric radius R_b^2 / (4 h) [m]; 0 if the surface does not lean. Its product with
  /// tan(alpha) is the outward displacement of the centre of mass.
  double metacentric_radius() const;

  /// Throws std::invalid_argument for inadmissible values, and if, at the surface slope @p slope =
  /// tan(alpha), the liquid leaves the bowl or its surface meets the bottom.
  void validate(double slope) const;
};
} // namespace stemware::ring
