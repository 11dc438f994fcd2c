#pragma once

#include <vector>

namespace stemware::pipeline
{

/// Numerical parameters of a foot beyond the entries of a study: changed by error bands, goals and the page.
struct Discretisation
{
  double fineness = 1;                   ///< refinement of the cells over the default
  unsigned int halvings_beyond_zone = 0; ///< halvings of cells, see fem::RevolutionSetup
  /// Penalty of a hard interface over the default; below 1 for a solid foot: of any interface over its own
  /// stiffness.
  double hardness = 1;
  unsigned int line_factor = 1; ///< contact lines of each face of a solid foot, over the default
  std::vector<std::vector<unsigned int>> halved_cells = {}; ///< numbers of the halved cells, mesh after mesh
};

/// Parts of the model of a foot that a budget leaves out one at a time.
struct Model
{
  bool foot_is_rigid = false;        ///< the foot has no compliance
  bool friction_in_foot = true;      ///< friction deforms the foot, if Study::friction_deforms()
  bool friction_in_substrate = true; ///< and an elastic substrate
};

} // namespace stemware::pipeline
