#pragma once

#include "fem/contact_surface.h"

namespace stemware::fem
{

/// Load per radian [N/rad] by azimuth from the force on each line of @p surface: summed over lines of equal
/// azimuth where the lines are radial, over ContactSurface::n_sectors equal sectors where they are not.
std::vector<double> density_of_lines(const ContactSurface &surface, const std::vector<double> &line_forces);

/// The same from nodal forces: sums over n_sectors equal sectors whose borders avoid the nodes of a regular
/// mesh.
std::vector<double> density_of_nodes(const ContactSurface &surface, const Eigen::VectorXd &node_forces);

} // namespace stemware::fem
