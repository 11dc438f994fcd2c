#pragma once

namespace stemware::ring
{
/// Azimuths [rad] of the marks of glass and table in the slip frame: azimuth chi of the glass is at theta =
/// chi + glass, azimuth chi of the table at theta = chi + table.
struct Orientation
{
  double glass = 0;
  double table = 0;
};

/// Slip on which a load may depend, by friction that deforms the foot or by waviness that rotates.
struct Slip
{
  double spin_per_speed = 0; ///< omega / v [1/m], counter-clockwise > 0
  Orientation orientation;
};
} // namespace stemware::ring
