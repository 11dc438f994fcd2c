#include "fem/pipeline/coupling/balanced_load.h"

#include "ring_model/load/constants.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace stemware::pipeline
{

namespace
{

std::vector<fem::AzimuthValue> by_azimuth(std::vector<fem::AzimuthValue> pointwise)
{
  constexpr double turn = 2 * ring::pi;
  for (fem::AzimuthValue &place : pointwise)
    place.azimuth -= turn * std::floor(place.azimuth / turn);
  std::sort(pointwise.begin(), pointwise.end(),
            [](const auto &one, const auto &other) { return one.azimuth < other.azimuth; });
  return pointwise;
}

} // namespace

BalancedLoad given_load(const ring::RingStack &load, unsigned int n_harmonics)
{
  const ring::Sample kept = load.truncated(n_harmonics);
  return { ring::Load([kept](double) { return kept; }), report_of(load) };
}

LoadReport report_of(const ring::RingStack &load)
{
  constexpr unsigned int n_azimuths = 3600;
  unsigned int n_loaded = 0;
  for (unsigned int i = 0; i < n_azimuths; ++i)
    n_loaded += load(2 * ring::pi * (i + 0.5) / n_azimuths) > 0 ? 1 : 0;
  LoadReport report = { load };
  report.normal_force = load.normal_force();
  report.moment = load.moment();
  report.moment_ratio = load.moment_ratio(load.radius());
  report.mean_radius = load.radius();
  report.contact_fraction = static_cast<double>(n_loaded) / n_azimuths;
  report.azimuth_fraction = report.contact_fraction;
  report.minimum = load.minimum();
  return report;
}

LoadReport report_of(const fem::ContactState &state, double contact_radius, bool tilts)
{
  const fem::ContactLoad &load = state.load;
  LoadReport report = { load };
  report.normal_force = load.normal_force();
  report.moment = load.moment();
  report.moment_ratio = load.moment_ratio(contact_radius);
  report.mean_radius = load.mean_radius;
  report.contact_fraction = load.contact_fraction;
  report.azimuth_fraction = load.azimuth_fraction;
  report.peak_pressure = load.peak_pressure;
  report.minimum = load.least;
  report.inner_radius = state.inner_radius;
  report.outer_radius = state.outer_radius;
  if (tilts)
    report.tilt = state.solution.motion.tail<2>();
  report.pointwise = by_azimuth(load.pointwise);
  return report;
}

} // namespace stemware::pipeline
