#pragma once

#include "fem/contact/contact_surface.h"

#include <Eigen/Core>

#include <vector>

namespace stemware::fem
{

/// Value at one azimuth, as the pointwise load per radian lambda [N/rad], without truncation of its series.
struct AzimuthValue
{
  double azimuth = 0; ///< theta [rad]
  double value = 0;
};

/// Returns the index of the sector at @p azimuth, of @p n_sectors equal sectors from @p begin on.
unsigned int sector_of(double azimuth, double begin, unsigned int n_sectors);

/// Returns one value per cut (contact lines of equal azimuth) of the whole @p surface, sorted by azimuth,
/// from one value per own (radial) line, merged in pairs by @p combine. Collective.
std::vector<AzimuthValue> values_of_cuts(const ContactSurface &surface,
                                         const std::vector<double> &line_values,
                                         double (*combine)(double, double));

/// Returns the largest value between @p cuts (sorted by azimuth): maximum of the polynomial through the
/// largest and three neighbours on either side, or one neighbour next to the contact's end.
double largest_between(const std::vector<AzimuthValue> &cuts);

/// Returns the load per radian by azimuth from the force on each line of @p surface: sums of radial lines by
/// azimuth, of others over ContactSurface::n_sectors equal sectors, at their middle.
std::vector<AzimuthValue> density_of_lines(const ContactSurface &surface,
                                           const std::vector<double> &line_forces);

/// Returns the load per radian by azimuth from nodal forces: sums over n_sectors equal sectors, at the mean
/// azimuth of their nodes. Sector borders avoid the nodes of a regular mesh.
std::vector<AzimuthValue> density_of_nodes(const ContactSurface &surface, const Eigen::VectorXd &node_forces);

} // namespace stemware::fem
