#pragma once

namespace stemware::ring
{
/// Azimuths of the marks of glass and table in the slip frame: a mark at azimuth chi of the glass is at
/// theta = chi + glass, one of the table at theta = chi + table [rad].
struct Orientation
{
  double glass = 0;
  double table = 0;
};

/// Slip state that the normal load may depend on: friction that deforms the foot acts along the slip, and
/// waviness of rim or table rotates under the load.
struct Slip
{
  double spin_per_speed = 0; ///< omega / v [1/m], counter-clockwise > 0
  Orientation orientation;
};
} // namespace stemware::ring
