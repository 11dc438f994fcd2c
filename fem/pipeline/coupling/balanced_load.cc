#include "fem/pipeline/coupling/balanced_load.h"

#include "ring_model/self_consistent_ring.h"

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace stemware::pipeline
{

namespace
{

/// The load of a model of the ring in balance at every spin. Loads are kept.
class ModelInBalance : public GivenLoad
{
public:
  ModelInBalance(const ring::SelfConsistentRing &glass, LoadReport at_rest)
      : GivenLoad(std::move(at_rest))
      , glass(glass)
  {
  }

  ring::LeaningLoad at(double omega, const std::optional<ring::Orientation> &) const override
  {
    if (omega == 0)
      return report().rings;
    auto found = loads.find(omega);
    if (found == loads.end())
      found = loads.emplace(omega, glass.at(omega).load).first;
    return found->second;
  }
  std::optional<CouplingStatistics> statistics() const override { return CouplingStatistics{ loads.size() }; }

private:
  const ring::SelfConsistentRing glass;
  mutable std::map<double, ring::RingStack> loads;
};

/// Azimuths in [0, 2 pi), sorted.
std::vector<fem::AzimuthLoad> by_azimuth(std::vector<fem::AzimuthLoad> pointwise)
{
  constexpr double turn = boost::math::double_constants::two_pi;
  for (fem::AzimuthLoad &place : pointwise)
    place.azimuth -= turn * std::floor(place.azimuth / turn);
  std::sort(pointwise.begin(), pointwise.end(),
            [](const auto &one, const auto &other) { return one.azimuth < other.azimuth; });
  return pointwise;
}

} // namespace

SharedLoad balance(const std::shared_ptr<const ring::LoadModel> &model, const ring::Motion &motion,
                   ring::Closure closure, LoadReport at_rest, unsigned int n_harmonics)
{
  if (n_harmonics < at_rest.rings.n_harmonics())
    at_rest.rings = at_rest.rings.truncated(n_harmonics);
  return std::make_shared<ModelInBalance>(ring::SelfConsistentRing(closure, motion, model, n_harmonics),
                                          std::move(at_rest));
}

LoadReport report_of(const ring::RingStack &load)
{
  constexpr unsigned int n_azimuths = 3600;
  unsigned int n_loaded = 0;
  for (unsigned int i = 0; i < n_azimuths; ++i)
    n_loaded += load(boost::math::double_constants::two_pi * (i + 0.5) / n_azimuths) > 0 ? 1 : 0;
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
