#include "fem/pipeline/coupling/foot_load.h"

#include "fem/pipeline/coupling/balanced_contact.h"
#include "fem/pipeline/coupling/ring_choice.h"
#include "fem/pipeline/coupling/study_balance.h"
#include "fem/pipeline/support/numbers.h"
#include "ring_model/no_balance.h"
#include "ring_model/spin/phase_loads.h"

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <deque>
#include <exception>
#include <map>
#include <stdexcept>
#include <utility>

namespace stemware::pipeline
{

namespace
{

/// Resultants of the study at rest, with the weight of the leaning glass where it counts.
fem::ContactDemand demand_at_rest(const Study &study)
{
  fem::ContactDemand demand = study.required_resultants();
  if (study.tilts())
    demand.tilt_moment = demand.normal_force * study.motion.orbit.overturning_height();
  return demand;
}

/// An elastic foot in balance at every spin, with its marks where they are.
class ContactInBalance : public GivenLoad
{
public:
  /// @p at_rest is its contact at rest, @p report on that.
  ContactInBalance(const std::shared_ptr<ElasticFoot> &foot, const ContactBalance &balance,
                   const LoadReport &report, const fem::ContactState &at_rest, Progress &progress)
      : GivenLoad(report, balance.n_harmonics, at_rest)
      , contacts(std::make_unique<BalancedContact>(foot, balance, at_rest))
      , clearance_at_rest(clearance_of(at_rest.load))
      , stability_at_rest(at_rest.solution.stability_margin)
      , progress(progress)
  {
  }

  ring::LeaningLoad at(double omega, const std::optional<ring::Orientation> &marks) const override
  {
    if (omega == 0)
      return GivenLoad::at(omega, marks);
    const auto known = loads.find(omega);
    if (known != loads.end())
      return known->second.load;
    latest.emplace_front(omega, contact_in_balance(omega));
    if (latest.size() > n_latest)
      latest.pop_back();
    const fem::ContactState &state = latest.front().second;
    const auto found = loads
                         .emplace(omega, Found{ contacts->load_of(state), clearance_of(state.load),
                                                state.solution.stability_margin })
                         .first;
    progress.pieces_done("spins in balance", loads.size(), 0);
    return found->second.load;
  }
  bool is_costly() const override { return true; }
  std::optional<fem::ContactState> contact(double omega) const override
  {
    if (omega == 0)
      return GivenLoad::contact(omega);
    for (const auto &[spin, state] : latest)
      if (spin == omega)
        return state;
    return contact_in_balance(omega);
  }
  std::vector<double> known_spins() const override
  {
    std::vector<double> spins = { 0 };
    for (const auto &[omega, found] : loads)
      spins.push_back(omega);
    std::sort(spins.begin(), spins.end());
    return spins;
  }
  double lift_off_margin(double omega) const override
  {
    return omega == 0 ? clearance_at_rest : loads.at(omega).lift_off_margin;
  }
  double stability_margin(double omega) const override
  {
    if (omega == 0)
      return stability_at_rest;
    const auto found = loads.find(omega);
    return found == loads.end() ? 1 : found->second.stability_margin;
  }
  std::optional<double> nearest_unbalanced_spin(double omega) const override
  {
    std::optional<double> first;
    for (const double spin : falls)
      if (spin * omega > 0 && std::abs(spin) < std::abs(first.value_or(omega)))
        first = spin;
    return first;
  }
  std::optional<CouplingStatistics> statistics() const override
  {
    return CouplingStatistics{ loads.size(), contacts->n_contact_solutions() };
  }

private:
  struct Found
  {
    ring::LeaningLoad load;
    double lift_off_margin, stability_margin;
  };

  /// The contact at @p omega. Rest has a balance: a contact that fails at another spin is a glass that has
  /// fallen over, or one of which nothing is known. Each is tried once.
  fem::ContactState contact_in_balance(double omega) const
  {
    if (const auto failed = failures.find(omega); failed != failures.end())
      std::rethrow_exception(failed->second);
    const auto keep = [&](const auto &failure)
    {
      failures.emplace(omega, std::make_exception_ptr(failure));
      throw failure;
    };
    try
    {
      return contacts->contact(omega);
    }
    catch (const fem::ContactFailure &failure)
    {
      if (failure.outcome == fem::ContactOutcome::tipping)
      {
        falls.push_back(omega);
        keep(ring::Tipping(failure.what()));
      }
      keep(ring::NoBalance("at " + to_short_text(omega) +
                           " rad/s no balance was found, and no fall of the glass (" + failure.what() + ")"));
    }
    throw std::logic_error("a contact that is neither found nor missing");
  }

  static double clearance_of(const fem::ContactLoad &load)
  {
    constexpr double pi = boost::math::double_constants::pi;
    // Next to where it vanishes, a load that falls like 1 + cos.
    const double share = load.azimuth_fraction.value_or(load.contact_fraction);
    return share < 1 ? -std::pow(pi * (1 - share), 2) / 2 : load.least / load.a(0);
  }

  const std::unique_ptr<BalancedContact> contacts;
  const double clearance_at_rest, stability_at_rest;
  Progress &progress;
  mutable std::map<double, Found> loads; ///< so far
  mutable std::map<double, std::exception_ptr> failures;
  mutable std::vector<double> falls; ///< those of them in which the glass falls over [rad/s]
  /// The contacts of the newest of them: at the terminal spin and what is asked next about it, or of a band.
  mutable std::deque<std::pair<double, fem::ContactState>> latest;
  static constexpr std::size_t n_latest = 6;
};

/// The load of a contact whose marks stay where they are @p at_rest.
SharedLoad load_at_one_phase(const std::shared_ptr<ElasticFoot> &foot, ContactBalance balance,
                             const fem::ContactState &at_rest, Progress &progress)
{
  const LoadReport report = report_of(at_rest, foot->radius(), balance.tilts);
  if (!balance.varies_with_spin)
    return std::make_shared<GivenLoad>(report, balance.n_harmonics, at_rest);
  balance.orientation = at_rest.slip.orientation;
  return std::make_shared<ContactInBalance>(foot, balance, report, at_rest, progress);
}

/// A load that depends on the phase of glass and table, interpolated between phases and spins: that with the
/// marks where they are at t = 0, but for the loads.
class LoadByPhase : public BalancedLoad
{
public:
  LoadByPhase(SharedLoad at_start, LoadReport report, ring::PhaseSampledLoad loads)
      : at_start(std::move(at_start))
      , at_rest(std::move(report))
      , loads(std::move(loads))
  {
  }

  ring::LeaningLoad at(double omega, const std::optional<ring::Orientation> &marks) const override
  {
    return marks ? loads.at(omega, *marks) : loads.mean(omega);
  }
  unsigned int n_harmonics() const override { return at_start->n_harmonics(); }
  const ring::PhaseSampledLoad *phases() const override { return &loads; }
  const LoadReport &report() const override { return at_rest; }
  std::optional<fem::ContactState> contact(double omega) const override { return at_start->contact(omega); }
  std::optional<CouplingStatistics> statistics() const override { return at_start->statistics(); }
  double stability_margin(double omega) const override { return at_start->stability_margin(omega); }
  std::optional<double> nearest_unbalanced_spin(double omega) const override
  {
    return at_start->nearest_unbalanced_spin(omega);
  }

private:
  const SharedLoad at_start;
  const LoadReport at_rest;
  const ring::PhaseSampledLoad loads;
};

/// The contact at rest with the marks at @p phase. If it tips, the failure tells about @p at_start as well,
/// the contact with the marks at t = 0, which is in balance.
fem::ContactState contact_at_phase(const Study &study, ElasticFoot &foot, const ring::Orientation &phase,
                                   const fem::ContactState &at_start)
{
  try
  {
    return foot.solve(demand_at_rest(study), { 0, phase });
  }
  catch (const fem::ContactFailure &failure)
  {
    if (failure.outcome != fem::ContactOutcome::tipping)
      throw;
    const ring::Orientation &start = at_start.slip.orientation;
    const auto degrees = [](double angle)
    { return to_short_text(std::remainder(angle / boost::math::double_constants::degree, 360.)); };
    const std::string turned = phase.glass != start.glass
                                 ? "glass is turned by " + degrees(phase.glass - start.glass)
                                 : "table is turned by " + degrees(phase.table - start.table);
    const std::string message =
      "At the start the contact is in balance: " + to_short_text(100 * at_start.load.contact_fraction) +
      " % of the land are under pressure, at most " + to_short_text(at_start.load.peak_pressure) +
      " Pa, the table's motion is " + to_short_text(at_start.solution.motion(0)) + " m, " +
      to_short_text(at_start.solution.motion(1)) + " rad, " + to_short_text(at_start.solution.motion(2)) +
      " rad. But the foot tips when the " + turned + " degrees: " + failure.message;
    if (dynamic_cast<const fem::TippingDemand *>(&failure))
      throw fem::TippingDemand(message);
    throw fem::ContactFailure(failure.outcome, message);
  }
}

/// @p at_rest is the load at the phase of t = 0.
SharedLoad load_over_phases(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                            const ContactBalance &balance, const ring::PhasePeriods &periods,
                            const fem::ContactState &at_rest, PhaseSampling phases, Progress &progress)
{
  // Each phase has its own balances, solved as they are asked for.
  const auto by_phase = std::make_shared<std::map<std::pair<double, double>, SharedLoad>>();
  const ring::LoadAtPhase exact = [=, &progress](double omega, const ring::Orientation &phase)
  {
    SharedLoad &load = (*by_phase)[{ phase.glass, phase.table }];
    if (!load)
    {
      const fem::ContactState state = contact_at_phase(study, *foot, phase, at_rest);
      progress.pieces_done("phases", by_phase->size(), 0);
      load = load_at_one_phase(foot, balance, state, progress);
    }
    return load->at(omega);
  };
  // Where each phase takes a curve over the spins, or ten times as long under a hard contact, fewer have to
  // do: so a study takes seconds.
  const bool follows = balance.varies_with_spin, is_hard = study.table.is_hard();
  const bool is_coarse = is_hard && phases == PhaseSampling::coarse;
  ring::RestSampling at_rest_sampling;
  at_rest_sampling.max_samples = is_coarse ? 16 : follows ? 32 : is_hard ? 64 : 256;
  // A row has no band that would tell a larger error.
  if (is_coarse)
    at_rest_sampling.max_error = 1e-3;
  const ring::PhaseSamples samples = ring::sample_phases(exact, periods, at_rest_sampling);

  const SharedLoad at_start = load_at_one_phase(foot, balance, at_rest, progress);
  LoadReport report = at_start->report();
  ring::SpinSampling spins;
  // Friction is not smooth where the rim is as fast as the glass: there intervals meet.
  if (follows)
    spins.unit = study.motion.orbit.orbit_speed / report.rings.radius() / (is_hard ? 2 : 4);
  if (is_hard)
    spins.max_steps = is_coarse ? 4 : 8;
  if (is_coarse)
    spins.max_intervals = 2;
  PhaseExtremes &worst = report.over_phases.emplace(PhaseExtremes{ report.minimum, report.contact_fraction });
  for (const auto &[phase, load] : *by_phase)
  {
    worst.least_load = std::min(worst.least_load, load->report().minimum);
    worst.least_contact_fraction = std::min(worst.least_contact_fraction, load->report().contact_fraction);
  }
  return std::make_shared<LoadByPhase>(at_start, report,
                                       ring::PhaseSampledLoad(exact, periods, samples, spins));
}

/// The contact at rest, on the rings of the study, which the first call chooses.
fem::ContactState contact_at_rest(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                                  const ring::Orientation &marks, Progress &progress)
{
  fem::ContactState state = foot->solve_at_rest(demand_at_rest(study), marks, progress);
  if (!foot->has_rings())
  {
    choose_rings(study, *foot, state);
    state.load = foot->project_onto_rings(state);
  }
  return state;
}

} // namespace

SharedLoad contact_load(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                        unsigned int n_harmonics, Progress &progress, PhaseSampling phases)
{
  const ContactBalance balance = moment_balance(study, n_harmonics);
  const fem::ContactState state = contact_at_rest(study, foot, balance.orientation, progress);
  progress.stage_done("contact");
  const ring::PhasePeriods periods = phase_periods(study, *foot);
  return periods.any() ? load_over_phases(study, foot, balance, periods, state, phases, progress)
                       : load_at_one_phase(foot, balance, state, progress);
}

SharedLoad find_load_at_phase(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                              const ring::Orientation &orientation, unsigned int n_harmonics)
{
  const fem::ContactState state = contact_at_rest(study, foot, orientation, silent_progress());
  return load_at_one_phase(foot, moment_balance(study, n_harmonics), state, silent_progress());
}

} // namespace stemware::pipeline
