#pragma once

#include "fem/contact/pressure_map.h"

#include <vector>

/// Measures of a pressure map for pictures and captions. The map has cuts, each with a point at least.
namespace stemware::fem
{

/// Whether a footprint is a grid with several points across the contact.
bool has_cells(const PressureMap &footprint);

/// The largest pressure [Pa].
double largest_pressure(const PressureMap &footprint);

/// Least and largest radius in contact at any azimuth, by contact_width(); of points that are no grid, of
/// those under pressure. The footprint must have a point under pressure.
ContactWidth loaded_band(const PressureMap &footprint);

/// The cuts between the edges of their pressure. Of a footprint with cells: every so many, the first one
/// again after a whole turn, each at equally many places from edge to edge, which lie between the points of
/// the grid; the pressure is not a number where a cut has no load. Of others: the points under pressure.
std::vector<std::vector<PressurePoint>> loaded_cuts(const PressureMap &footprint);

/// How hard and how wide a footprint with cells is in contact.
struct FootprintMeasures
{
  PressurePoint largest; ///< of all points
  double mean = 0;       ///< pressure over the contact [Pa]; not a number where nothing is loaded
  double narrowest = 0;  ///< width of the contact at any azimuth [m], 0 where a cut has no load
  double widest = 0;
};

FootprintMeasures measures_of(const PressureMap &footprint);

} // namespace stemware::fem
