#include "fem/pipeline/analysis/error_bands.h"

#include "fem/contact/footprint.h"
#include "fem/pipeline/base/failures.h"
#include "fem/pipeline/coupling/study_load.h"
#include "ring_model/failures.h"
#include "ring_model/spin/curves.h"
#include "ring_model/terminal_spin.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <map>

namespace stemware::pipeline
{

namespace
{

/// Spins and phases at which the torques of a study and of its changed variants are compared.
struct EvaluationPoints
{
  /// 0, 0.5, 1 and 1.5 times the terminal spin, and any spins of add_slope_spins().
  std::vector<double> spins;
  std::optional<double> first; ///< terminal spin with the first harmonic only
  std::vector<ring::Orientation> phases;
  bool with_width = false; ///< true if the contact width has an error band
};

/// Load and torques at EvaluationPoints. The torques are means over the phases, without the grip torque.
struct Evaluation
{
  LoadReport at_rest;
  Eigen::Vector3d table_motion;       ///< motion at rest: q_0 [m], q_1 and q_2 [rad]
  std::vector<ring::Torques> torques; ///< torques at EvaluationPoints::spins
  double torque_of_first = 0;         ///< torque() of the first harmonic at EvaluationPoints::first [N m]
  double slope_of_first = 0; ///< slope of torque_of_first [N m s]; computed for the study's own loads only
};

struct LoadsAtPhases
{
  /// `first`: loads of the first harmonic only; empty if EvaluationPoints::first has no value.
  std::vector<BalancedLoad> all, first;
};

LoadsAtPhases loads_of(const std::shared_ptr<ElasticFoot> &foot, const EvaluationPoints &probe)
{
  LoadsAtPhases loads;
  for (const ring::Orientation &phase : probe.phases)
  {
    loads.all.push_back(find_load_at_phase(foot, phase));
    if (probe.first)
      loads.first.push_back(find_load_at_phase(foot, phase, 1));
  }
  return loads;
}

/// Returns @p loads with the same contact pressure, projected onto the rings of @p change.
LoadsAtPhases projected(LoadsAtPhases loads, const ElasticFoot &foot, const BandChange &change)
{
  for (auto *list : { &loads.all, &loads.first })
    for (BalancedLoad &load : *list)
    {
      const bool is_cut = load.n_harmonics() < foot.n_harmonics();
      const unsigned int n = is_cut ? load.n_harmonics() : change.n_harmonics;
      const auto on_rings = [own = load, &foot, &change, n](double omega) -> ring::Sample
      {
        const ring::Sample at_spin = own.at(omega);
        return { foot.body().project_onto_rings(*own.contact(omega), change.ring_radii, n), at_spin.tilt };
      };
      load = load.with(ring::Load(on_rings, true));
    }
  return loads;
}

/// Returns the torques at @p spins, averaged over @p loads (one per phase); NaN if a load has no balance.
std::vector<ring::Torques> mean_torques(const std::vector<BalancedLoad> &loads, const ring::Motion &motion,
                                        const std::vector<double> &spins)
{
  std::vector<ring::Torques> mean(spins.size());
  const double share = 1. / static_cast<double>(loads.size());
  for (const BalancedLoad &load : loads)
  {
    const std::vector<ring::Torques> torques = ring::torque_curve(load, { motion }, spins);
    for (std::size_t i = 0; i < spins.size(); ++i)
    {
      mean[i].friction.torque += share * torques[i].friction.torque;
      mean[i].lean_torque += share * torques[i].lean_torque;
    }
  }
  return mean;
}

Evaluation evaluate(const LoadsAtPhases &loads, const ElasticFoot &foot, const EvaluationPoints &probe)
{
  const ring::Motion &motion = foot.specification().study.motion.orbit;
  Evaluation found = {};
  const fem::ContactState contact = loads.all.front().contact(0).value();
  found.at_rest = loads.all.front().report();
  if (probe.with_width)
    if (const fem::PressureMap map = foot.body().pressure_map(contact); fem::has_cells(map))
      found.at_rest.contact_width = fem::measures_of(map).widest;
  found.table_motion = contact.solution.motion;
  found.torques = mean_torques(loads.all, motion, probe.spins);
  if (probe.first)
    found.torque_of_first = mean_torques(loads.first, motion, { *probe.first }).front().torque();
  return found;
}

/// Returns equally spaced orientations of glass and table, or a single orientation if neither is wavy or if
/// the glass does not spin up: its torque at rest is the same at all phases.
std::vector<ring::Orientation> phases_of(const ElasticFoot &foot, double omega)
{
  const auto &[study, discretisation, model] = foot.specification();
  const ring::Orientation start = moment_balance(study).orientation;
  const ring::PhasePeriods periods = phase_periods(foot);
  if (!periods.any() || std::abs(omega) <= 1e-6 * study.spin_unit())
    return { start };
  constexpr unsigned int n_phases = 4;
  std::vector<ring::Orientation> phases;
  for (unsigned int i = 0; i < n_phases; ++i)
    // Glass and table rotate in opposite directions, so the phase of the table decreases: 3 i mod 4 = 0, 3,
    // 2, 1.
    phases.push_back({ start.glass + periods.glass * i / n_phases,
                       start.table + periods.table * (3 * i % n_phases) / n_phases });
  return phases;
}

/// Returns the reported numbers of @p row plus the change from @p own to @p found. The change of the terminal
/// spin follows from the change of the torque and the slope, so no second search is needed.
std::vector<QuantityOfInterest> quantities_from(const Evaluation &found, const EvaluationPoints &probe,
                                                const Evaluation &own, const ring::Answer &row,
                                                const Analysis &analysis)
{
  // If the glass tips at the highest spin, the slope is computed from the spins up to the terminal spin.
  const auto is_known = [&](std::size_t i)
  { return std::isfinite(own.torques[i].torque()) && std::isfinite(found.torques[i].torque()); };
  const std::size_t end = is_known(3) ? 3 : 2;
  const bool is_close = probe.spins.size() == 8 && is_known(4) && is_known(5) && is_known(6) && is_known(7);
  const auto slope_of = [&](const Evaluation &at)
  {
    const auto change = [&](std::size_t from, std::size_t to)
    { return at.torques[to].torque() - at.torques[from].torque(); };
    return is_close ? ring::slope_of_differences(change(5, 6), change(4, 7), probe.spins[6] - probe.spins[2])
                    : change(1, end) / (probe.spins[end] - probe.spins[1]);
  };
  const double slope = std::isfinite(row.terminal->torque_slope) ? row.terminal->torque_slope : slope_of(own);
  const double moved = -(found.torques[2].torque() - own.torques[2].torque()) / slope;
  // A number of answer_fields() with a name in bands must be changed here; otherwise its band has only the
  // part "solver".
  ring::Answer answer = row;
  answer.at_rest->friction.torque += found.torques[0].friction.torque - own.torques[0].friction.torque;
  answer.terminal->omega += moved;
  answer.terminal->time_constant =
    analysis.study.motion.orbit.yaw_inertia / std::abs(slope + (slope_of(found) - slope_of(own)));
  std::vector<QuantityOfInterest> quantities =
    quantities_of_interest(analysis.study, found.at_rest, found.table_motion, answer,
                           { { probe.spins[1], found.torques[1].friction.torque },
                             { probe.spins[3], found.torques[3].friction.torque } });
  if (probe.first)
  {
    const double slope_there = std::isfinite(own.slope_of_first) ? own.slope_of_first : slope;
    const double first_moved = -(found.torque_of_first - own.torque_of_first) / slope_there;
    const double spin_noise = analysis.study.rounding_of_spins();
    quantities.push_back(spin_quantity("omega_first_harmonic", *probe.first + first_moved, spin_noise));
    quantities.push_back(
      spin_quantity("harmonic_effect", answer.terminal->omega - *probe.first - first_moved, spin_noise));
  }
  return quantities;
}

bool has_full_contact(const ring::Answer &all, const LoadReport &at_rest)
{
  return at_rest.contact_fraction >= 1 && at_rest.least > 0.02 * at_rest.a(0) &&
         all.at_terminal->load.minimum() > 0.02 * at_rest.a(0);
}

EvaluationPoints probe_of(const ElasticFoot &foot, double omega, const std::optional<double> &first)
{
  const auto &[study, discretisation, model] = foot.specification();
  EvaluationPoints probe;
  probe.spins = { 0, omega / 2, omega, 1.5 * omega };
  probe.first = first;
  probe.phases = phases_of(foot, omega);
  probe.with_width =
    study.table.is_hard() && study.glass.profile.crown_radius > 0 && study.contact.is_of_revolution();
  return probe;
}

/// Adds the four spins of torque_slope() if the spins at 0.5 and 1.5 times the terminal spin do not resolve
/// the slope. This happens near |omega| = v / R (kink of the torque) and with lift-off (contact edges move
/// across the azimuth lines). @p is_full: contact all round, without lift-off.
void add_slope_spins(bool is_full, double spin_scale, EvaluationPoints &probe)
{
  const double omega = probe.spins[2];
  if (is_full && omega != 0 && 1.5 * std::abs(omega) <= spin_scale)
    return;
  const double step = ring::slope_step(omega, spin_scale);
  probe.spins.insert(probe.spins.end(), { omega - 2 * step, omega - step, omega + step, omega + 2 * step });
}

/// Returns the loads of a changed foot, computed from few contact solves: at rest at every phase, and at the
/// terminal spin at every phase (at the first phase only, if contact solves are costly). The change of the
/// load is assumed to be linear in the spin.
LoadsAtPhases changed_loads(const std::shared_ptr<ElasticFoot> &foot, const LoadsAtPhases &own_loads,
                            const EvaluationPoints &probe)
{
  const auto changed = [&](const std::vector<BalancedLoad> &before, unsigned int n_harmonics, double omega)
  {
    std::vector<BalancedLoad> loads;
    // Change of the load per change of spin; std::nullopt if the changed foot has no balance at omega.
    std::optional<Eigen::VectorXd> per_spin;
    for (const BalancedLoad &own : before)
    {
      const BalancedLoad after = find_load_at_phase(foot, probe.phases[loads.size()], n_harmonics);
      const unsigned int n = std::max(own.n_harmonics(), after.n_harmonics());
      const auto change_at = [&](double spin) -> Eigen::VectorXd
      { return after.at(spin).coefficients(n) - own.at(spin).coefficients(n); };
      const Eigen::VectorXd at_rest = change_at(0);
      const auto find = [&]() -> Eigen::VectorXd
      {
        if (omega == 0)
          return 0 * at_rest;
        return (change_at(omega) - at_rest) / omega;
      };
      if (!per_spin || !foot->body().capabilities().is_collective)
        per_spin = ring::find_or_nullopt(find).value_or(Eigen::VectorXd());
      const auto load = [=, slope = *per_spin](double spin)
      {
        if (spin != 0 && slope.size() == 0)
          throw ring::NoBalance("the changed foot has no balance at the terminal spin");
        Eigen::VectorXd row = own.at(spin).coefficients(n) + at_rest;
        if (spin != 0)
          row += spin * slope;
        return ring::Sample::from_coefficients(row, own.at(0).rings().size()).truncated(own.n_harmonics());
      };
      loads.push_back(after.with(ring::Load(load, true)));
    }
    return loads;
  };
  return { changed(own_loads.all, all_harmonics, probe.spins[2]),
           changed(own_loads.first, 1, probe.first.value_or(0)) };
}

/// Returns the change of the quantity @p key from @p before to @p after. For terminal spin and torques, it is
/// the largest change of torque at 0.5, 1 and 1.5 times the terminal spin, because errors of harmonics may
/// cancel at one spin; NaN if a torque is missing. @p yaw_inertia [kg m^2]. Throws as quantity_of().
double max_change_over_spins(const std::string &key, const std::vector<QuantityOfInterest> &before,
                             const std::vector<QuantityOfInterest> &after, double yaw_inertia)
{
  const auto move_of = [&](const std::string &name)
  { return std::abs(quantity_of(after, name).value - quantity_of(before, name).value); };
  const double slope = yaw_inertia / quantity_of(before, "time_constant").value;
  const auto moves = { slope * move_of("omega_terminal"), move_of("tau_at_spin_1"),
                       move_of("tau_at_spin_2") };
  const bool all_known =
    std::all_of(moves.begin(), moves.end(), [](double move) { return std::isfinite(move); });
  const double torque = all_known ? std::max(moves) : std::nan("");
  if (key == "omega_terminal")
    return torque / slope;
  return key == "tau_at_spin_1" || key == "tau_at_spin_2" ? torque : move_of(key);
}

/// Adds change.factor times |@p after - @p before| of each quantity to the part change.part of its error
/// band. Removes the bands of quantities without a value in @p after.
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
    // The largest pressure and the width depend on single points, which each change moves: their changes add.
    const bool is_at_points = key == "peak_pressure" || key == "contact_width";
    const double known = change.is_alternative && !is_at_points ? banded.parts[change.part] : 0.;
    banded.add(change.part, std::max(change.factor * move - known, 0.));
  }
  bands.erase(std::remove_if(bands.begin(), bands.end(),
                             [](const BandedQuantity &banded) { return !std::isfinite(banded.band); }),
              bands.end());
}

/// Raises the part "lines" of each harmonic n > 1 to at least 1/32 of the largest of these parts. A part may
/// be too small by chance, because it depends on the distance of a contact edge from the next line. With four
/// times the lines, 1/32 of the error remains (order 5/2).
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
    banded->add("lines", std::max(0., rest_on_more_lines * largest - banded->parts.at("lines")));
}

/// Returns the error bands due to the solver's tolerances, for all @p quantities that have a value. Values in
/// @p reported replace the computed values.
ErrorBands bands_of_solver(const std::vector<QuantityOfInterest> &quantities,
                           const std::vector<QuantityOfInterest> &reported)
{
  ErrorBands bands;
  for (QuantityOfInterest quantity : quantities)
    if (std::isfinite(quantity.value))
    {
      for (const QuantityOfInterest &known : reported)
        if (known.key == quantity.key)
          quantity.value = known.value;
      bands.push_back({ quantity, quantity.rounding, quantity.value, { { "solver", quantity.rounding } } });
    }
  return bands;
}

ErrorBands bands_of(const Analysis &analysis, const ring::Answer &all, const std::optional<double> &first,
                    const std::vector<QuantityOfInterest> &reported)
{
  const std::shared_ptr<ElasticFoot> &foot = analysis.foot;
  const double spin_unit = analysis.study.spin_unit();
  EvaluationPoints probe = probe_of(*foot, all.terminal->omega, first);
  const LoadsAtPhases own_loads = loads_of(foot, probe);
  const bool is_full = has_full_contact(all, own_loads.all.front().report());
  add_slope_spins(is_full, spin_unit, probe);
  Evaluation own = evaluate(own_loads, *foot, probe);
  if (first)
  {
    const auto torque = [&](double omega)
    { return mean_torques(own_loads.first, analysis.study.motion.orbit, { omega }).front().torque(); };
    own.slope_of_first = ring::torque_slope(torque, *first, ring::slope_step(*first, spin_unit));
  }
  std::vector<BandChange> changes = band_changes(*foot, own.at_rest, is_full);
  const auto quantities = [&](const Evaluation &found)
  { return quantities_from(found, probe, own, all, analysis); };
  const std::vector<QuantityOfInterest> unchanged = quantities(own);
  ErrorBands bands = bands_of_solver(unchanged, reported);
  const auto with_rings = std::stable_partition(
    changes.begin(), changes.end(), [](const BandChange &change) { return change.shared != Shared::load; });
  for (auto change = with_rings; change != changes.end(); ++change)
  {
    const LoadsAtPhases loads = projected(own_loads, *foot, *change);
    add_part(*change, unchanged, quantities(evaluate(loads, *foot, probe)), bands);
  }
  changes.erase(with_rings, changes.end());

  const auto look_at = [&](const BandChange &change, const std::shared_ptr<ElasticFoot> &its_foot)
  {
    const bool is_costly = change.study.is_collective() || probe.phases.size() > 1;
    return evaluate(is_costly && change.shared != Shared::contact ? changed_loads(its_foot, own_loads, probe)
                                                                  : loads_of(its_foot, probe),
                    *its_foot, probe);
  };
  const auto done = [&, tell = counting_callback(analysis.executor.progress, "error bands", changes.size())](
                      std::size_t i, const Solved<Evaluation> &solved) mutable
  {
    solved.value(); // rethrows a failure; then no error bands are given
    tell(i, solved);
  };
  const std::vector<Solved<Evaluation>> found = solve(changes, foot, look_at, analysis.executor, done);
  // The quantities after the first change of each part are the reference of later changes (BandChange::from).
  std::map<std::string, std::vector<QuantityOfInterest>> by_part;
  for (std::size_t i = 0; i < changes.size(); ++i)
  {
    const std::string &from = changes[i].from;
    const auto after = quantities(found[i].value());
    add_part(changes[i], from.empty() ? unchanged : by_part.at(from), after, bands);
    by_part.emplace(changes[i].part, after);
  }
  widen_parts_of_lines(bands);
  for (BandedQuantity &banded : bands)
    if (banded.quantity.key == "omega_terminal" && all.terminal->uncertainty > 0)
      banded.add("interpolation", all.terminal->uncertainty);
  return bands;
}

} // namespace

ErrorBands estimate_bands(const Analysis &analysis, const ring::Answer &all,
                          const std::optional<double> &first, const std::vector<QuantityOfInterest> &reported)
{
  if (!analysis.foot || !all.terminal)
    return {};
  try
  {
    return bands_of(analysis, all, first, reported);
  }
  catch (const std::exception &failure)
  {
    if (!analysis.executor.keeps_all_failures && !is_variant_failure(failure))
      throw;
    analysis.executor.progress.note("No band", failure.what());
  }
  return {};
}

std::vector<QuantityOfInterest> reported_quantities(const LoadReport &at_rest, const StudyRows &rows)
{
  std::vector<QuantityOfInterest> reported = load_quantities(at_rest);
  const std::vector<ring::Torques> &torques = rows.by_harmonics.back().torques;
  if (torques.size() > 1 && std::isfinite(torques[1].friction.torque))
    reported.push_back({ "tau_at_spin_1", "", "N m", torques[1].friction.torque });
  return reported;
}

} // namespace stemware::pipeline
