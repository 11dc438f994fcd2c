#include "fem/contact/azimuthal_density.h"

#include "ring_model/load/constants.h"
#include "ring_model/load/lagrange.h"

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace stemware::fem
{

namespace
{

/// Maximum azimuth difference between lines of the same cut [rad], far larger than rounding errors.
constexpr double azimuth_tolerance = 1e-7;

std::vector<AzimuthValue> combined(std::vector<AzimuthValue> places, double (*combine)(double, double))
{
  const auto comes_before = [](const AzimuthValue &one, const AzimuthValue &other)
  { return one.azimuth < other.azimuth; };
  // The lines of a body of revolution are already sorted.
  if (!std::is_sorted(places.begin(), places.end(), comes_before))
    std::stable_sort(places.begin(), places.end(), comes_before);
  std::vector<AzimuthValue> cuts;
  for (const AzimuthValue &place : places)
    if (cuts.empty() || place.azimuth - cuts.back().azimuth > azimuth_tolerance)
      cuts.push_back(place);
    else
      cuts.back().value = combine(cuts.back().value, place.value);
  return cuts;
}
} // namespace

unsigned int sector_of(double azimuth, double begin, unsigned int n_sectors)
{
  const double turns = (azimuth - begin) / (2 * ring::pi);
  const auto index = static_cast<unsigned int>((turns - std::floor(turns)) * n_sectors);
  return std::min(index, n_sectors - 1);
}

std::vector<AzimuthValue> values_of_cuts(const ContactSurface &surface,
                                         const std::vector<double> &line_values,
                                         double (*combine)(double, double))
{
  std::vector<AzimuthValue> places;
  for (std::size_t i = 0; i < line_values.size(); ++i)
    places.push_back({ surface.lines[i].azimuth, line_values[i] });
  std::vector<double> packed;
  for (const AzimuthValue &cut : combined(std::move(places), combine))
    packed.insert(packed.end(), { cut.azimuth, cut.value });
  packed = surface.parts.all_gather(packed);
  places.clear();
  for (std::size_t i = 0; i < packed.size(); i += 2)
    places.push_back({ packed[i], packed[i + 1] });
  return combined(std::move(places), combine);
}

std::vector<AzimuthValue> density_of_lines(const ContactSurface &surface,
                                           const std::vector<double> &line_forces)
{
  if (surface.lines_are_radial)
  {
    std::vector<double> densities;
    for (std::size_t i = 0; i < line_forces.size(); ++i)
      densities.push_back(line_forces[i] / surface.lines[i].azimuth_width);
    return values_of_cuts(surface, densities, [](double one, double other) { return one + other; });
  }
  std::vector<double> densities(surface.n_sectors, 0);
  for (unsigned int i = 0; i < line_forces.size(); ++i)
    densities[sector_of(surface.lines[i].azimuth, 0, surface.n_sectors)] +=
      line_forces[i] * surface.n_sectors / (2 * ring::pi);
  surface.parts.sum_in_place(densities);
  std::vector<AzimuthValue> density;
  for (unsigned int s = 0; s < surface.n_sectors; ++s)
    density.push_back({ 2 * ring::pi * (s + 0.5) / surface.n_sectors, densities[s] });
  return density;
}

std::vector<AzimuthValue> density_of_nodes(const ContactSurface &surface, const Eigen::VectorXd &node_forces)
{
  constexpr double two_pi = 2 * ring::pi;
  const unsigned int n_sectors = surface.n_sectors, n_nodes = surface.n_owned_nodes();
  std::vector<double> azimuths;
  for (unsigned int i = 0; i < n_nodes; ++i)
    azimuths.push_back(std::atan2(surface.node_position(i, 1), surface.node_position(i, 0)));
  // The offset of a quarter sector keeps corner and mid-side nodes off the borders between sectors.
  const double first = surface.parts.min(n_nodes > 0 ? *std::min_element(azimuths.begin(), azimuths.end())
                                                     : std::numeric_limits<double>::max());
  const double begin = first - two_pi / (4 * n_sectors);
  // Per sector: density, sum of the azimuths relative to `begin`, number of nodes.
  std::vector<double> sums(3 * n_sectors, 0);
  for (unsigned int i = 0; i < n_nodes; ++i)
  {
    double *const sector = &sums[3 * sector_of(azimuths[i], begin, n_sectors)];
    const double turns = (azimuths[i] - begin) / two_pi;
    sector[0] += node_forces(i) * n_sectors / two_pi;
    sector[1] += (turns - std::floor(turns)) * two_pi;
    sector[2] += 1;
  }
  surface.parts.sum_in_place(sums);
  std::vector<AzimuthValue> density;
  for (unsigned int s = 0; s < n_sectors; ++s)
  {
    const double *const sector = &sums[3 * s];
    density.push_back(
      { begin + (sector[2] > 0 ? sector[1] / sector[2] : two_pi * (s + 0.5) / n_sectors), sector[0] });
  }
  return density;
}

double largest_between(const std::vector<AzimuthValue> &cuts)
{
  const auto largest = std::max_element(cuts.begin(), cuts.end(),
                                        [](const AzimuthValue &one, const AzimuthValue &other)
                                        { return one.value < other.value; });
  const std::size_t n = cuts.size(), peak = static_cast<std::size_t>(largest - cuts.begin());
  for (const std::size_t reach : { 3u, 1u })
  {
    std::vector<double> azimuths, values;
    for (std::size_t i = 0; i <= 2 * reach && n > 2 * reach; ++i)
    {
      const AzimuthValue &cut = cuts[(peak + n - reach + i) % n];
      azimuths.push_back(std::remainder(cut.azimuth - largest->azimuth, 2 * ring::pi));
      values.push_back(-cut.value);
    }
    if (azimuths.empty() ||
        std::adjacent_find(azimuths.begin(), azimuths.end(), std::greater_equal<>()) != azimuths.end() ||
        (reach > 1 && *std::max_element(values.begin(), values.end()) >= 0))
      continue;
    const double before = azimuths[reach - 1], after = azimuths[reach + 1];
    const auto n_nodes = static_cast<Eigen::Index>(azimuths.size());
    const Eigen::Map<const Eigen::VectorXd> nodes(azimuths.data(), n_nodes), at_nodes(values.data(), n_nodes);
    const auto polynomial = [&](double azimuth)
    { return ring::lagrange_values(nodes, azimuth).dot(at_nodes); };
    return std::max(largest->value, -boost::math::tools::brent_find_minima(
                                       polynomial, before, after, std::numeric_limits<double>::digits / 2)
                                       .second);
  }
  return largest->value;
}

} // namespace stemware::fem
