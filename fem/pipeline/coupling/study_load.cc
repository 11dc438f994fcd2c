#include "fem/pipeline/coupling/study_load.h"

#include "fem/pipeline/coupling/load_file.h"
#include "fem/pipeline/coupling/make_foot.h"
#include "fem/pipeline/coupling/orientation.h"
#include "fem/pipeline/coupling/phase_loads.h"
#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/numbers.h"
#include "ring_model/first_harmonic_ring.h"

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

namespace stemware::pipeline
{

namespace
{

BalancedLoad constant_load(LoadReport at_rest)
{
  return BalancedLoad({ std::move(at_rest), {} });
}

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

/// The load of a contact whose marks stay where they are.
BalancedLoad load_at_one_phase(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                               const MomentBalance &moments, const LoadReport &at_rest, Progress &progress)
{
  if (!study.load.is_in_balance() || !spin_matters(study))
    return constant_load(at_rest);
  return balance(foot, moments, at_rest, all_harmonics, progress);
}

/// Loads of an out-of-flat foot or table, each phase with its own balances, solved as they are asked for.
class LoadsByPhase
{
public:
  LoadsByPhase(const Study &study, std::shared_ptr<ElasticFoot> foot, Progress &progress)
      : study(study)
      , foot(std::move(foot))
      , progress(progress)
  {
  }

  const BalancedLoad &of(const ring::Orientation &orientation)
  {
    const std::pair<double, double> place(orientation.glass, orientation.table);
    const auto known = loads.find(place);
    if (known != loads.end())
      return known->second;
    const fem::Resultants demand = study.required_resultants();
    const fem::ContactState state =
      foot->solve(demand.normal_force, { demand.moment_x, demand.moment_y }, { 0, orientation });
    MomentBalance moments = moment_balance(study);
    moments.orientation = orientation;
    return loads
      .emplace(place, load_at_one_phase(study, foot, moments, report_of(state, foot->radius()), progress))
      .first->second;
  }

  /// Of @p at_rest and of all phases asked for so far.
  PhaseExtremes extremes(const LoadReport &at_rest) const
  {
    PhaseExtremes worst = { at_rest.minimum, at_rest.contact_fraction };
    for (const auto &[place, load] : loads)
    {
      worst.least_load = std::min(worst.least_load, load.report().minimum);
      worst.least_contact_fraction = std::min(worst.least_contact_fraction, load.report().contact_fraction);
    }
    return worst;
  }

private:
  const Study study;
  const std::shared_ptr<ElasticFoot> foot;
  Progress &progress;
  std::map<std::pair<double, double>, BalancedLoad> loads;
};

/// @p at_rest is the load at the phase of t = 0.
BalancedLoad load_over_phases(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                              const LoadReport &at_rest, Progress &progress)
{
  const auto loads = std::make_shared<LoadsByPhase>(study, foot, progress);
  const LoadAtPhase exact = [loads](double omega, const ring::Orientation &orientation)
  { return loads->of(orientation).at(omega); };
  const PhaseGrids grids = find_phases(exact, phase_periods(imperfection_of(study)));

  // Friction is not smooth where the rim is as fast as the glass: there intervals meet.
  const bool follows_spin = study.load.is_in_balance() && spin_matters(study);
  const double spin_unit = follows_spin ? study.motion.orbit.orbit_speed / at_rest.rings.radius() / 4 : 0;
  const auto phases = std::make_shared<const PhaseLoads>(exact, grids, spin_unit, loads->extremes(at_rest));
  const auto for_mean =
    follows_spin ? std::make_shared<const PhaseLoads>(exact, grids.halved(), spin_unit) : phases;

  BalancedLoad::Parts parts =
    load_at_one_phase(study, foot, moment_balance(study), at_rest, progress).insides();
  parts.at_spin = [for_mean](double omega) { return for_mean->mean(omega); };
  parts.is_costly = false; // between the samples it is interpolated
  parts.phases = phases;
  return BalancedLoad(std::move(parts));
}

BalancedLoad contact_load(const Study &study, const std::shared_ptr<ElasticFoot> &foot, Progress &progress)
{
  const fem::Resultants demand = study.required_resultants();
  const MomentBalance moments = moment_balance(study);
  const auto state = std::make_shared<const fem::ContactState>(foot->solve(
    demand.normal_force, { demand.moment_x, demand.moment_y }, { 0, moments.orientation }, progress));
  progress.stage_done("contact");
  const LoadReport at_rest = report_of(*state, foot->radius());
  const BalancedLoad load = study.has_waviness() ? load_over_phases(study, foot, at_rest, progress)
                                                 : load_at_one_phase(study, foot, moments, at_rest, progress);
  BalancedLoad::Parts parts = load.insides();
  parts.contact = state;
  return BalancedLoad(std::move(parts));
}

/// A first harmonic that carries the given moment of a static study.
BalancedLoad given_first_harmonic(const Study &study)
{
  const fem::Resultants demand = study.required_resultants();
  return constant_load(report_of(ring::RingStack::first_harmonic(
    demand.normal_force, { demand.moment_x, demand.moment_y }, study.glass.profile.contact_radius)));
}

BalancedLoad load_from_file(const std::string &file)
{
  const ring::RingStack load = read_load_file(file);
  if (!(load.moment_ratio() < 2))
    throw BadInput("The load of " + file + " has a moment ratio sqrt(a_1^2 + b_1^2) / a_0 of " +
                   to_short_text(load.moment_ratio()) + ", but a ring tips at 2; give smaller a_1, b_1.");
  return constant_load(report_of(load));
}

} // namespace

std::shared_ptr<ElasticFoot> study_foot(const Study &study, fem::ComplianceCache &cache, Progress &progress)
{
  if (!study.load.is_from_contact())
    return nullptr;
  auto foot = std::make_shared<ElasticFoot>(make_foot(study, cache), study.glass.profile.contact_radius);
  progress.stage_done("mesh_and_stiffness");
  return foot;
}

namespace
{
BalancedLoad find_whole_load(const Study &study, const std::shared_ptr<ElasticFoot> &foot, Progress &progress)
{
  switch (study.load.source)
  {
  case LoadSource::contact:
    return contact_load(study, foot, progress);
  case LoadSource::first_harmonic:
    return study.load.is_static() ? given_first_harmonic(study)
                                  : first_harmonic_load(study, study.motion.closure);
  case LoadSource::file:
    return load_from_file(study.load.file);
  }
  throw std::logic_error("a load source without a load");
}
} // namespace

BalancedLoad find_load(const Study &study, const std::shared_ptr<ElasticFoot> &foot, Progress &progress,
                       unsigned int n_harmonics)
{
  const BalancedLoad load = find_whole_load(study, foot, progress);
  return n_harmonics < load.n_harmonics() ? load.truncated(n_harmonics) : load;
}

MomentBalance moment_balance(const Study &study)
{
  return { study.motion.orbit, study.motion.closure, orientation_of_marks(study.motion.orbit, 0, 0) };
}

BalancedLoad first_harmonic_load(const Study &study, ring::Closure closure)
{
  const ring::FirstHarmonicRing ring(closure, study.motion.orbit, study.glass.profile.contact_radius);
  return BalancedLoad({ report_of(ring.load(0)), [ring](double omega) { return ring.load(omega); } });
}

LoadReport report_of(const fem::ContactState &state, double contact_radius)
{
  const fem::LoadHarmonics &load = state.load;
  LoadReport report = { ring_stack(load) };
  report.normal_force = load.normal_force;
  report.moment = { load.moment_x, load.moment_y };
  report.moment_ratio = moment_ratio({ load.normal_force, load.moment_x, load.moment_y }, contact_radius);
  report.mean_radius = load.mean_radius;
  report.contact_fraction = load.contact_fraction;
  report.minimum = load.minimum;
  report.pointwise = by_azimuth(load.pointwise);
  return report;
}

bool spin_matters(const Study &study)
{
  return ring::friction_arm(study.motion.closure, study.motion.orbit) != 0 || study.friction_deforms();
}

std::string frozen_note(const Study &study)
{
  const bool could_follow = !study.load.is_static() && spin_matters(study);
  return study.load.coupling == LoadCoupling::one_way && could_follow
           ? "the load is that of rest; Load/Coupling = two-way follows it through the spin-up"
           : "";
}

} // namespace stemware::pipeline
