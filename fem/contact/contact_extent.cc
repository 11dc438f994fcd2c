#include "fem/contact/azimuthal_density.h"
#include "fem/contact/line_integral.h"
#include "fem/contact/pressure_law.h"
#include "ring_model/load/constants.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace stemware::fem
{

namespace
{

constexpr double two_pi = 2 * ring::pi;

/// Returns the maximum on [-1, 1] of the quadratic through @p samples at -1, 0 and 1.
double peak_of(const Eigen::Vector3d &samples)
{
  const Eigen::Vector3d coefficients = quadratic_through(samples);
  double peak = samples.maxCoeff();
  if (coefficients(2) < 0 && std::abs(coefficients(1)) < -2 * coefficients(2))
    peak = std::max(peak, value_at(coefficients, -coefficients(1) / (2 * coefficients(2))));
  return peak;
}

/// Returns the area of @p line and the part of the area in which the quadratic through @p excess is not
/// positive. If both ends are loaded, the unloaded area is 0, because the mesh does not resolve gaps inside a
/// line (e.g. next to the singular edge of a hard land).
Eigen::Vector2d total_and_unloaded_area(const ContactLine &line, const Eigen::Vector3d &excess)
{
  const AreaElement element(line);
  Eigen::Vector2d areas = Eigen::Vector2d::Zero();
  const auto integrate = [&](const LineSegment &segment, double &sum)
  { for_each_point<2>(element, segment, [&](const LinePoint &point) { sum += point.area; }); };
  integrate({ -1, 1 }, areas(0));
  if (excess(0) > 0 && excess(2) > 0)
    return areas;
  const PositiveSegments not_loaded(-excess);
  for (unsigned int s = 0; s < not_loaded.n_segments; ++s)
    integrate(not_loaded.segments[s], areas(1));
  return areas;
}

/// Returns the fraction of the circumference on which the value, linear between the cuts, is positive.
double positive_share(const std::vector<AzimuthValue> &cuts)
{
  double unloaded = 0;
  for (std::size_t i = 0; i < cuts.size(); ++i)
  {
    const AzimuthValue &begin = cuts[i], &end = cuts[(i + 1) % cuts.size()];
    const double length = end.azimuth - begin.azimuth + (i + 1 == cuts.size() ? two_pi : 0);
    const double low = std::min(begin.value, end.value), high = std::max(begin.value, end.value);
    if (low <= 0)
      unloaded += high > 0 ? length * low / (low - high) : length;
  }
  return 1 - std::min(1., unloaded / two_pi);
}

} // namespace

ContactExtent extent_of_lines(const ContactSurface &surface, const std::vector<Eigen::Vector3d> &depths,
                              const InterfaceLaw &law, const std::function<double(double)> &pressure)
{
  std::vector<double> peaks;
  peaks.reserve(depths.size());
  double deepest = -std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d &depth : depths)
    deepest = std::max(deepest, peaks.emplace_back(peak_of(depth)));
  deepest = surface.parts.max(deepest);
  ContactExtent extent;
  extent.peak_pressure = pressure(deepest);
  // Penetration at the edge of contact, where the pressure is zero up to rounding.
  const double edge = law.penetration_at(ContactExtent::rounding_share * extent.peak_pressure);

  std::vector<AzimuthValue> cuts;
  if (surface.lines_are_radial)
  {
    cuts = values_of_cuts(surface, peaks, [](double one, double other) { return std::max(one, other); });
    std::vector<AzimuthValue> pressures = cuts;
    for (AzimuthValue &cut : pressures)
      cut.value = pressure(cut.value);
    extent.peak_pressure = largest_between(pressures);
    for (AzimuthValue &cut : cuts)
      cut.value -= edge;
  }
  double azimuth_share = 0;
  if (surface.lines_are_radial)
    azimuth_share = positive_share(cuts);
  else
  {
    std::vector<double> is_loaded(surface.n_sectors, 0);
    for (std::size_t i = 0; i < peaks.size(); ++i)
      if (peaks[i] > edge)
        is_loaded[sector_of(surface.lines[i].azimuth, 0, surface.n_sectors)] = 1;
    surface.parts.sum_in_place(is_loaded);
    const auto n_unloaded = std::count(is_loaded.begin(), is_loaded.end(), 0.);
    azimuth_share = static_cast<double>(surface.n_sectors - n_unloaded) / surface.n_sectors;
  }
  if (surface.is_ring)
    extent.azimuth_share = azimuth_share;
  if (surface.is_crowned)
  {
    extent.area_share = azimuth_share;
    return extent;
  }
  Eigen::Vector2d areas = Eigen::Vector2d::Zero(); // total area, unloaded area [m^2]
  for (std::size_t i = 0; i < depths.size(); ++i)
    areas += total_and_unloaded_area(surface.lines[i], depths[i].array() - edge);
  areas = surface.parts.sum(areas);
  extent.area_share = 1 - std::min(1., areas(1) / areas(0));
  return extent;
}

} // namespace stemware::fem
