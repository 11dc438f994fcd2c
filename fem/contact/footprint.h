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

/// Returns the smallest and largest radius in contact at any azimuth, by contact_width(); without a grid,
/// those of the points under pressure. The footprint must have a point under pressure.
ContactWidth loaded_band(const PressureMap &footprint);

/// Cuts between the edges of their pressure. Of a footprint with cells: every so many, the first one
/// again after a whole turn, each at equally many places from edge to edge, which lie between the points of
/// the grid; the pressure is not a number where a cut has no load. Of others: the points under pressure.
std::vector<std::vector<PressurePoint>> loaded_cuts(const PressureMap &footprint);

/// Largest pressure and width of a footprint with cells.
struct FootprintMeasures
{
  PressurePoint largest; ///< of all points
  double mean = 0;       ///< pressure over the contact [Pa]; not a number where nothing is loaded
  double narrowest = 0;  ///< width of the contact at any azimuth [m], 0 where a cut has no load
  double widest = 0;
};

FootprintMeasures measures_of(const PressureMap &footprint);

} // namespace stemware::fem
