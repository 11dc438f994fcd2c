#pragma once

#include "fem/geometry/glass_profile.h"

#include <algorithm>
#include <vector>

namespace stemware::fem
{

/// Resolution of a meridional mesh. The contact cells depend on the glass only, so that a foot and a disc
/// of equal resolution share them.
struct MeridianResolution
{
  unsigned int land_cells = 4; ///< across the land, even; before any refinement
  double land_grading = 3; ///< size ratio of neighbours on the land, finest at the contact radius; 1 means
                           ///< equal cells. Not read where there is a focus
  unsigned int refinements = 0; ///< halvings of every cell

  /// Size of the contact cells in the focus, the band focus_radius -/+ focus_width [m]; 0: no focus. Outside
  /// the band they grow with their distance from it, and so do the cells behind them.
  double focus_size = 0;
  double focus_radius = 0;    ///< [m]; 0 means the contact radius
  double focus_width = 0;     ///< half the width of the band [m]; 0: the cells next to focus_radius
  double focus_growth = 1.75; ///< a cell is at most growth - 1 times its distance from the band large

  bool has_focus() const { return focus_size > 0; }
  /// Largest cell at @p distance from the focus [m].
  double size_at(double distance) const { return std::max(focus_size, (focus_growth - 1) * distance); }

  /// Throws std::invalid_argument for inadmissible counts, ratios and lengths.
  void validate() const;
};

/// Division of the land into contact cells, common to all bodies that touch it.
struct ContactCells
{
  std::vector<double> coarse;           ///< borders of the cells that a mesh begins with, ascending [m]
  std::vector<double> borders;          ///< after the halvings towards the focus; contains `coarse`
  std::vector<unsigned int> n_halvings; ///< of the coarse cell that each contact cell is a part of
  double coarse_size = 0;               ///< of the smallest, or with a focus of most of the coarse cells [m]
  bool has_focus = false;
  double focus_begin = 0; ///< the band that MeridianResolution::focus_size holds in [m]
  double focus_end = 0;
};

/// Contact cells of a land before MeridianResolution::refinements: land_cells graded towards the contact
/// radius, or, with a focus, about equal cells halved until there are at least land_cells and until the cells
/// in the focus have its size and no neighbours differ by more than one halving. Throws std::invalid_argument
/// as both validate(), and for a focus outside the land.
ContactCells contact_cells(const GlassProfile &profile, const MeridianResolution &resolution);

/// Share of a foot's thickness that the lowest row of cells takes where there is no focus (GlassShape::foot).
constexpr double lowest_level = 0.3;

/// Height of that row at the contact radius [m]; in a step the height of the land.
double lowest_cell_height(const GlassProfile &profile);

} // namespace stemware::fem
