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

/// Pressure p(r, theta) between foot and table for plots: cuts across the contact zone, each by increasing
/// radius.
struct PressureMap
{
  std::vector<std::vector<PressurePoint>> cuts;
  bool is_grid = false; ///< true if all cuts have equally many points, each cut has one azimuth, and azimuths
                        ///< increase
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

/// Returns the contact width of @p cut, as used in all results. With an edge: the interpolated zero of the
/// pressure. Decaying pressure: the radii that enclose 99 % of the cut's load, half a per cent outside on
/// either side. std::nullopt without load. The radii of the cut must ascend.
std::optional<ContactWidth> contact_width(const std::vector<PressurePoint> &cut, bool has_edge);

/// Returns the map of a law @p pressure(penetration [m]) [Pa], at @p normal_displacement as in TableLaw: a
/// grid if the lines of @p surface are radial, else one cut a line.
PressureMap pressure_map_of_lines(const ContactSurface &surface, const Eigen::VectorXd &normal_displacement,
                                  const std::function<double(double)> &pressure);

/// Returns the map of nodal pressures [Pa]; nodes of equal azimuth make a cut.
PressureMap pressure_map_of_nodes(const ContactSurface &surface, const Eigen::VectorXd &pressure);

} // namespace stemware::fem
