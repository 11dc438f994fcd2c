#pragma once

#include "fem/contact/contact_surface.h"

#include <functional>
#include <vector>

namespace stemware::fem
{

/// Pressure on the table at one place.
struct FootprintPoint
{
  double radius = 0;   ///< [m]
  double azimuth = 0;  ///< theta [rad]
  double pressure = 0; ///< [Pa]
};

/// The pressure p(r, theta) where the foot is pressed on the table, for pictures: cuts across the contact
/// zone, each by increasing radius.
struct Footprint
{
  std::vector<std::vector<FootprintPoint>> cuts;
  bool is_grid = false; ///< all cuts have equally many points, each at one azimuth, and azimuths increase

  /// The footprint turned counter-clockwise by @p angle, azimuths in [0, 2 pi).
  Footprint turned(double angle) const;
};

/// Footprint of a law whose pressure depends on the local penetration alone, @p pressure(penetration [m])
/// [Pa], at an @p approach as in TableLaw: a grid where the lines of @p surface are radial, else a cut a
/// line.
Footprint footprint_of_lines(const ContactSurface &surface, const Eigen::VectorXd &approach,
                             const std::function<double(double)> &pressure);

/// Footprint of nodal pressures [Pa]: nodes of equal azimuth make a cut.
Footprint footprint_of_nodes(const ContactSurface &surface, const Eigen::VectorXd &pressure);

} // namespace stemware::fem
