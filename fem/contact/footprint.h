#pragma once

#include "fem/contact/pressure_map.h"

#include <vector>

/// Measures of a pressure map for plots and captions. The map has at least one point in every cut.
namespace stemware::fem
{

/// Returns whether a footprint is a grid with several points across the contact.
bool has_cells(const PressureMap &footprint);

/// Returns the largest pressure [Pa].
double largest_pressure(const PressureMap &footprint);

/// Returns the smallest and largest radius in contact: by contact_width() on a grid, else of the points under
/// pressure. At least one point must be under pressure.
ContactWidth loaded_band(const PressureMap &footprint);

/// Returns the loaded parts of cuts. Grid: a subset of the cuts, the first one repeated after a full turn,
/// with equally many points; NaN pressure on a cut without load. No grid: points under pressure.
std::vector<std::vector<PressurePoint>> loaded_cuts(const PressureMap &footprint);

/// Largest pressure and width of a footprint with cells.
struct FootprintMeasures
{
  PressurePoint largest; ///< point of largest pressure
  double mean = 0;       ///< mean pressure over the contact [Pa]; NaN without load
  double narrowest = 0;  ///< smallest width of the contact [m]; 0 if a cut has no load
  double widest = 0;     ///< largest width of the contact [m]
};

/// Returns the measures of @p footprint.
FootprintMeasures measures_of(const PressureMap &footprint);

} // namespace stemware::fem
