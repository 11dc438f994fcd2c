#pragma once

#include "fem/contact/contact_surface.h"

#include <Eigen/Core>

#include <vector>

namespace stemware::fem
{

/// Load per radian of the azimuth, pointwise: not a series cut off after some harmonics.
struct AzimuthLoad
{
  double azimuth = 0; ///< theta [rad]
  double density = 0; ///< lambda [N/rad]
};

/// Index of the sector of @p n_sectors equal ones that holds @p azimuth; sector 0 begins at theta = @p begin.
unsigned int sector_of(double azimuth, double begin, unsigned int n_sectors);

/// Load per radian by azimuth from the force on each line of @p surface: summed over lines of equal
/// azimuth where the lines are radial, over ContactSurface::n_sectors equal sectors
/// (at their middle) where they are not.
std::vector<AzimuthLoad> density_of_lines(const ContactSurface &surface,
                                          const std::vector<double> &line_forces);

/// Load per radian by azimuth from nodal forces: sums over n_sectors equal sectors whose borders avoid the
/// nodes of a regular mesh, at the mean azimuth of their nodes.
std::vector<AzimuthLoad> density_of_nodes(const ContactSurface &surface, const Eigen::VectorXd &node_forces);

} // namespace stemware::fem
