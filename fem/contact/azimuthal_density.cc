#include "fem/contact/azimuthal_density.h"

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace stemware::fem
{

namespace
{

/// Index of the sector of @p n_sectors, the first of which begins at theta = @p begin, that holds @p azimuth.
unsigned int sector_of(double azimuth, double begin, unsigned int n_sectors)
{
  const double turns = (azimuth - begin) / boost::math::double_constants::two_pi;
  const auto index = static_cast<unsigned int>((turns - std::floor(turns)) * n_sectors);
  return std::min(index, n_sectors - 1);
}

/// Azimuths closer than this belong to one cut; the lines of one cut differ by rounding only.
constexpr double azimuth_tolerance = 1e-7;

std::vector<AzimuthLoad> density_of_cuts(const ContactSurface &surface,
                                         const std::vector<double> &line_forces)
{
  std::vector<unsigned int> order(line_forces.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto comes_before = [&](unsigned int i, unsigned int j)
  { return surface.lines[i].azimuth < surface.lines[j].azimuth; };
  if (!std::is_sorted(order.begin(), order.end(), comes_before)) // as the lines of a body of revolution are
    std::sort(order.begin(), order.end(), comes_before);
  std::vector<AzimuthLoad> density;
  for (const unsigned int i : order)
  {
    const ContactLine &line = surface.lines[i];
    if (density.empty() || line.azimuth - density.back().azimuth > azimuth_tolerance)
      density.push_back({ line.azimuth, 0 });
    density.back().density += line_forces[i] / line.azimuth_width;
  }
  return density;
}
} // namespace

std::vector<AzimuthLoad> density_of_lines(const ContactSurface &surface,
                                          const std::vector<double> &line_forces)
{
  if (surface.lines_are_radial)
    return density_of_cuts(surface, line_forces);
  std::vector<AzimuthLoad> density(surface.n_sectors);
  for (unsigned int s = 0; s < surface.n_sectors; ++s)
    density[s].azimuth = boost::math::double_constants::two_pi * (s + 0.5) / surface.n_sectors;
  for (unsigned int i = 0; i < line_forces.size(); ++i)
    density[sector_of(surface.lines[i].azimuth, 0, surface.n_sectors)].density +=
      line_forces[i] * surface.n_sectors / boost::math::double_constants::two_pi;
  return density;
}

std::vector<AzimuthLoad> density_of_nodes(const ContactSurface &surface, const Eigen::VectorXd &node_forces)
{
  // A quarter of a sector before a node: neither corner nor mid-side nodes then lie on a border between
  // sectors.
  const double first = std::atan2(surface.node_position(0, 1), surface.node_position(0, 0));
  const double begin = first - boost::math::double_constants::two_pi / (4 * surface.n_sectors);
  std::vector<AzimuthLoad> density(surface.n_sectors);
  std::vector<unsigned int> n_nodes(surface.n_sectors, 0);
  for (unsigned int i = 0; i < surface.n_nodes(); ++i)
  {
    const double azimuth = std::atan2(surface.node_position(i, 1), surface.node_position(i, 0));
    const unsigned int sector = sector_of(azimuth, begin, surface.n_sectors);
    density[sector].density += node_forces(i) * surface.n_sectors / boost::math::double_constants::two_pi;
    const double turns = (azimuth - begin) / boost::math::double_constants::two_pi;
    density[sector].azimuth +=
      (turns - std::floor(turns)) * boost::math::double_constants::two_pi; // from `begin`, summed
    ++n_nodes[sector];
  }
  for (unsigned int s = 0; s < surface.n_sectors; ++s)
    density[s].azimuth =
      begin + (n_nodes[s] > 0 ? density[s].azimuth / n_nodes[s]
                              : boost::math::double_constants::two_pi * (s + 0.5) / surface.n_sectors);
  return density;
}

} // namespace stemware::fem
