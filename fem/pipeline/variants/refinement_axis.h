#pragma once

#include "fem/pipeline/variants/variant.h"

#include <string>
#include <vector>

namespace stemware::pipeline
{

/// A study with one of its numerical parameters replaced.
struct RefinementLevel : Variant
{
  unsigned int size = 0; ///< that parameter
};

/// How the error of a discretised quantity falls from one level to the next.
enum class Decay
{
  algebraic, ///< like size^p, sizes halved from level to level: meshes
  spectral   ///< faster than any fixed order as long as the solution is smooth: harmonics, lines, degrees
};

/// Role of a refinement axis in the error band.
enum class AxisRole
{
  space, ///< halves sizes in one direction: the bands of these axes add up
  order, ///< raises the degree, which lessens the same errors as halved sizes: counts where its band is wider
  azimuth ///< harmonics and azimuth lines: their bands are added
};

/// One numerical parameter of a study on ever finer levels, all others as the study has them.
struct RefinementAxis
{
  std::string key;           ///< in summary.json and names of files: "meridional_mesh"
  std::string name;          ///< for people: "meridional mesh"
  std::string size;          ///< what the sizes count: "halvings of every cell"
  bool sizes_double = false; ///< from level to level; else they are counted on
  Decay decay = Decay::algebraic;
  AxisRole role = AxisRole::space;
  std::vector<RefinementLevel> levels = {}; ///< coarsest first
  std::size_t own = 0;                      ///< the level that is the study itself
  bool is_graded = false; ///< levels are meshes for the goal of the study: each has few cells more
};

/// All axes of @p study with up to @p n_levels levels each, of which the study's own is the first where the
/// parameter can only grow, else the second. Axes on which the study has one level only are left out.
///
/// A body of revolution: meridional mesh, degree, harmonics, azimuth lines (on a mat or rough table, where
/// they are free). A solid body: cells round the rim, across the land and through the foot, degree; of a mesh
/// file only the degree. Throws BadInput for a load that needs no contact, and where nothing can be refined.
std::vector<RefinementAxis> refinement_axes(const Study &study, unsigned int n_levels);

/// How many azimuths tell where the contact of @p study ends.
unsigned int n_contact_azimuths(const Study &study);

} // namespace stemware::pipeline
