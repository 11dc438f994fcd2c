#include "fem/pipeline/coupling/foot_load.h"

#include "fem/pipeline/base/numbers.h"
#include "fem/pipeline/coupling/balanced_contact.h"
#include "fem/pipeline/coupling/elastic_foot.h"
#include "fem/pipeline/coupling/study_balance.h"
#include "fem/pipeline/study/contact_section.h"
#include "ring_model/failures.h"
#include "ring_model/friction_functionals.h"
#include "ring_model/load/constants.h"
#include "ring_model/motion.h"
#include "ring_model/spin/phase_loads.h"
#include "ring_model/terminal_spin.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace stemware::pipeline
{

namespace
{

/// Returns the range of loaded radii in @p state. Nodal contact on a hard table may load a single circle of
/// nodes; this range is widened by @p cell on both sides. The balance evaluates the ring interpolation at the
/// neighbouring nodes too, and rings of zero spacing would extrapolate too far.
fem::ContactWidth band_of(const fem::ContactState &state, double cell)
{
  const bool is_wide = state.outer_radius - state.inner_radius > 1e-3 * cell;
  const double margin = is_wide ? 0 : cell;
  return { state.inner_radius - margin, state.outer_radius + margin };
}

/// Returns the number of rings J that makes the torque at slip ratio @p eps accurate to 1e-10. The error
/// decreases like (w / (2 R |1 - |eps||))^J for a band of width w at the contact radius R. If the slip
/// vanishes within the band, the error decreases only algebraically, and max_rings is returned.
unsigned int rings_for(const fem::ContactWidth &band, double eps, unsigned int least)
{
  const double share = (band.outer - band.inner) / (band.outer + band.inner) / std::abs(1 - std::abs(eps));
  if (share >= 0.5)
    return max_rings;
  const double wanted = std::ceil(std::log(1e-10) / std::log(share));
  return std::max(least, static_cast<unsigned int>(std::min<double>(wanted, max_rings)));
}

/// Returns the number of load harmonics that contribute to the friction at slip ratios up to 1.5 @p eps. The
/// kernels K_n(eps) decrease like |eps|^n.
unsigned int harmonics_for(double eps)
{
  constexpr unsigned int least = 24, most = std::numeric_limits<unsigned int>::max();
  const double fastest = 1.5 * std::abs(eps);
  if (fastest >= 0.99)
    return most;
  return std::max(least, static_cast<unsigned int>(std::ceil(std::log(1e-14) / std::log(fastest))));
}

/// Sets the rings of @p foot to Chebyshev points of the radii loaded in @p at_rest. The number of rings is
/// computed from the slip ratio at the terminal spin. It is Contact/Rings if the load at rest has no terminal
/// spin.
void choose_rings(const ContactSection &contact, const ring::Motion &motion, ElasticFoot &foot,
                  const fem::ContactState &at_rest)
{
  const fem::ContactWidth band = band_of(at_rest, foot.body().description().contact_cell_size);
  const auto set_rings = [&](unsigned int n_rings, unsigned int n_harmonics)
  {
    if (n_rings == 1)
      return foot.set_rings({}, n_harmonics);
    const double margin = 0.1 * (band.outer - band.inner) + 1e-6 * band.outer;
    foot.set_rings(
      chebyshev_radii(std::max(band.inner - margin, 0.01 * band.inner), band.outer + margin, n_rings),
      n_harmonics);
  };
  unsigned int n_rings = contact.rings, n_harmonics = foot.body().n_resolved_harmonics();
  set_rings(n_rings, n_harmonics);
  try
  {
    const double omega = ring::terminal_spin(foot.project_onto_rings(at_rest), motion).omega;
    const double eps = omega * foot.radius() / motion.orbit_speed;
    n_harmonics = harmonics_for(eps);
    if (n_rings > 1)
      n_rings = rings_for(band, eps, n_rings);
  }
  catch (const ring::NoBalance &) // no terminal spin: Contact/Rings is kept
  {
  }
  set_rings(n_rings, contact.load_harmonics > 0 ? contact.load_harmonics : n_harmonics);
}

/// Returns the resultants at rest. With tilt, they include the moment of the weight of the tilted glass.
fem::ContactDemand demand_at_rest(const Study &study)
{
  fem::ContactDemand demand = study.required_resultants();
  if (study.tilts())
    demand.tilt_moment = demand.normal_force * study.motion.orbit.overturning_height();
  return demand;
}

/// Returns the load whose contact solutions at every spin have the orientation of @p at_rest.
BalancedLoad load_at_one_phase(const std::shared_ptr<ElasticFoot> &foot, ContactBalance balance,
                               const fem::ContactState &at_rest, Progress &progress)
{
  balance.orientation = at_rest.slip.orientation;
  const auto contacts = std::make_shared<BalancedContact>(foot, balance, at_rest, progress);
  const ring::Sample of_rest = contacts->sample(0);
  return { balance.varies_with_spin
             ? ring::Load::solved_once([contacts](double omega) { return contacts->sample(omega); }, of_rest)
             : ring::Load([of_rest](double) { return of_rest; }, true),
           report_of(at_rest, foot->radius(), balance.tilts), contacts };
}

/// Returns the contact solution at rest with glass and table in the orientation @p phase. @p at_start:
/// contact solution at t = 0.
fem::ContactState contact_at_phase(ElasticFoot &foot, const ring::Orientation &phase,
                                   const fem::ContactState &at_start)
{
  try
  {
    return foot.solve(at_start.demand, { 0, phase });
  }
  catch (const fem::ContactFailure &failure)
  {
    if (failure.outcome != fem::ContactOutcome::tipping)
      throw;
    const ring::Orientation &start = at_start.slip.orientation;
    const auto degrees = [](double angle)
    { return to_short_text(std::remainder(angle / (ring::pi / 180), 360.)); };
    const std::string turned = phase.glass != start.glass
                                 ? "glass is turned by " + degrees(phase.glass - start.glass)
                                 : "table is turned by " + degrees(phase.table - start.table);
    const std::string message =
      "The foot stands at the start, but it tips when the " + turned + " degrees: " + failure.message;
    if (dynamic_cast<const fem::TippingDemand *>(&failure))
      throw fem::TippingDemand(message);
    throw fem::ContactFailure(failure.outcome, message);
  }
}

/// Returns the load over all phases. @p at_rest: contact solution at t = 0.
BalancedLoad load_over_phases(const std::shared_ptr<ElasticFoot> &foot, const ContactBalance &balance,
                              const ring::PhasePeriods &periods, const fem::ContactState &at_rest,
                              bool is_hard, bool is_coarse, Progress &progress)
{
  const auto by_phase = std::make_shared<std::map<std::pair<double, double>, BalancedLoad>>();
  const ring::LoadAtPhase exact = [=, &progress](double omega, const ring::Orientation &phase)
  {
    const std::pair marks(phase.glass, phase.table);
    auto load = by_phase->find(marks);
    if (load == by_phase->end())
    {
      const fem::ContactState state = contact_at_phase(*foot, phase, at_rest);
      progress.pieces_done("phases", by_phase->size() + 1, 0);
      load = by_phase->emplace(marks, load_at_one_phase(foot, balance, state, progress)).first;
    }
    return load->second.at(omega);
  };
  // The number of phases is limited, so that a study takes seconds: a load that varies with the spin needs
  // several contact solves per phase, and a hard contact takes ten times as long as a compliant contact.
  const unsigned int max_samples = is_coarse ? 16 : balance.varies_with_spin ? 32 : is_hard ? 64 : 256;
  // Results of coarse sampling have no error band, so the allowed sampling error is smaller.
  const ring::PhaseSamples samples =
    ring::sample_phases(exact, periods, max_samples, is_coarse ? 1e-3 : 3e-2);

  LoadReport report = report_of(at_rest, foot->radius(), balance.tilts);
  ring::SpinSampling spins;
  // The sampling intervals of the spin have a border at v / R, where the friction torque has a kink.
  if (balance.varies_with_spin)
    spins.unit = balance.motion.orbit_speed / report.rings.radius() / (is_hard ? 2 : 4);
  // Without a torque at rest the glass does not spin up, unless rest is unstable. Its load is needed at the
  // small spins of the torque's slope.
  const double radius = report.rings.radius();
  if (std::abs(ring::wrench(balance.motion, samples.mean(), 0).torque) <=
      1e-6 * balance.motion.friction_at_rest() * balance.motion.normal_force() * radius)
    spins.rest = balance.motion.orbit_speed / radius / 30;
  if (is_hard)
    spins.max_samples = is_coarse ? 5 : 9;
  if (is_coarse)
    spins.max_intervals = 2;
  double &least = report.least_contact_fraction.emplace(report.contact_fraction);
  for (const auto &[phase, load] : *by_phase)
    least = std::min(least, load.report().contact_fraction);
  return { ring::Load(std::make_shared<ring::PhaseSampledLoad>(exact, periods, samples, spins)), report,
           std::make_shared<BalancedContact>(foot, balance, at_rest, progress) };
}

/// Returns the contact solution at rest, projected onto the rings. The first call chooses the rings.
fem::ContactState contact_at_rest(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                                  const ring::Orientation &marks, Progress &progress)
{
  fem::ContactState state = foot->solve_at_rest(demand_at_rest(study), marks, progress);
  if (!foot->has_rings())
  {
    choose_rings(study.contact, study.motion.orbit, *foot, state);
    state.load = foot->project_onto_rings(state);
  }
  return state;
}

} // namespace

BalancedLoad contact_load(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                          unsigned int n_harmonics, Progress &progress, PhaseSampling phases)
{
  const ContactBalance balance = moment_balance(study, n_harmonics);
  const fem::ContactState state = contact_at_rest(study, foot, balance.orientation, progress);
  progress.stage_done("contact");
  const ring::PhasePeriods periods = phase_periods(study, *foot);
  const bool is_hard = study.table.is_hard(), is_coarse = is_hard && phases == PhaseSampling::coarse;
  return periods.any() ? load_over_phases(foot, balance, periods, state, is_hard, is_coarse, progress)
                       : load_at_one_phase(foot, balance, state, progress);
}

BalancedLoad find_load_at_phase(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                                const ring::Orientation &orientation, unsigned int n_harmonics)
{
  const fem::ContactState state = contact_at_rest(study, foot, orientation, silent_progress());
  return load_at_one_phase(foot, moment_balance(study, n_harmonics), state, silent_progress());
}

} // namespace stemware::pipeline
