#include "fem/pipeline/analysis/spin_study.h"

#include "fem/pipeline/coupling/study_load.h"
#include "fem/pipeline/variants/model_variants.h"
#include "ring_model/friction_law.h"
#include "ring_model/hand_drive.h"
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

std::vector<double> torques_at(double omega, const ring::PhaseSampledLoad &loads, const ring::Motion &motion)
{
  std::vector<double> torques;
  for (const ring::RingStack &load : loads.samples(omega))
    torques.push_back(ring::wrench(motion, load, omega).torque);
  return torques;
}

PhaseStudy study_phases(const ring::PhaseSampledLoad &loads, const ring::Answer &row,
                        const ring::Motion &motion)
{
  PhaseStudy study;
  study.spin_ripple = row.ripple;
  study.spin_uncertainty = row.spin_uncertainty;
  study.zero_of_mean_torque = row.zero_of_mean_torque;
  study.least_load = loads.at_rest_extremes().least_load;
  study.least_contact_fraction = loads.at_rest_extremes().least_contact_fraction;
  study.n_glass_phases = loads.phases().glass.size();
  study.n_table_phases = loads.phases().table.size();
  study.n_spins = loads.n_spins();
  study.interpolation_error = loads.error().between;
  for (unsigned int i = 0; i < loads.phases().size(); ++i)
    study.phases.push_back(loads.phases().phase(i));
  study.torque_at_rest = torques_at(0, loads, motion);
  study.torque_at_terminal = torques_at(row.last_spin().value(), loads, motion);
  study.torque_ripple = half_range(study.torque_at_terminal);
  return study;
}

/// SpinUpCurves::instants of a spin-up under @p load.
std::vector<Instant> instants_of(const Study &study, const ring::LoadAtSpin &load,
                                 const std::vector<ring::YawSample> &spin_up)
{
  constexpr std::size_t n_intervals = 24;
  constexpr double near = 0.995;
  std::size_t n = 0; // samples before the glass tips
  while (n < spin_up.size() && std::isfinite(spin_up[n].omega))
    ++n;
  if (n == 0)
    return {};
  std::size_t last = 0;
  while (last + 1 < n && std::abs(spin_up[last].omega) < near * std::abs(spin_up[n - 1].omega))
    ++last;
  ring::Question question = spin_question(study);
  question.with_minima = false;
  std::vector<Instant> instants;
  const std::size_t n_steps = std::min(n_intervals, last);
  for (std::size_t i = 0; i <= n_steps; ++i)
  {
    const ring::YawSample &sample = spin_up[n_steps == 0 ? 0 : i * last / n_steps];
    instants.push_back({ sample.time, sample.omega, sample.yaw_angle,
                         ring::ring_state(load.at(sample.omega), question, sample.omega) });
  }
  return instants;
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

} // namespace

SpinUpCurves spin_up_curves(const Study &study, const ring::LoadAtSpin &load, const ring::Answer &all,
                            const ring::Answer &first, const ring::Answer &paper)
{
  SpinUpCurves curves;
  for (const ring::YawSample &sample : all.spin_up)
  {
    curves.time.push_back(sample.time);
    curves.adaptive.push_back(sample.omega);
    curves.yaw_angle.push_back(sample.yaw_angle);
  }
  curves.euler = spins_of(all.euler);
  curves.first_harmonic = spins_of(first.spin_up);
  curves.paper = spins_of(paper.spin_up);
  curves.instants = instants_of(study, load, all.spin_up);
  return curves;
}

std::optional<double> TorqueCurve::spin_unit() const
{
  for (std::size_t i = 0; i < omega.size(); ++i)
    if (std::abs(slip_ratio.at(i)) > 1e-6)
      return omega[i] / slip_ratio[i];
  return std::nullopt;
}

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

ring::Answer curves_of(const Study &study, const LoadedRow &row, const std::vector<double> &spins,
                       double euler_step, bool all_spins)
{
  if (!row.load)
    return row.row;
  ring::Question question = spin_question(study);
  question.known = &row.row;
  question.spins = spins;
  question.times = ring::output_times(study.motion.end_time);
  question.euler_step = euler_step;
  question.all_spins = all_spins;
  return ring::answer(*row.load, question);
}

ring::Answer paper_curves(const Study &study, const std::vector<double> &spins)
{
  const Study paper = paper_study(study);
  return curves_of(paper, { {}, {}, first_harmonic_load(paper, paper.motion.closure) }, spins);
}

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
    curve.truncations = { friction_torques(first) };
  }
  return curve;
}

/// omega(t) [rad/s] from rest at @p times while the hand leads the glass with @p speeds.
std::vector<double> driven_spins(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                                 const ring::OrbitSpeedTable &speeds, const std::vector<double> &times,
                                 double accuracy)
{
  const ring::PhasedTorqueFunction table_torque = driven_torque(study, foot, speeds);
  const auto torque = [&](double time, double yaw_angle, double omega)
  {
    const double of_table = table_torque(time, yaw_angle, omega);
    return of_table + ring::grip_torque(of_table, omega, study.motion.grip_torque);
  };
  return spins_of(
    ring::driven_motion(torque, speeds, study.motion.orbit.yaw_inertia, times, accuracy, spin_unit(study)));
}

std::optional<DrivenSpinUp> driven_spin_up(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                                           const std::vector<double> &times)
{
  if (!study.motion.orbit_speeds)
    return std::nullopt;
  // Each step takes a dozen contacts; speeds that are measured are not known to a millionth.
  const double accuracy = study.load.is_from_contact() ? 1e-6 : 1e-10;
  constexpr double accuracy_of_change = 1e-7; // acceleration jumps where lines meet
  const ring::OrbitSpeedTable &speeds = *study.motion.orbit_speeds;
  DrivenSpinUp driven;
  if (speeds.starts_from_rest())
    driven.breakaway = find_breakaway(study, foot, speeds);
  driven.time = times;
  for (const double time : times)
  {
    driven.speed.push_back(speeds.speed(time));
    driven.acceleration.push_back(speeds.acceleration(time));
  }
  driven.omega = driven_spins(study, foot, speeds, times, accuracy);
  const Study rigid = first_harmonic_study(study);
  const std::vector<double> cubic = driven_spins(rigid, nullptr, speeds, times, accuracy_of_change),
                            lines = driven_spins(rigid, nullptr, speeds.joined_by_lines(), times,
                                                 accuracy_of_change);
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    driven.interpolation_change_at_end = std::abs(lines[i] - cubic[i]);
    driven.interpolation_change = std::max(driven.interpolation_change, driven.interpolation_change_at_end);
  }
  return driven;
}

SpinStudy study_spin(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                     const ring::LoadAtSpin &load, const Executor &executor, Progress &progress, Depth depth)
{
  std::vector<Variant> others;
  if (depth == Depth::full)
    others = budget_variants(own_variant(study, foot.get()), load.phases() != nullptr);
  if (const std::optional<Variant> one_ring = variant_on_one_ring(study); one_ring && depth == Depth::full)
    others.push_back(*one_ring);
  // The curve may meet a fall that the search has stepped over, and that of the next one another.
  constexpr unsigned int max_falls = 8;
  StudyRows solved;
  std::vector<double> shown;
  LoadedRow all;
  for (unsigned int i = 0; i <= max_falls; ++i)
  {
    solved = rows_by_harmonics(study, foot, load, spin_question(study), executor, progress, depth, others);
    shown = shown_spins(study, solved.by_harmonics);
    all = with_interpolated_load(solved.by_harmonics.back(), shown.front(), shown.back());
    if (!load.nearest_unbalanced_spin(all.row.last_spin().value_or(0)))
      break;
  }
  solved.by_harmonics.back() = all;

  SpinStudy result;
  for (const LoadedRow &row : solved.by_harmonics)
    result.rows.push_back(row.row);
  if (load.phases())
    result.phases = study_phases(*load.phases(), all.row, study.motion.orbit);
  for (const LoadedRow &other : solved.others)
    if (other.variant.key == "one_ring")
      result.one_ring = beside_all(other.row, all.row);
  result.curve_error = all.load->interpolation_error();
  ring::Answer of_all, of_first;
  const bool is_slow = study.load.is_in_balance() && is_collective(study); // each torque takes minutes
  // The curve of the first harmonic is told by how it differs from that of all.
  const auto find_curves = [&](std::size_t i)
  {
    LoadedRow &first = solved.by_harmonics.front();
    if (i == 0)
      of_all = curves_of(study, all, shown, study.motion.euler_step, !is_slow);
    else if (solved.by_harmonics.size() > 1)
      of_first = curves_of(
        study, first = with_interpolated_load(first, shown.front(), shown.back(), all.load.get()), shown);
  };
  executor.for_each(2, find_curves, is_collective(study));
  of_all.value(); // a spin-up that is lost is no answer
  result.terminal_spins = of_all.all_spins;
  result.torque = torque_curve(shown, all.load->spin_scale(study.motion.orbit), of_all, of_first);
  result.spin_up = spin_up_curves(
    study, *all.load, of_all, solved.by_harmonics.size() > 1 ? of_first : of_all, paper_curves(study, {}));
  result.spin_up.driven = driven_spin_up(study, foot, result.spin_up.time);
  if (depth == Depth::full)
    result.budget = find_budget(study, std::move(solved), executor);
  else
    result.budget.harmonics =
      harmonic_effect(result.rows.front().omega_terminal(), result.all().omega_terminal(), spin_scale(study));
  return result;
}

} // namespace stemware::pipeline
