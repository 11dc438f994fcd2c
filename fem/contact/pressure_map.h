#pragma once

#include "fem/contact/contact_surface.h"

#include <functional>
#include <optional>
#include <vector>

namespace stemware::fem
{

/// Pressure at a point of the table.
struct PressurePoint
{
  double radius = 0;   ///< [m]
  double azimuth = 0;  ///< theta [rad]
  double pressure = 0; ///< [Pa]
};

/// Pressure p(r, theta) between foot and table for plots: cuts across the contact, by increasing radius.
struct PressureMap
{
  std::vector<std::vector<PressurePoint>> cuts;
  bool is_grid = false; ///< cuts of equally many points, each at one azimuth; azimuths increase
  bool has_edge = true; ///< the pressure ends at an edge; false: it decays (rough interface)

  /// Returns the map rotated counter-clockwise by @p angle, with azimuths in [0, 2 pi).
  PressureMap rotated(double angle) const;
};

/// Radii between which a cut is in contact.
struct ContactWidth
{
  double inner = 0; ///< [m]
  double outer = 0;
};

/// Returns the contact width of @p cut (ascending radii), as used in all results: between the interpolated
/// zeros, or, of a decaying pressure, with 0.5 % of the load outside on either side; std::nullopt without
/// load.
std::optional<ContactWidth> contact_width(const std::vector<PressurePoint> &cut, bool has_edge);

/// Returns the map of a law @p pressure(penetration [m]) [Pa]; @p normal_displacement as in TableLaw. A grid
/// if the lines of @p surface are radial, else one cut a line.
PressureMap pressure_map_of_lines(const ContactSurface &surface, const Eigen::VectorXd &normal_displacement,
                                  const std::function<double(double)> &pressure);

/// Returns the map of nodal pressures [Pa]; nodes of equal azimuth make a cut.
PressureMap pressure_map_of_nodes(const ContactSurface &surface, const Eigen::VectorXd &pressure);

} // namespace stemware::fem
