#pragma once

#include <vector>

namespace stemware::fem
{

/// One harmonic of an out-of-flat rim or table: gap = amplitude * cos n (chi - azimuth) [m], chi in the frame
/// of the glass or of the ground; at t = 0, chi = 0 points away from the orbit's centre. The gap is constant
/// across the rim, for n = 1 proportional to r (a tilt), with the amplitude at the contact radius.
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
  std::vector<WavinessHarmonic> glass; ///< fixed to the glass, positive: rim higher
  std::vector<WavinessHarmonic> table; ///< fixed to the ground, positive: table lower

  bool empty() const { return glass.empty() && table.empty(); }
  /// Returns the gap [m] at r = @p radius_ratio times the contact radius and the azimuth @p theta of the slip
  /// frame, with the marks chi = 0 of glass and ground at @p of_glass and @p of_table.
  double gap(double radius_ratio, double theta, double of_glass, double of_table) const;
  /// Returns a bound of gap() at the contact radius [m].
  double max_amplitude() const;
  /// Throws std::invalid_argument unless all amplitudes and azimuths are finite.
  void validate() const;
};

} // namespace stemware::fem
