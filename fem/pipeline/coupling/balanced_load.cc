#include "fem/pipeline/coupling/balanced_load.h"

#include "ring_model/load/constants.h"

#include <algorithm>
#include <cmath>

namespace stemware::pipeline
{

BalancedLoad given_load(const ring::RingStack &load)
{
  return { ring::Load([load](double) -> ring::Sample { return { load }; }), report_of(load) };
}

LoadReport report_of(const ring::RingStack &load)
{
  constexpr unsigned int n_azimuths = 3600;
  unsigned int n_loaded = 0;
  for (unsigned int i = 0; i < n_azimuths; ++i)
    n_loaded += load(2 * ring::pi * (i + 0.5) / n_azimuths) > 0 ? 1 : 0;
  LoadReport report = { fem::ContactLoad(load) };
  report.moment_ratio = load.moment_ratio(load.radius());
  report.mean_radius = load.radius();
  report.contact_fraction = static_cast<double>(n_loaded) / n_azimuths;
  report.azimuth_fraction = report.contact_fraction;
  report.least = load.minimum();
  return report;
}

LoadReport report_of(const fem::ContactState &state, double contact_radius, bool tilts)
{
  LoadReport report = { state.load };
  report.moment_ratio = state.load.moment_ratio(contact_radius);
  report.inner_radius = state.inner_radius;
  report.outer_radius = state.outer_radius;
  if (tilts)
    report.tilt = state.solution.motion.tail<2>();
  for (fem::AzimuthValue &place : report.pointwise) // azimuths in [0, 2 pi), ascending
    place.azimuth -= 2 * ring::pi * std::floor(place.azimuth / (2 * ring::pi));
  std::sort(report.pointwise.begin(), report.pointwise.end(),
            [](const auto &one, const auto &other) { return one.azimuth < other.azimuth; });
  return report;
}

} // namespace stemware::pipeline
