#include "fem/pipeline/analysis/spin_study.h"

#include "fem/pipeline/analysis/variant.h"
#include "fem/pipeline/coupling/study_load.h"
#include "ring_model/failures.h"
#include "ring_model/spin/phase_loads.h"

#include <algorithm>
#include <cmath>

namespace stemware::pipeline
{

namespace
{

/// Returns the pointwise minimum [N/rad] of the contact at the spin @p omega [rad/s], solved at the phase at
/// which the interpolated load is least.
double least_load_over_phases(const std::shared_ptr<ElasticFoot> &foot, const ring::PhaseSampledLoad &loads,
                              double omega)
{
  constexpr unsigned int n_phases = 64; // the sampled phases, often 8, may miss the least load
  ring::PhaseGrids grids = loads.phases();
  while (grids.size() > 1 && grids.size() < n_phases)
    for (const ring::PhaseGrids::Angle angle : { &ring::PhaseGrids::glass, &ring::PhaseGrids::table })
      if ((grids.*angle).size() > 1)
        grids.*angle = (grids.*angle).refined();
  std::vector<double> minima;
  for (unsigned int i = 0; i < grids.size(); ++i)
    minima.push_back(loads.at(omega, grids.phase(i)).minimum());
  const auto least = std::min_element(minima.begin(), minima.end());
  const auto phase = grids.phase(static_cast<unsigned int>(least - minima.begin()));
  return find_load_at_phase(foot, phase).contact(omega).value().load.least;
}

PhaseStudy study_phases(const std::shared_ptr<ElasticFoot> &foot, const BalancedLoad &load,
                        const ring::Answer &row)
{
  const ring::PhaseSampledLoad &loads = *load.phases();
  const ring::Motion &motion = foot->specification().study.motion.orbit;
  PhaseStudy study;
  if (row.terminal)
  {
    study.spin_ripple = row.terminal->ripple;
    study.spin_uncertainty = row.terminal->uncertainty;
    study.zero_of_mean_torque = row.terminal->evaluated_at;
  }
  const double at_rest = least_load_over_phases(foot, loads, 0);
  study.least_load = at_rest;
  if (row.omega_terminal())
    study.least_load = std::min(at_rest, least_load_over_phases(foot, loads, *row.omega_terminal()));
  study.least_load_is_at_rest = study.least_load >= at_rest;
  study.least_contact_fraction = load.report().least_contact_fraction.value();
  study.n_glass_phases = loads.phases().glass.size();
  study.n_table_phases = loads.phases().table.size();
  study.n_spins = loads.n_spins();
  study.interpolation_error = loads.error().between;
  for (unsigned int i = 0; i < loads.phases().size(); ++i)
    study.phases.push_back(loads.phases().phase(i));
  study.torque_at_rest = ring::torques_by_phase(loads, motion, 0);
  study.torque_at_terminal = ring::torques_by_phase(loads, motion, row.last_spin().value());
  const auto [least, most] =
    std::minmax_element(study.torque_at_terminal.begin(), study.torque_at_terminal.end());
  study.torque_ripple = (*most - *least) / 2;
  return study;
}

std::optional<Variant> variant_on_one_ring(const Variant &own)
{
  if (!own.study.load.is_from_contact() || own.study.contact.rings == 1)
    return std::nullopt;
  Variant one_ring = own;
  one_ring.kind = VariantKind::one_ring;
  one_ring.name = "one ring";
  one_ring.study.contact.rings = 1;
  one_ring.shared = Shared::contact; // the contact solution at rest does not depend on the rings
  return one_ring;
}

std::vector<double> spins_of(const std::vector<ring::YawSample> &samples)
{
  std::vector<double> spins;
  for (const ring::YawSample &sample : samples)
    spins.push_back(sample.omega);
  return spins;
}

/// Returns the spins of a spin-up; an empty list if the balance is lost before the last of @p times.
std::vector<double> spin_up_of(const ring::Load &load, const ring::Question &question,
                               const std::vector<double> &times, const std::optional<ring::RingState> &fall)
{
  return spins_of(ring::find_or_nullopt([&] { return ring::spin_up(load, question, times, fall); })
                    .value_or(std::vector<ring::YawSample>()));
}

/// Returns the end of the plotted torque curve of @p row [rad/s]: @p fastest, or, if below 0.01 @p spin_unit,
/// a tenth of this unit in the direction of the torque.
double shown_spin(double spin_unit, const ring::Answer &row, double fastest)
{
  if (std::abs(fastest) >= 0.01 * spin_unit)
    return fastest;
  const double torque = row.at_rest ? row.at_rest->friction.torque : 0;
  return std::copysign(0.1 * spin_unit, fastest != 0 ? fastest : torque);
}

} // namespace

std::pair<std::vector<double>, ring::Load> curve_load(const std::vector<LoadedRow> &rows)
{
  constexpr int n_intervals = 120;
  const ring::Answer &all = rows.back().row;
  const double spin_unit = rows.back().variant.study.spin_unit();
  double last = 0;
  if (all.fall)
    last = all.fall->omega;
  else
  {
    double fastest = *all.omega_terminal();
    for (const LoadedRow &row : rows)
      if (std::abs(row.row.omega_terminal().value_or(0)) > std::abs(fastest))
        fastest = *row.row.omega_terminal();
    last = 1.5 * shown_spin(spin_unit, all, fastest);
  }
  if (last == 0) // the glass tips as soon as it turns
    last = 1e-3 * spin_unit;
  int first = -n_intervals / 8;
  if (const ring::PhaseSampledLoad *phases = rows.back().load->phases())
  {
    // Beyond the spins at which the load is sampled, the curve would need as many contact solves as the
    // search for the terminal spin. The curve ends at the last sampled spin if that spin exceeds 1.1 times
    // the terminal spin.
    constexpr double beyond = 1.1;
    const auto [lower, upper] = phases->polynomial_range(all.last_spin().value_or(0));
    const double terminal = all.last_spin().value_or(0), end = std::clamp(last, lower, upper);
    if (std::abs(end) > beyond * std::abs(terminal))
      last = end;
    if (std::isfinite(lower))
      first = 0;
  }
  std::vector<double> spins;
  for (int i = first; i <= n_intervals; ++i)
    spins.push_back(last * i / n_intervals + 0.); // + 0. avoids -0
  std::sort(spins.begin(), spins.end());
  return { spins, ring::interpolated_for_curves(*rows.back().load, all, spins.front(), spins.back()) };
}

StudyCurves find_curves(const std::vector<LoadedRow> &rows, const LoadedRow &paper,
                        const std::pair<std::vector<double>, ring::Load> &of_all,
                        const std::vector<double> &times, const Executor &executor, double euler_step,
                        const ring::TimeObserver &observer)
{
  const Variant &own = rows.back().variant;
  const std::vector<double> &spins = of_all.first;
  const ring::Load &load_of_all = of_all.second;
  const ring::Question question = spin_question(own.study);
  StudyCurves curves;
  SpinUpCurves &up = curves.spin_up;
  TorqueCurve &torque = curves.torque;
  torque.omega = spins;
  torque.spin_scale = load_of_all.spin_scale(own.study.motion.orbit);
  const auto find_all = [&]
  {
    const std::optional<ring::RingState> &fall = rows.back().row.fall;
    ring::Question observed = question;
    observed.observer = observer;
    torque.all = ring::torque_curve(load_of_all, question, spins);
    const std::vector<ring::YawSample> adaptive = ring::spin_up(load_of_all, observed, times, fall);
    up.time = times;
    up.adaptive = spins_of(adaptive);
    for (const ring::YawSample &sample : adaptive)
      up.yaw_angle.push_back(sample.yaw_angle);
    if (euler_step > 0)
      up.euler = spins_of(ring::euler_spin_up(load_of_all, observed, times, euler_step, fall));
    up.instants = ring::instants_of(adaptive, load_of_all, question);
  };
  // Computes the curves of the first harmonic. If possible, its load is interpolated as a difference from the
  // load of all harmonics.
  const auto find_first = [&]
  {
    const auto &[variant, row, load, torques] = rows.front();
    if (!load)
      return;
    const ring::Load curve =
      ring::interpolated_for_curves(*load, row, spins.front(), spins.back(), &load_of_all);
    torque.n_first = row.harmonics;
    torque.first = ring::torque_curve(curve, question, spins);
    up.first_harmonic = spin_up_of(curve, question, times, row.fall);
  };
  const bool has_first = rows.size() > 1;
  executor.for_each(
    has_first ? 2 : 1, [&](std::size_t i) { i == 0 ? find_all() : find_first(); }, own.study.is_collective());
  if (!has_first)
    up.first_harmonic = up.adaptive;
  if (paper.load)
  {
    const ring::Question of_paper = spin_question(paper.variant.study);
    curves.paper = ring::torque_curve(*paper.load, of_paper, spins);
    up.paper = spin_up_of(*paper.load, of_paper, times, paper.row.fall);
  }
  return curves;
}

std::optional<double> driven_band(const SpinStudy &spin, const std::optional<double> &band)
{
  const std::optional<double> omega = spin.answer().omega_terminal();
  const auto &driven = spin.spin_up.driven;
  if (!driven || !band || omega.value_or(0) == 0)
    return std::nullopt;
  // The relative error due to the load is assumed to be the same as at the terminal spin.
  return driven->integration_error + std::abs(driven->omega.back() / *omega) * *band;
}

SpinStudy study_spin(const Analysis &analysis, const BalancedLoad &load, Depth depth)
{
  const auto &[study, foot, executor] = analysis;
  const Variant own = analysis.own();
  std::vector<Variant> others = budget_variants(own, load.phases() != nullptr);
  if (depth != Depth::full)
    others.erase(others.begin() + 1, others.end()); // keeps the paper's model only
  else if (const std::optional<Variant> one_ring = variant_on_one_ring(own))
    others.push_back(*one_ring);
  // The spins of the curves may include a spin at which the glass tips and which the search for the terminal
  // spin missed. The rows are then solved again.
  constexpr unsigned int max_falls = 8;
  StudyRows solved;
  std::pair<std::vector<double>, ring::Load> curve = { {}, load };
  for (unsigned int i = 0; i <= max_falls; ++i)
  {
    solved = rows_by_harmonics(analysis, load, depth, others);
    curve = curve_load(solved.by_harmonics);
    if (!load.nearest_unbalanced_spin(solved.by_harmonics.back().row.last_spin().value_or(0)))
      break;
  }
  const ring::TimeObserver observer = motion_observer(executor.progress);
  StudyCurves curves =
    find_curves(solved.by_harmonics, solved.others.front(), curve, ring::output_times(study.motion.end_time),
                executor, study.motion.euler_step, observer);
  // A load refers to the executor's progress, and its contacts take memory.
  for (auto *rows : { &solved.by_harmonics, &solved.others })
    for (LoadedRow &row : *rows)
      row.load.reset();
  SpinStudy result = { std::move(curves), std::move(solved) };
  // With a solid foot, each torque evaluation takes minutes, so no further terminal spins are searched for.
  const bool is_slow = study.load.is_in_balance() && study.is_collective();
  if (!is_slow)
    result.terminal_spins = ring::terminal_spins(load, spin_question(study), result.answer());
  if (load.phases())
    result.phases = study_phases(foot, load, result.answer());
  for (const LoadedRow &other : result.rows.others)
    if (other.variant.kind == VariantKind::one_ring)
    {
      ring::Answer &one_ring = result.one_ring.emplace(other.row);
      one_ring.harmonics = result.answer().harmonics;
      if (one_ring.terminal && result.answer().relative_change)
        one_ring.relative_change = one_ring.terminal->omega / result.answer().terminal->omega - 1;
    }
  result.torque_effects = ring::torque_effects(load, study.motion.orbit, result.answer(),
                                               truncation_orders(load.n_harmonics()), &curve.second);
  result.curve_error = curve.second.interpolation_error();
  result.spin_up.driven =
    driven_spin_up(study.motion, study.glass.profile.contact_radius, foot, result.spin_up.time, observer);
  return result;
}

} // namespace stemware::pipeline
