#include "fem/pipeline/analysis/error_bands.h"

#include "fem/contact/footprint.h"
#include "fem/pipeline/analysis/band_changes.h"
#include "fem/pipeline/analysis/changed_load.h"
#include "fem/pipeline/analysis/study_rows.h"
#include "fem/pipeline/base/failures.h"
#include "fem/pipeline/coupling/study_load.h"
#include "ring_model/friction_functionals.h"
#include "ring_model/if_balanced.h"
#include "ring_model/terminal_spin.h"

#include <Eigen/Core>
#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace stemware::pipeline
{

namespace
{

/// Where a study is looked at.
struct EvaluationPoints
{
  /// Rest, half, once and one and a half times the terminal spin; four close to it if these do not tell the
  /// slope there.
  std::vector<double> spins;
  std::optional<double> first; ///< terminal spin of the first harmonic alone
  std::vector<ring::Orientation> phases;
  double spin_scale = 0;   ///< v / R [rad/s]
  bool with_width = false; ///< the width of the contact has a band
};

/// Torques at one spin [N m]; NaN without a balance.
struct Torques
{
  double friction; ///< tau_z
  double all;      ///< yaw_torque(), whose zero is the terminal spin
};

/// Load and torques that are found at EvaluationPoints.
struct Evaluation
{
  LoadReport at_rest;
  Eigen::Vector3d table_motion; ///< at rest: q_0 [m], q_1 and q_2 [rad]
  std::vector<Torques> torques; ///< at EvaluationPoints::spins, means over the phases
  double torque_of_first = 0;   ///< yaw_torque() of the first harmonic, at EvaluationPoints::first
  double slope_of_first = 0;    ///< its slope [N m s]; of the study's own loads
};

/// The loads of a study by the phases of EvaluationPoints.
struct LoadsAtPhases
{
  std::vector<BalancedLoad> all, first; ///< first harmonic alone, where it is looked at
};

LoadsAtPhases loads_of(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                       const EvaluationPoints &probe)
{
  LoadsAtPhases loads;
  for (const ring::Orientation &phase : probe.phases)
  {
    loads.all.push_back(find_load_at_phase(study, foot, phase));
    if (probe.first)
      loads.first.push_back(find_load_at_phase(study, foot, phase, 1));
  }
  return loads;
}

/// Torques of @p load; with @p gathering those of the same contacts of @p foot when their pressure is
/// gathered like that.
Torques torques_of(const BalancedLoad &load, const ElasticFoot &foot, const ring::Motion &motion,
                   double omega, const std::optional<RingProjection> &ring_projection)
{
  const auto find = [&]
  {
    const ring::Sample at_spin = load.at(omega);
    const auto projected = [&]
    {
      const unsigned int n =
        load.n_harmonics() < foot.n_harmonics() ? load.n_harmonics() : ring_projection->n_harmonics;
      return foot.body().project_onto_rings(*load.contact(omega), ring_projection->radii, n);
    };
    const double friction = ring_projection ? ring::wrench(motion, projected(), omega).torque
                                            : ring::wrench(motion, at_spin, omega).torque;
    return Torques{ friction, friction + at_spin.lean_torque() };
  };
  return ring::if_balanced(find).value_or(Torques{ std::nan(""), std::nan("") });
}

Evaluation evaluate(const LoadsAtPhases &loads, const ElasticFoot &foot, const ring::Motion &motion,
                    const EvaluationPoints &probe, const std::optional<RingProjection> &ring_projection = {})
{
  Evaluation found = {};
  found.at_rest = loads.all.front().report();
  if (probe.with_width)
    if (const fem::PressureMap map = foot.body().pressure_map(*loads.all.front().contact(0));
        fem::has_cells(map))
      found.at_rest.contact_width = fem::measures_of(map).widest;
  found.table_motion = loads.all.front().contact(0).value().solution.motion;
  found.torques.assign(probe.spins.size(), { 0, 0 });
  const double share = 1. / static_cast<double>(probe.phases.size());
  for (const BalancedLoad &load : loads.all)
    for (std::size_t i = 0; i < probe.spins.size(); ++i)
    {
      const Torques torques = torques_of(load, foot, motion, probe.spins[i], ring_projection);
      found.torques[i].friction += share * torques.friction;
      found.torques[i].all += share * torques.all;
    }
  for (const BalancedLoad &load : loads.first)
    found.torque_of_first += share * torques_of(load, foot, motion, *probe.first, ring_projection).all;
  return found;
}

/// Slope of the yaw_torque() of the first harmonic at EvaluationPoints::first, the mean over the phases [N m
/// s]; NaN without a balance there.
double slope_of_first(const LoadsAtPhases &loads, const ElasticFoot &foot, const ring::Motion &motion,
                      const EvaluationPoints &probe)
{
  const auto torque = [&](double omega)
  {
    double sum = 0;
    for (const BalancedLoad &load : loads.first)
      sum += torques_of(load, foot, motion, omega, {}).all;
    return sum / static_cast<double>(loads.first.size());
  };
  return ring::torque_slope(torque, *probe.first, ring::slope_step(*probe.first, probe.spin_scale));
}

/// The marks of glass and table at equally spaced phases of their periods; one where nothing is out of flat.
std::vector<ring::Orientation> phases_of(const Study &study, const ElasticFoot &foot)
{
  const ring::Orientation start = moment_balance(study).orientation;
  const ring::PhasePeriods periods = phase_periods(study, foot);
  if (!periods.any())
    return { start };
  constexpr unsigned int n_phases = 4;
  std::vector<ring::Orientation> phases;
  for (unsigned int i = 0; i < n_phases; ++i)
    // Glass and table turn against each other.
    phases.push_back({ start.glass + periods.glass * i / n_phases,
                       start.table + periods.table * (3 * i % n_phases) / n_phases });
  return phases;
}

/// The reported numbers of @p row, each changed by what changes from @p own to @p found: at a terminal spin
/// that differs from the one looked at by what the torque there says.
std::vector<QuantityOfInterest> quantities_from(const Evaluation &found, const EvaluationPoints &probe,
                                                const Evaluation &own, const ring::Answer &row,
                                                const Study &study)
{
  // From the side of rest where the glass tips on the other.
  const auto is_known = [&](std::size_t i)
  { return std::isfinite(own.torques[i].all) && std::isfinite(found.torques[i].all); };
  const std::size_t end = is_known(3) ? 3 : 2;
  const bool is_close = probe.spins.size() == 8 && is_known(4) && is_known(5) && is_known(6) && is_known(7);
  const auto slope_of = [&](const Evaluation &at)
  {
    const auto change = [&](std::size_t from, std::size_t to)
    { return at.torques[to].all - at.torques[from].all; };
    return is_close ? ring::slope_of_differences(change(5, 6), change(4, 7), probe.spins[6] - probe.spins[2])
                    : change(1, end) / (probe.spins[end] - probe.spins[1]);
  };
  const double slope = std::isfinite(row.terminal->torque_slope) ? row.terminal->torque_slope : slope_of(own);
  const double moved = -(found.torques[2].all - own.torques[2].all) / slope;
  constexpr double noise_of_differences = 1e3;
  const SpinNumbers spin = {
    row.at_rest->friction.torque + (found.torques[0].friction - own.torques[0].friction),
    { probe.spins[1], probe.spins[3] },
    { found.torques[1].friction, found.torques[3].friction },
    row.terminal->omega + moved,
    study.motion.orbit.yaw_inertia / std::abs(slope + (slope_of(found) - slope_of(own))),
    study.glass.profile.contact_radius,
    spin_scale(study),
    noise_of_differences
  };
  std::vector<QuantityOfInterest> quantities =
    quantities_of_interest(study, found.at_rest, found.table_motion, spin);
  if (probe.first)
  {
    const double slope_there = std::isfinite(own.slope_of_first) ? own.slope_of_first : slope;
    const double first_moved = -(found.torque_of_first - own.torque_of_first) / slope_there;
    const double spin_noise = relative_noise * spin.spin_scale;
    quantities.push_back({ "omega_first_harmonic", "terminal spin of the first harmonic", "rad/s",
                           *probe.first + first_moved, spin_noise });
    quantities.push_back({ "harmonic_effect", "effect of the harmonics", "rad/s",
                           spin.omega_terminal - *probe.first - first_moved, spin_noise });
  }
  return quantities;
}

bool carries_all_round(const ring::Answer &all, const LoadReport &at_rest)
{
  return at_rest.contact_fraction >= 1 && at_rest.minimum > 0.02 * at_rest.rings.a(0) &&
         all.at_terminal->load.minimum() > 0.02 * at_rest.rings.a(0);
}

EvaluationPoints probe_of(const Study &study, const ElasticFoot &foot, double omega,
                          const std::optional<double> &first)
{
  EvaluationPoints probe;
  probe.spins = { 0, omega / 2, omega, 1.5 * omega };
  probe.first = first;
  probe.phases = phases_of(study, foot);
  probe.with_width = study.table.is_hard() && study.glass.profile.crown_radius > 0 &&
                     abilities(study.contact.body).is_of_revolution;
  probe.spin_scale = study.motion.orbit.orbit_speed / study.glass.profile.contact_radius;
  return probe;
}

/// Adds the spins of torque_slope() if those farther away do not tell the slope at the terminal spin: near
/// |omega| = v / R, where the rim rolls on one side and the torque bends sharply, and with lift-off, where
/// the edges of the contact move across the azimuth lines.
void add_slope_spins(bool is_full, EvaluationPoints &probe)
{
  const double omega = probe.spins[2];
  if (is_full && omega != 0 && 1.5 * std::abs(omega) <= probe.spin_scale)
    return;
  const double step = ring::slope_step(omega, probe.spin_scale);
  probe.spins.insert(probe.spins.end(), { omega - 2 * step, omega - step, omega + step, omega + 2 * step });
}

/// Returns the loads of a changed foot from few of its contacts: at rest at every phase, and at the terminal
/// spin at every phase or, of a costly foot, at the first. The spin and the phase matter less to the change
/// of a load than to the load.
LoadsAtPhases changed_loads(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                            const LoadsAtPhases &own, const EvaluationPoints &probe)
{
  LoadsAtPhases loads;
  Eigen::VectorXd per_spin, per_spin_of_first;
  for (std::size_t i = 0; i < own.all.size(); ++i)
  {
    const auto add = [&](const BalancedLoad &before, unsigned int n_harmonics, double omega,
                         Eigen::VectorXd &change_by_spin, std::vector<BalancedLoad> &to)
    {
      const BalancedLoad changed = find_load_at_phase(study, foot, probe.phases[i], n_harmonics);
      LoadChange change = change_at_rest(before, changed);
      if (i == 0 || !is_collective(study))
        change_by_spin = change_per_spin(before, changed, change, omega);
      change.per_spin = change_by_spin;
      to.push_back(changed_load(before, changed, change));
    };
    add(own.all[i], all_harmonics, probe.spins[2], per_spin, loads.all);
    if (probe.first)
      add(own.first[i], 1, *probe.first, per_spin_of_first, loads.first);
  }
  return loads;
}

/// The quantities in the contacts of @p foot, that of a change, on the rings of @p own, the study's own with
/// its loads @p own_loads, unless they are what changes.
Evaluation evaluate(const BandChange &change, const std::shared_ptr<ElasticFoot> &foot,
                    const ElasticFoot &own, const LoadsAtPhases &own_loads, const EvaluationPoints &probe)
{
  if (change.shared == Shared::contact)
    foot->reset_rings();
  else
    foot->set_rings(own.ring_radii(), own.n_harmonics());
  const bool is_costly = is_collective(change.study) || probe.phases.size() > 1;
  const LoadsAtPhases loads = is_costly && change.shared != Shared::contact
                                ? changed_loads(change.study, foot, own_loads, probe)
                                : loads_of(change.study, foot, probe);
  return evaluate(loads, *foot, change.study.motion.orbit, probe);
}

/// Adds to the parts of @p bands what @p change moves the quantities by, from @p before to @p after. What it
/// leaves without a value has no band.
void add_part(const BandChange &change, const std::vector<QuantityOfInterest> &before,
              const std::vector<QuantityOfInterest> &after, ErrorBands &bands)
{
  if (change.factor == 0)
    return;
  for (BandedQuantity &banded : bands)
  {
    const std::string &key = banded.quantity.key;
    const double move = change.compares_over_spins
                          ? max_change_over_spins(key, before, after, change.study.motion.orbit.yaw_inertia)
                          : std::abs(quantity_of(after, key).value - quantity_of(before, key).value);
    double &part = banded.parts[change.part];
    const double added =
      change.is_alternative ? std::max(change.factor * move - part, 0.) : change.factor * move;
    part += added;
    banded.band += added;
  }
  bands.erase(std::remove_if(bands.begin(), bands.end(),
                             [](const BandedQuantity &banded) { return !std::isfinite(banded.band); }),
              bands.end());
}

/// Widens the part "lines" of harmonics whose errors vanish by chance on the study's lines. All harmonics n >
/// 1 share the error that comes from the place of an edge between two lines, and its change to four times the
/// lines, which leave 1/32 of it (order 5/2), tells it to 1/32 of the largest.
void widen_parts_of_lines(ErrorBands &bands)
{
  constexpr double rest_on_more_lines = 1. / 32;
  std::vector<BandedQuantity *> harmonics;
  for (BandedQuantity &banded : bands)
    if (const std::string &key = banded.quantity.key; key.size() == 2 && (key[0] == 'a' || key[0] == 'b') &&
                                                      key[1] > '1' && banded.parts.count("lines") > 0)
      harmonics.push_back(&banded);
  double largest = 0;
  for (const BandedQuantity *banded : harmonics)
    largest = std::max(largest, banded->parts.at("lines"));
  for (BandedQuantity *banded : harmonics)
  {
    const double added = std::max(0., rest_on_more_lines * largest - banded->parts.at("lines"));
    banded->parts.at("lines") += added;
    banded->band += added;
  }
}

ErrorBands bands_of(const Study &study, const std::shared_ptr<ElasticFoot> &foot, const ring::Answer &all,
                    const std::optional<double> &first, const Executor &executor, Progress &progress,
                    const std::vector<QuantityOfInterest> &reported)
{
  EvaluationPoints probe = probe_of(study, *foot, all.terminal->omega, first);
  const ring::Motion &motion = study.motion.orbit;
  const LoadsAtPhases own_loads = loads_of(study, foot, probe);
  const bool is_full = carries_all_round(all, own_loads.all.front().report());
  add_slope_spins(is_full, probe);
  Evaluation own = evaluate(own_loads, *foot, motion, probe);
  if (first)
    own.slope_of_first = slope_of_first(own_loads, *foot, motion, probe);
  std::vector<BandChange> changes = band_changes(study, *foot, own.at_rest, is_full);
  const auto quantities = [&](const Evaluation &found)
  { return quantities_from(found, probe, own, all, study); };
  const std::vector<QuantityOfInterest> unchanged = quantities(own);
  ErrorBands bands;
  for (QuantityOfInterest quantity : unchanged)
    if (std::isfinite(quantity.value))
    {
      for (const QuantityOfInterest &known : reported)
        if (known.key == quantity.key)
          quantity.value = known.value;
      bands.push_back({ quantity, quantity.rounding, quantity.value, { { "solver", quantity.rounding } } });
    }

  const auto projected = std::stable_partition(
    changes.begin(), changes.end(), [](const BandChange &change) { return !change.ring_projection; });
  for (auto change = projected; change != changes.end(); ++change)
    add_part(*change, unchanged,
             quantities(evaluate(own_loads, *foot, motion, probe, change->ring_projection)), bands);
  changes.erase(projected, changes.end());

  const auto look_at = [&](const BandChange &change, const std::shared_ptr<ElasticFoot> &its_foot)
  { return evaluate(change, its_foot, *foot, own_loads, probe); };
  const auto done = [&, tell = counting_callback(progress, "error bands", changes.size())](
                      std::size_t i, const Solved<Evaluation> &solved) mutable
  {
    solved.value(); // one that fails leaves no band
    tell(i, solved);
  };
  const std::vector<Solved<Evaluation>> found = solve(changes, foot, look_at, executor, done);
  std::map<std::string, std::vector<QuantityOfInterest>> by_part; // of the first change of each part
  for (std::size_t i = 0; i < changes.size(); ++i)
  {
    const std::string &from = changes[i].from;
    const auto after = quantities(found[i].value());
    add_part(changes[i], from.empty() ? unchanged : by_part.at(from), after, bands);
    by_part.emplace(changes[i].part, after);
  }
  widen_parts_of_lines(bands);
  for (BandedQuantity &banded : bands)
    if (banded.quantity.key == "omega_terminal" && all.spin_uncertainty > 0)
    {
      banded.parts["interpolation"] = all.spin_uncertainty;
      banded.band += all.spin_uncertainty;
    }
  return bands;
}

} // namespace

ErrorBands estimate_bands(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                          const ring::Answer &all, const std::optional<double> &first,
                          const Executor &executor, Progress &progress,
                          const std::vector<QuantityOfInterest> &reported)
{
  if (!foot || !all.terminal)
    return {};
  try
  {
    return bands_of(study, foot, all, first, executor, progress, reported);
  }
  catch (const std::exception &failure)
  {
    if (!executor.keeps_all_failures && !is_variant_failure(failure))
      throw;
    progress.note("No band", failure.what());
  }
  return {};
}

std::vector<QuantityOfInterest> reported_quantities(const LoadReport &at_rest, const Budget &budget)
{
  std::vector<QuantityOfInterest> reported = load_quantities(at_rest);
  if (const std::optional<double> &at_half = budget.rows.back().torques[1])
    reported.push_back({ "tau_at_spin_1", "", "N m", *at_half });
  return reported;
}

void add_bands(const std::optional<double> &of_all, const std::optional<double> &of_first,
               std::vector<BudgetRow> &rows)
{
  if (!of_all || rows.empty() || !rows.back().omega_terminal)
    return;
  const double all = *rows.back().omega_terminal;
  const auto first =
    std::find_if(rows.rbegin(), rows.rend(), [](const BudgetRow &row) { return row.step.number == 3; });
  const bool has_first = of_first && first != rows.rend() && first->omega_terminal;
  const double spin_of_first = has_first ? *first->omega_terminal : 0;
  for (BudgetRow &row : rows)
  {
    if (!row.step.is_of_contact() || !row.omega_terminal)
      continue;
    const double from_all = *of_all + std::abs(*row.omega_terminal - all);
    if (has_first)
      row.band = std::min({ std::max(*of_all, *of_first), from_all,
                            *of_first + std::abs(*row.omega_terminal - spin_of_first) });
    else if (from_all <= 2 * *of_all)
      row.band = from_all;
  }
}

} // namespace stemware::pipeline
