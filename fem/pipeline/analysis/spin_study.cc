#include "fem/pipeline/analysis/spin_study.h"

#include "fem/pipeline/coupling/study_load.h"
#include "fem/pipeline/variants/model_variants.h"
#include "ring_model/spin/curves.h"
#include "ring_model/spin/hand_drive.h"
#include "ring_model/spin/phase_loads.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace stemware::pipeline
{

namespace
{

double half_range(const std::vector<double> &values)
{
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return (*most - *least) / 2;
}

PhaseStudy study_phases(const ring::PhaseSampledLoad &loads, const PhaseExtremes &at_rest,
                        const ring::Answer &row)
{
  PhaseStudy study;
  study.spin_ripple = row.ripple;
  study.spin_uncertainty = row.spin_uncertainty;
  study.zero_of_mean_torque = row.zero_of_mean_torque;
  study.least_load = at_rest.least_load;
  if (row.omega_terminal())
    for (const ring::RingStack &rings : loads.samples(*row.omega_terminal()))
      study.least_load = std::min(study.least_load, std::max(0., rings.minimum()));
  study.least_contact_fraction = at_rest.least_contact_fraction;
  study.n_glass_phases = loads.phases().glass.size();
  study.n_table_phases = loads.phases().table.size();
  study.n_spins = loads.n_spins();
  study.interpolation_error = loads.error().between;
  for (unsigned int i = 0; i < loads.phases().size(); ++i)
    study.phases.push_back(loads.phases().phase(i));
  study.torque_at_rest = row.phase_torques.at_rest;
  study.torque_at_terminal = row.phase_torques.at_last_spin;
  study.torque_ripple = half_range(study.torque_at_terminal);
  return study;
}

/// The study on one ring of its foot; nothing where it has no other.
std::optional<Variant> variant_on_one_ring(const Study &study)
{
  if (!study.load.is_from_contact() || study.contact.rings == 1)
    return std::nullopt;
  Variant one_ring = { "one_ring", "one ring", study };
  one_ring.study.contact.rings = 1;
  one_ring.on_same_foot = one_ring.on_other_rings = true; // the contact of rest does not depend on the rings
  return one_ring;
}

ring::Answer beside_all(ring::Answer one_ring, const ring::Answer &all)
{
  one_ring.harmonics = all.harmonics;
  if (one_ring.terminal && all.relative_change)
    one_ring.relative_change = one_ring.terminal->omega / all.terminal->omega - 1;
  return one_ring;
}

std::vector<double> spins_of(const std::vector<ring::YawSample> &samples)
{
  std::vector<double> spins;
  for (const ring::YawSample &sample : samples)
    spins.push_back(sample.omega);
  return spins;
}

SpinUpCurves spin_up_curves(const StudyCurves &curves)
{
  SpinUpCurves spin_up;
  for (const ring::YawSample &sample : curves.all.spin_up)
  {
    spin_up.time.push_back(sample.time);
    spin_up.adaptive.push_back(sample.omega);
    spin_up.yaw_angle.push_back(sample.yaw_angle);
  }
  spin_up.euler = spins_of(curves.all.euler);
  spin_up.first_harmonic = spins_of(curves.first.spin_up);
  spin_up.paper = spins_of(curves.paper.spin_up);
  spin_up.instants = curves.all.instants;
  return spin_up;
}

/// The torques of @p all at @p spins, with those of @p first, if it has any.
TorqueCurve torque_curve(const std::vector<double> &spins, double spin_scale, const ring::Answer &all,
                         const ring::Answer &first)
{
  TorqueCurve curve;
  curve.omega = spins;
  for (std::size_t i = 0; i < spins.size(); ++i)
  {
    const ring::Torques &torques = all.torques[i];
    curve.slip_ratio.push_back(spins[i] / spin_scale);
    curve.friction.push_back(torques.friction);
    curve.lean_torque.push_back(torques.lean_torque);
    curve.grip_torque.push_back(torques.grip_torque);
    curve.sum.push_back(torques.torque());
  }
  if (!first.torques.empty())
  {
    curve.harmonics = { first.harmonics };
    std::vector<double> torques = friction_torques(first);
    torques.resize(spins.size());
    curve.truncations = { std::move(torques) };
  }
  return curve;
}

} // namespace

std::vector<double> shown_spins(const Study &study, const std::vector<LoadedRow> &rows)
{
  constexpr int n_intervals = 120;
  const ring::Answer &all = rows.back().row;
  double last = 0;
  if (all.fall)
    last = all.fall->omega;
  else
  {
    double fastest = *all.omega_terminal();
    for (const LoadedRow &row : rows)
      if (std::abs(row.row.omega_terminal().value_or(0)) > std::abs(fastest))
        fastest = *row.row.omega_terminal();
    last = 1.5 * shown_spin(study, all, fastest);
  }
  if (last == 0) // it falls over as soon as it turns
    last = 1e-3 * spin_unit(study);
  int first = -n_intervals / 8;
  if (const ring::PhaseSampledLoad *phases = rows.back().load->phases())
  {
    // Spins without samples yet take as many contacts as the answer: the curve ends with the samples round
    // the terminal spin, if they reach beyond it.
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
    spins.push_back(last * i / n_intervals + 0.); // no -0
  std::sort(spins.begin(), spins.end());
  return spins;
}

StudyCurves find_curves(const Study &study, const RowsOfCurves &rows, const std::vector<double> &spins,
                        const Executor &executor, double euler_step, bool all_spins,
                        const ring::TimeObserver &observer)
{
  const bool together = is_collective(study);
  ring::Question question = spin_question(study), of_paper = spin_question(rows.paper->variant.study);
  question.spins = spins;
  question.times = of_paper.times = ring::output_times(study.motion.end_time);
  of_paper.spins = spins;
  of_paper.known = &rows.paper->row;
  StudyCurves curves;
  // The curve of the first harmonic is told by how it differs from that of all.
  const auto find = [&](std::size_t i)
  {
    const LoadedRow *row = i == 0 ? rows.all : rows.first;
    ring::Question asked = question;
    asked.known = &row->row;
    if (i == 0)
    {
      asked.euler_step = euler_step;
      asked.all_spins = all_spins;
      asked.with_instants = true;
      asked.observer = observer;
      curves.all = ring::answer(*rows.load, asked);
    }
    else if (row->load)
      curves.first = ring::answer(
        *ring::interpolated_for_curves(row->load, row->row, spins.front(), spins.back(), rows.load.get()),
        asked);
    else
      curves.first = row->row;
  };
  executor.for_each(rows.first ? 2 : 1, find, together);
  if (rows.paper->load)
    curves.paper = ring::answer(*rows.paper->load, of_paper);
  const double spin_scale = rows.load->spin_scale(study.motion.orbit);
  curves.all.value(); // a spin-up that is lost is no answer
  curves.torque = torque_curve(spins, spin_scale, curves.all, curves.first);
  curves.spin_up = spin_up_curves(curves);
  if (!rows.first)
    curves.spin_up.first_harmonic = curves.spin_up.adaptive;
  return curves;
}

std::optional<DrivenSpinUp> driven_spin_up(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                                           const std::vector<double> &times,
                                           const ring::TimeObserver &observer)
{
  if (!study.motion.orbit_speeds)
    return std::nullopt;
  const ring::OrbitSpeedTable &speeds = *study.motion.orbit_speeds;
  DrivenSpinUp driven;
  if (speeds.starts_from_rest())
    driven.breakaway = find_breakaway(study, foot, speeds);
  // Each step takes a dozen contacts; speeds that are measured are not known to a millionth.
  const double accuracy = study.load.is_from_contact() ? 1e-6 : 1e-10;
  const double radius = study.glass.profile.contact_radius, grip = study.motion.grip_torque;
  const ring::PhasedTorqueFunction torque = ring::observed(driven_torque(study, foot, speeds), observer);
  const std::vector<ring::YawSample> samples =
    ring::driven_motion(torque, speeds, study.motion.orbit, grip, radius, times, accuracy);
  const std::vector<double> changes =
    ring::interpolation_changes(study.motion.closure, study.motion.orbit, grip, radius, speeds, times);
  driven.time = times;
  for (const double time : times)
  {
    driven.speed.push_back(speeds.speed(time));
    driven.acceleration.push_back(speeds.acceleration(time));
  }
  driven.omega = spins_of(samples);
  driven.integration_error = accuracy * study.motion.orbit.orbit_speed / radius;
  driven.interpolation_change_at_end = changes.back();
  driven.interpolation_change = *std::max_element(changes.begin(), changes.end());
  return driven;
}

SpinStudy study_spin(const Study &study, const std::shared_ptr<ElasticFoot> &foot, const BalancedLoad &load,
                     const Executor &executor, Progress &progress, Depth depth)
{
  std::vector<Variant> others = budget_variants(own_variant(study, foot.get()), load.phases() != nullptr);
  if (depth != Depth::full)
    others.erase(others.begin() + 1, others.end()); // the paper's model alone
  else if (const std::optional<Variant> one_ring = variant_on_one_ring(study))
    others.push_back(*one_ring);
  // The curve may meet a fall that the search has stepped over, and that of the next one another.
  constexpr unsigned int max_falls = 8;
  StudyRows solved;
  std::vector<double> shown;
  RowsOfCurves rows;
  for (unsigned int i = 0; i <= max_falls; ++i)
  {
    solved = rows_by_harmonics(study, foot, load, spin_question(study), executor, progress, depth, others);
    shown = shown_spins(study, solved.by_harmonics);
    const LoadedRow &all = solved.by_harmonics.back();
    rows = { &all, solved.by_harmonics.size() > 1 ? &solved.by_harmonics.front() : nullptr,
             &solved.others.front(),
             ring::interpolated_for_curves(all.load, all.row, shown.front(), shown.back()) };
    if (!load.nearest_unbalanced_spin(all.row.last_spin().value_or(0)))
      break;
  }
  SpinStudy result;
  const bool is_slow = study.load.is_in_balance() && is_collective(study); // each torque takes minutes
  if (depth == Depth::full)
    result.budget = find_budget(study, solved);
  const ring::TimeObserver observer = motion_observer(progress);
  const StudyCurves curves =
    find_curves(study, rows, shown, executor, study.motion.euler_step, !is_slow, observer);
  for (const LoadedRow &row : solved.by_harmonics)
    result.rows.push_back(row.row);
  if (load.phases())
    result.phases = study_phases(*load.phases(), load.report().over_phases.value(), curves.all);
  for (const LoadedRow &other : solved.others)
    if (other.variant.key == "one_ring")
      result.one_ring = beside_all(other.row, result.all());
  result.torque_effects = ring::torque_effects(load, study.motion.orbit, result.all(),
                                               truncation_orders(load.n_harmonics()), rows.load.get());
  result.curve_error = rows.load->interpolation_error();
  result.terminal_spins = curves.all.all_spins;
  result.torque = curves.torque;
  result.spin_up = curves.spin_up;
  result.spin_up.driven = driven_spin_up(study, foot, result.spin_up.time, observer);
  if (depth != Depth::full)
    result.budget.harmonics =
      harmonic_effect(result.rows.front().omega_terminal(), result.all().omega_terminal(), spin_scale(study));
  return result;
}

} // namespace stemware::pipeline
