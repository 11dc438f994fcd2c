#pragma once

#include "fem/contact/contact_surface.h"

#include <functional>
#include <optional>
#include <vector>

namespace stemware::fem
{

/// Pressure on the table at one place.
struct PressurePoint
{
  double radius = 0;   ///< [m]
  double azimuth = 0;  ///< theta [rad]
  double pressure = 0; ///< [Pa]
};

/// The pressure p(r, theta) where the foot is pressed on the table, for pictures: cuts across the contact
/// zone, each by increasing radius.
struct PressureMap
{
  std::vector<std::vector<PressurePoint>> cuts;
  bool is_grid = false; ///< all cuts have equally many points, each at one azimuth, and azimuths increase
  bool has_edge = true; ///< the pressure ends somewhere, and does not only fade as on a rough table

  /// The pressure map turned counter-clockwise by @p angle, azimuths in [0, 2 pi).
  PressureMap turned(double angle) const;
};

/// Radii between which a cut is in contact.
struct ContactWidth
{
  double inner = 0; ///< [m]
  double outer = 0;
};

/// The width of the contact on @p cut of a map, the one definition of all results: where a pressure that has
/// an edge ends, between the points of the cut; of one that only fades the radii that leave half a per cent
/// of the cut's load to either side, so that 99 % lie between them. Nothing where the cut carries no load.
/// The radii of the cut must ascend.
std::optional<ContactWidth> contact_width(const std::vector<PressurePoint> &cut, bool has_edge);

/// PressureMap of a law whose pressure depends on the local penetration alone, @p pressure(penetration [m])
/// [Pa], at an @p normal_displacement as in TableLaw: a grid where the lines of @p surface are radial, else a
/// cut a line.
PressureMap pressure_map_of_lines(const ContactSurface &surface, const Eigen::VectorXd &normal_displacement,
                                  const std::function<double(double)> &pressure);

/// PressureMap of nodal pressures [Pa]: nodes of equal azimuth make a cut.
PressureMap pressure_map_of_nodes(const ContactSurface &surface, const Eigen::VectorXd &pressure);

} // namespace stemware::fem
