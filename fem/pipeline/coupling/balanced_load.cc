#include "fem/pipeline/coupling/balanced_load.h"

#include "fem/pipeline/coupling/balanced_states.h"
#include "fem/pipeline/coupling/load_curve.h"
#include "fem/pipeline/coupling/phase_loads.h"
#include "ring_model/truncated_model.h"

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace stemware::pipeline
{

BalancedLoad::BalancedLoad(Parts given)
    : parts(std::make_shared<const Parts>(std::move(given)))
    , n_kept(parts->n_kept)
{
}

LeaningLoad BalancedLoad::leaning(double omega) const
{
  const AtSpin &at_spin = curve ? curve : parts->at_spin;
  const LeaningLoad load = at_spin ? at_spin(omega) : LeaningLoad(parts->at_rest.rings, parts->at_rest.tilt);
  return load.rings.n_harmonics() > n_kept ? load.truncated(n_kept) : load;
}

ring::RingStack BalancedLoad::at(double omega) const
{
  return leaning(omega).rings;
}

LeaningLoad BalancedLoad::leaning(double omega, const ring::Orientation &orientation) const
{
  return parts->phases ? parts->phases->at(omega, orientation).truncated(n_kept) : leaning(omega);
}

ring::RingStack BalancedLoad::at(double omega, const ring::Orientation &orientation) const
{
  return leaning(omega, orientation).rings;
}

BalancedLoad BalancedLoad::truncated(unsigned int n_harmonics) const
{
  BalancedLoad cut = *this;
  cut.n_kept = std::min(n_kept, n_harmonics);
  return cut;
}

BalancedLoad BalancedLoad::with_curve(AtSpin interpolated) const
{
  BalancedLoad other = *this;
  other.curve = std::move(interpolated);
  return other;
}

BalancedLoad BalancedLoad::interpolated(double lower, double upper, double coarsest) const
{
  if (!parts->is_costly || !(lower < upper))
    return *this;
  // With lift-off the load has a small kink wherever a line of contact is lost. The spins solved for one
  // tolerance serve the next.
  for (const double tolerance : { 1e-8, 1e-6, 1e-5, coarsest })
    try
    {
      const LoadCurve samples = sample_load_curve(parts->at_spin, lower, upper, tolerance, 200);
      parts->statistics->interpolation_error = samples.error;
      return with_curve([inside = samples.interpolate(), exact = parts->at_spin, lower, upper](double omega)
                        { return lower <= omega && omega <= upper ? inside(omega) : exact(omega); });
    }
    catch (const ToleranceMissed &)
    {
    }
  return *this;
}

unsigned int BalancedLoad::n_harmonics() const
{
  return std::min(n_kept, parts->at_rest.rings.n_harmonics());
}

double BalancedLoad::spin_scale(const ring::Motion &motion) const
{
  return motion.orbit_speed / parts->at_rest.rings.radius();
}

std::optional<CouplingStatistics> BalancedLoad::statistics() const
{
  return parts->statistics ? std::optional(*parts->statistics) : std::nullopt;
}

BalancedLoad balance(const std::shared_ptr<const ring::LoadModel> &model, const MomentBalance &balance,
                     const LoadReport &at_rest, unsigned int n_harmonics, Progress &progress)
{
  const ring::Motion &motion = balance.motion;
  const bool is_cut = n_harmonics < at_rest.rings.n_harmonics();
  std::shared_ptr<const ring::LoadModel> acting = model;
  if (is_cut)
    acting = std::make_shared<ring::TruncatedModel>(model, n_harmonics);
  const auto states =
    std::make_shared<BalancedStates>(ring::SelfConsistentRing(balance.closure, motion, acting),
                                     motion.orbit_speed / model->radius(), balance.orientation);
  const auto statistics = std::make_shared<CouplingStatistics>();
  BalancedLoad::Parts parts = { at_rest };
  if (is_cut)
    parts.at_rest.rings = at_rest.rings.truncated(n_harmonics);
  parts.statistics = statistics;
  parts.is_costly = model->is_costly();
  parts.at_spin = [=, &progress, rest = parts.at_rest.rings](double omega) -> LeaningLoad
  {
    if (omega == 0)
      return rest;
    const ring::RingEquilibrium &state = states->at(omega);
    if (states->size() > statistics->n_balances)
    {
      statistics->n_balances = states->size();
      progress.pieces_done("spins in balance", states->size(), 0);
    }
    return state.load;
  };
  return BalancedLoad(std::move(parts));
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
  report.minimum = load.minimum();
  return report;
}

} // namespace stemware::pipeline
