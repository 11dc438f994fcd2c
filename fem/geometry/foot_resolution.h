#pragma once

#include "fem/geometry/glass_profile.h"

namespace stemware::fem
{

/// Resolution of a generated foot mesh; counts are of cells.
struct FootResolution
{
  unsigned int azimuthal_cells = 48; ///< round the rim; a multiple of 4, at least 8
  unsigned int radial_cells = 4;     ///< across the land; even, so that r = contact_radius is a mesh line
  unsigned int foot_layers = 2;      ///< through the thickness of the foot
  unsigned int refinements = 0;      ///< halvings of every cell of the mesh with these counts
  /// Further halvings at the land's inner side, where a flat land on a hard table has most pressure: in a
  /// step up to the re-entrant corner, otherwise one cell wide. They make hanging nodes.
  unsigned int edge_halvings = 0;

  /// Throws std::invalid_argument for inadmissible counts.
  void validate() const;
};

/// Returns FootResolution::edge_halvings for @p profile: more than 0 for a flat land on a hard table.
unsigned int edge_halvings_for(const GlassProfile &profile, bool table_is_hard);

} // namespace stemware::fem
