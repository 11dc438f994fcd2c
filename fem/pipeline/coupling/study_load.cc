#include "fem/pipeline/coupling/study_load.h"

#include "fem/contact/contact_solution.h"
#include "fem/pipeline/base/failures.h"
#include "fem/pipeline/base/numbers.h"
#include "ring_model/failures.h"
#include "ring_model/friction_functionals.h"
#include "ring_model/load/constants.h"
#include "ring_model/self_consistent_ring.h"
#include "ring_model/spin/phase_loads.h"
#include "ring_model/terminal_spin.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

namespace stemware::pipeline
{

namespace
{

double period_of(const std::vector<fem::WavinessHarmonic> &harmonics)
{
  unsigned int divisor = 0;
  for (const fem::WavinessHarmonic &harmonic : harmonics)
    divisor = std::gcd(divisor, harmonic.n);
  return divisor > 0 ? 2 * ring::pi / divisor : 0;
}

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
void choose_rings(ElasticFoot &foot, const fem::ContactState &at_rest)
{
  const ContactSection &contact = foot.specification().study.contact;
  const ring::Motion &motion = foot.specification().study.motion.orbit;
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
    spins.unit = balance.motion.orbit_speed / report.radius() / (is_hard ? 2 : 4);
  // Without a torque at rest the glass does not spin up, unless rest is unstable. Its load is needed at the
  // small spins of the torque's slope.
  const double radius = report.radius();
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
fem::ContactState contact_at_rest(ElasticFoot &foot, const ring::Orientation &marks, Progress &progress)
{
  const auto &[study, discretisation, model] = foot.specification();
  fem::ContactDemand demand = study.required_resultants();
  if (study.tilts()) // the weight of the tilted glass has a moment
    demand.tilt_moment = demand.normal_force * study.motion.orbit.overturning_height();
  fem::ContactState state = foot.solve_at_rest(demand, marks, progress);
  if (!foot.has_rings())
  {
    choose_rings(foot, state);
    state.load = foot.project_onto_rings(state);
  }
  return state;
}

BalancedLoad contact_load(const std::shared_ptr<ElasticFoot> &foot, unsigned int n_harmonics,
                          Progress &progress, bool few_phases)
{
  const auto &[study, discretisation, model] = foot->specification();
  const ContactBalance balance = moment_balance(study, n_harmonics);
  const fem::ContactState state = contact_at_rest(*foot, balance.orientation, progress);
  progress.stage_done("contact");
  const ring::PhasePeriods periods = phase_periods(*foot);
  const bool is_hard = study.table.is_hard(), is_coarse = is_hard && few_phases;
  return periods.any() ? load_over_phases(foot, balance, periods, state, is_hard, is_coarse, progress)
                       : load_at_one_phase(foot, balance, state, progress);
}

BalancedLoad load_from_file(const LoadSection &section)
{
  const ring::RingStack &load = *section.from_file;
  const double ratio = load.moment_ratio(load.radius());
  const auto [given, limit] = distinct_texts(ratio, 2);
  const std::string sentence = "The load of " + shortened_path(section.file) +
                               " has a moment ratio sqrt(a_1^2 + b_1^2) / a_0 of " + given +
                               ", but a ring tips at " + limit + "; give smaller a_1, b_1.";
  ensure(ratio < 2, sentence);
  return given_load(load);
}

} // namespace

ContactBalance moment_balance(const Study &study, unsigned int n_harmonics)
{
  const ring::Motion &motion = study.motion.orbit;
  return { motion,        study.motion.closure,     ring::orientation_of_marks(motion, 0, 0),
           study.tilts(), study.varies_with_spin(), n_harmonics };
}

ring::PhasePeriods phase_periods(const fem::RimImperfection &imperfection)
{
  return { period_of(imperfection.glass), period_of(imperfection.table) };
}

ring::PhasePeriods phase_periods(const ElasticFoot &foot)
{
  const auto &[study, discretisation, model] = foot.specification();
  ring::PhasePeriods periods = phase_periods({ study.glass.waviness, study.table.waviness });
  if (const double of_mesh = foot.body().capabilities().glass_period; of_mesh > 0)
    periods.glass = of_mesh;
  return periods;
}

BalancedLoad find_load(const Study &study, const std::shared_ptr<ElasticFoot> &foot, Progress &progress,
                       unsigned int n_harmonics, bool few_phases)
{
  const double radius = study.glass.profile.contact_radius;
  switch (study.load.source)
  {
  case LoadSource::contact:
    return contact_load(foot, n_harmonics, progress, few_phases);
  case LoadSource::first_harmonic:
  {
    if (!study.load.is_static())
      return first_harmonic_load(study.motion.orbit, study.motion.closure, radius);
    const fem::Resultants demand = study.required_resultants();
    return given_load(
      ring::RingStack::first_harmonic(demand.normal_force, { demand.moment_x, demand.moment_y }, radius));
  }
  case LoadSource::file:
    return load_from_file(study.load);
  }
  throw std::logic_error("a load source without a load");
}

BalancedLoad find_load_at_phase(const std::shared_ptr<ElasticFoot> &foot,
                                const ring::Orientation &orientation, unsigned int n_harmonics)
{
  const fem::ContactState state = contact_at_rest(*foot, orientation, silent_progress());
  return load_at_one_phase(foot, moment_balance(foot->specification().study, n_harmonics), state,
                           silent_progress());
}

BalancedLoad first_harmonic_load(const ring::Motion &motion, ring::Closure closure, double contact_radius)
{
  const ring::SelfConsistentRing ring(closure, motion, contact_radius);
  return { ring::Load([ring](double omega) { return ring.at(omega).load; }), report_of(ring.at(0).load) };
}

} // namespace stemware::pipeline
