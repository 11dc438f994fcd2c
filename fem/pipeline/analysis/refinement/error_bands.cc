#include "fem/pipeline/analysis/refinement/error_bands.h"

#include "fem/pipeline/analysis/spin.h"
#include "fem/pipeline/coupling/make_foot.h"
#include "fem/pipeline/coupling/orientation.h"
#include "fem/pipeline/coupling/study_load.h"
#include "fem/pipeline/support/numbers.h"

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

namespace stemware::pipeline
{

namespace
{

/// Where a study is looked at.
struct Probe
{
  std::vector<double> spins; ///< rest, half, below, at, above and one and a half times the terminal spin
  double first = 0;          ///< terminal spin of the first harmonic alone
  bool has_first = false;
  std::vector<ring::Orientation> phases;
};

/// What is found there.
struct Findings
{
  LoadReport at_rest;
  std::vector<double> torques; ///< yaw_torque() at Probe::spins, means over the phases; NaN without a balance
  double torque_of_first = 0;  ///< of the first harmonic, at Probe::first
};

double torque_or_nan(const BalancedLoad &load, const ring::Motion &motion, double omega)
{
  try
  {
    return yaw_torque(load, motion, omega);
  }
  catch (const std::runtime_error &)
  {
    return std::nan("");
  }
}

Findings look(const Study &study, const std::shared_ptr<ElasticFoot> &foot, const Probe &probe)
{
  Findings found;
  found.torques.assign(probe.spins.size(), 0.);
  const double share = 1. / static_cast<double>(probe.phases.size());
  for (const ring::Orientation &phase : probe.phases)
  {
    const BalancedLoad load = find_load_at_phase(study, foot, phase);
    if (&phase == &probe.phases.front())
      found.at_rest = load.report();
    for (std::size_t i = 0; i < probe.spins.size(); ++i)
      found.torques[i] += share * torque_or_nan(load, study.motion.orbit, probe.spins[i]);
    if (probe.has_first)
      found.torque_of_first +=
        share * torque_or_nan(find_load_at_phase(study, foot, phase, 1), study.motion.orbit, probe.first);
  }
  return found;
}

/// The marks of glass and table at equally spaced phases; one where nothing is out of flat.
std::vector<ring::Orientation> phases_of(const Study &study)
{
  constexpr unsigned int n_phases = 8;
  const ring::Orientation start = moment_balance(study).orientation;
  if (!study.has_waviness())
    return { start };
  std::vector<ring::Orientation> phases;
  for (unsigned int i = 0; i < n_phases; ++i)
  {
    // Steps that visit the phases of glass and table in all combinations of even and odd.
    const double turn = boost::math::double_constants::two_pi / n_phases;
    phases.push_back({ start.glass + turn * i, start.table + turn * (3 * i % n_phases) });
  }
  return phases;
}

/// Quantities at a terminal spin that differs from the one looked at by what the torque there says.
std::vector<QuantityOfInterest> quantities_from(const Findings &found, const Probe &probe,
                                                const Findings &own, const SpinRow &row, const Study &study)
{
  const ring::Motion &motion = study.motion.orbit;
  QuantityNoise noise;
  noise.n_azimuths = study.contact.azimuth_lines;
  std::vector<QuantityOfInterest> quantities = load_quantities(found.at_rest, noise);
  const double torque_noise = noise.relative * motion.friction_at_rest() * found.at_rest.normal_force *
                              study.glass.profile.contact_radius;
  quantities.push_back({ "tau_at_rest", "torque at rest", "N m", found.torques[0], torque_noise });
  quantities.push_back({ "tau_at_spin_1", "torque at " + to_short_text(probe.spins[1]) + " rad/s", "N m",
                         found.torques[1], torque_noise });
  quantities.push_back({ "tau_at_spin_2", "torque at " + to_short_text(probe.spins[5]) + " rad/s", "N m",
                         found.torques[5], torque_noise });
  const double slope = (found.torques[4] - found.torques[2]) / (probe.spins[4] - probe.spins[2]);
  const double moved = -(found.torques[3] - own.torques[3]) / slope;
  const double spin_noise = noise.relative * motion.orbit_speed / study.glass.profile.contact_radius;
  quantities.push_back(
    { "omega_terminal", "terminal spin", "rad/s", row.terminal->omega + moved, spin_noise });
  const double time = motion.yaw_inertia / std::abs(slope);
  quantities.push_back({ "time_constant", "time constant", "s", time, 1e3 * noise.relative * time });
  if (probe.has_first)
  {
    const double first_moved = -(found.torque_of_first - own.torque_of_first) / slope;
    quantities.push_back({ "omega_first_harmonic", "terminal spin of the first harmonic", "rad/s",
                           probe.first + first_moved, spin_noise });
    quantities.push_back({ "harmonic_effect", "effect of the harmonics", "rad/s",
                           row.terminal->omega + moved - probe.first - first_moved, spin_noise });
  }
  return quantities;
}

/// A change of one numerical parameter, and how much of what it changes goes into the band.
struct Change
{
  std::string part;
  double factor;
  Study study;
  std::optional<std::size_t>
    from = {}; ///< earlier change that it is compared with; nothing: the study itself
};

std::vector<Change> changes_of(const Study &study, const ElasticFoot &foot, bool is_full)
{
  constexpr double safety = 1.25;
  std::vector<Change> changes;
  const auto changed = [](Study copy, const std::function<void(ContactSection &)> &change)
  {
    change(copy.contact);
    return copy;
  };
  // Where cells are small, a higher degree is tried on the coarse ones: that tells more than enough.
  // Meshes for a goal: the one before.
  const Study coarse = changed(study,
                               [](ContactSection &contact)
                               {
                                 if (contact.halved.empty())
                                   contact.fineness /= 2;
                                 else
                                   contact.halved.pop_back();
                               });
  changes.push_back({ "mesh", safety, coarse });
  if (study.contact.degree < 4)
  {
    const auto higher = [](ContactSection &contact) { ++contact.degree; };
    if (study.table.is_hard())
      changes.push_back({ "degree", safety, changed(coarse, higher), 0 });
    else
      changes.push_back({ "degree", safety, changed(study, higher) });
  }
  const Study fewer =
    changed(study, [](ContactSection &contact) { contact.harmonics = std::max(contact.harmonics / 2, 1u); });
  std::optional<std::size_t> of_fewer;
  if (study.contact.harmonics > 1)
  {
    of_fewer = changes.size();
    changes.push_back({ "harmonics", 0.5, fewer });
  }
  // At re-entrant corners the error falls with the first order: the halved cells show half of it. What cells
  // that far from the contact change fades with the harmonic, so that half of them will do.
  if (study.contact.halved.empty() && has_focused_mesh(study))
    changes.push_back({ "mesh", 2,
                        changed(fewer, [](ContactSection &contact) { ++contact.halvings_beyond_focus; }),
                        of_fewer });
  if (!is_full)
    changes.push_back(
      { "lines", safety, changed(study, [](ContactSection &contact) { contact.azimuth_lines *= 4; }) });
  if (study.table.is_hard())
    changes.push_back(
      { "interface", 1.5, changed(study, [](ContactSection &contact) { contact.hardness *= 10; }) });
  const unsigned int n = foot.n_harmonics(), resolved = foot.body().n_resolved_harmonics();
  changes.push_back(
    { "load_harmonics", safety,
      changed(study, [=](ContactSection &contact)
              { contact.load_harmonics = n < resolved ? std::min(2 * n, resolved) : n / 2; }) });
  changes.push_back({ "rings", safety,
                      changed(study,
                              [](ContactSection &contact)
                              {
                                constexpr unsigned int enough = 5, most = 12;
                                const unsigned int n = contact.rings;
                                contact.rings = n == 1 ? enough : n <= most ? 2 * n : n / 2;
                              }) });
  return changes;
}

bool carries_all_round(const SpinRow &all, const LoadReport &at_rest)
{
  return at_rest.contact_fraction >= 1 && at_rest.minimum > 0.02 * at_rest.rings.a(0) &&
         all.at_terminal->load.minimum() > 0.02 * at_rest.rings.a(0);
}

ErrorBands bands_of(const Study &study, const std::shared_ptr<ElasticFoot> &foot, const SpinRow &all,
                    const std::optional<double> &first, fem::ComplianceCache &cache, Progress &progress)
{
  if (!foot || !abilities(study.contact.body).is_of_revolution || !all.terminal)
    return {};
  const double omega = all.terminal->omega;
  const double scale = study.motion.orbit.orbit_speed / study.glass.profile.contact_radius;
  Probe probe;
  probe.spins = { 0, omega / 2, omega - scale / 512, omega, omega + scale / 512, 1.5 * omega };
  probe.has_first = first.has_value();
  probe.first = first.value_or(0);
  probe.phases = phases_of(study);
  const Findings own = look(study, foot, probe);

  ErrorBands bands;
  for (const QuantityOfInterest &quantity : quantities_from(own, probe, own, all, study))
    if (std::isfinite(quantity.value))
      bands.push_back({ quantity, quantity.rounding, quantity.value, { { "solver", quantity.rounding } } });
  const std::vector<Change> changes = changes_of(study, *foot, carries_all_round(all, own.at_rest));
  std::vector<Findings> by_change;
  for (const Change &change : changes)
  {
    const std::shared_ptr<ElasticFoot> changed_foot =
      study_foot(change.study, cache, silent_progress(), foot.get());
    if (change.part != "rings" && change.part != "load_harmonics")
      changed_foot->set_rings(foot->ring_radii(), foot->n_harmonics());
    by_change.push_back(look(change.study, changed_foot, probe));
    const auto to = quantities_from(by_change.back(), probe, own, all, study);
    const auto from = quantities_from(change.from ? by_change[*change.from] : own, probe, own, all, study);
    for (BandedQuantity &banded : bands)
    {
      const std::string &key = banded.quantity.key;
      const double part = change.factor * std::abs(quantity_of(to, key).value - quantity_of(from, key).value);
      if (!std::isfinite(part))
        continue;
      banded.parts[change.part] += part;
      banded.band += part;
    }
    progress.pieces_done("error bands", by_change.size(), changes.size());
  }
  if (all.spin_uncertainty > 0)
    for (BandedQuantity &banded : bands)
      if (banded.quantity.key == "omega_terminal")
      {
        banded.parts["interpolation"] = all.spin_uncertainty;
        banded.band += all.spin_uncertainty;
      }
  return bands;
}

} // namespace

ErrorBands estimate_bands(const Study &study, const std::shared_ptr<ElasticFoot> &foot, const SpinRow &all,
                          const std::optional<double> &first, fem::ComplianceCache &cache, Progress &progress)
{
  try
  {
    return bands_of(study, foot, all, first, cache, progress);
  }
  catch (const fem::ContactFailure &)
  {
    return {};
  }
}

void add_bands(const ErrorBands &bands, Budget &budget)
{
  const std::optional<double> all = band_of(bands, "omega_terminal"),
                              first = band_of(bands, "omega_first_harmonic");
  if (!all)
    return;
  const double wider = std::max(*all, first.value_or(0));
  for (BudgetRow &row : budget.rows)
    if (row.step >= "3" && row.omega_terminal)
      row.band = row.harmonics ? wider : *all;
}

} // namespace stemware::pipeline
