#pragma once

#include <vector>

namespace stemware::fem
{

/// One harmonic of an out-of-flat rim or table: gap = amplitude * cos n (chi - azimuth) [m], chi in the frame
/// of the glass or of the ground. At t = 0 chi is counted from the direction that points away from the
/// orbit's centre. The gap is constant across the rim, except for n = 1: a tilt, proportional to r, whose
/// amplitude holds at the contact radius.
struct WavinessHarmonic
{
  unsigned int n = 2;
  double amplitude = 0; ///< [m]
  double azimuth = 0;   ///< azimuth of a crest, the point of largest gap [rad]
};

/// Out-of-flat rim and table: gap in addition to the crown's gap. Harmonics 0 and 1 are an offset and a tilt,
/// which the table motions absorb.
struct RimImperfection
{
  std::vector<WavinessHarmonic>
    glass; ///< fixed to the glass, positive where the rim is higher above the table
  std::vector<WavinessHarmonic> table; ///< fixed to the ground, positive where the table is lower

  bool empty() const { return glass.empty() && table.empty(); }
  /// Returns the additional distance at r = @p radius_ratio times the contact radius and the azimuth @p
  /// theta of the slip frame [m]. The marks chi = 0 of the glass and of the ground are at @p of_glass and
  /// @p of_table.
  double gap(double radius_ratio, double theta, double of_glass, double of_table) const;
  /// Returns a bound of gap() at the contact radius [m].
  double max_amplitude() const;
  /// Throws std::invalid_argument unless all amplitudes and azimuths are finite.
  void validate() const;
};

} // namespace stemware::fem
