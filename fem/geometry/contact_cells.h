#pragma once

#include "fem/geometry/glass_profile.h"

#include <algorithm>
#include <vector>

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

/// Resolution of a meridional mesh. Foot and disc of equal resolution have the same contact cells.
struct MeridianResolution
{
  unsigned int land_cells = 4; ///< across the land, even; before any refinement
  double land_grading = 3; ///< size ratio of neighbouring cells on the land, smallest at the contact radius;
                           ///< 1: equal. Ignored with a focus
  unsigned int refinements = 0; ///< halvings of every cell

  /// Size of the contact cells in the focus, the band focus_radius -/+ focus_width [m]; 0: no focus. Outside,
  /// the cell size grows with the distance from the band, also above the land.
  double focus_size = 0;
  double focus_radius = 0;    ///< [m]; 0 means the contact radius
  double focus_width = 0;     ///< half the width of the band [m]; 0: the cells next to focus_radius
  double focus_growth = 1.75; ///< bound of the cell size: (growth - 1) times the distance from the band

  bool has_focus() const { return focus_size > 0; }
  /// Returns the bound of the cell size at @p distance from the focus [m].
  double size_at(double distance) const { return std::max(focus_size, (focus_growth - 1) * distance); }

  /// Throws std::invalid_argument for inadmissible counts, ratios and lengths.
  void validate() const;
};

/// Division of the land into contact cells, shared by foot and disc.
struct ContactCells
{
  std::vector<double> coarse;           ///< borders of the cells of the unrefined mesh, ascending [m]
  std::vector<double> borders;          ///< after the halvings towards the focus; contains `coarse`
  std::vector<unsigned int> n_halvings; ///< halvings of the coarse cell, for each contact cell
  double coarse_size = 0; ///< size of the smallest coarse cell; with a focus, of most coarse cells [m]
  bool has_focus = false;
  double focus_begin = 0; ///< band of the size MeridianResolution::focus_size [m]
  double focus_end = 0;
};

/// Returns the contact cells of a land before MeridianResolution::refinements. Without a focus: land_cells
/// cells, graded towards the contact radius. With a focus: at least land_cells, nearly equal, halved to the
/// size of the focus in the focus; neighbours differ by at most one halving. Throws std::invalid_argument as
/// both validate(), and for a focus outside the land.
ContactCells contact_cells(const GlassProfile &profile, const MeridianResolution &resolution);

/// Height of the lowest row of cells over the thickness of the foot, for GlassShape::foot without a focus.
constexpr double lowest_level = 0.3;

/// Returns the height of the lowest row of cells at the contact radius [m]; for a step, the land's height.
double lowest_cell_height(const GlassProfile &profile);

} // namespace stemware::fem
