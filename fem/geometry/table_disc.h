#pragma once

#include "fem/geometry/glass_profile.h"

namespace stemware::fem
{

/// Thick disc under the glass, coaxial with the ring: its upper side is the table, its bottom is fixed.
struct TableDisc
{
  double radius = 0.150;    ///< [m], larger than the land's outer radius
  double thickness = 0.050; ///< [m]

  /// Throws std::invalid_argument unless both lengths are positive and finite and the land is on the disc.
  void validate(const GlassProfile &profile) const;
};

} // namespace stemware::fem
