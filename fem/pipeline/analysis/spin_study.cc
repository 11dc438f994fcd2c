#include "fem/pipeline/analysis/spin_study.h"

#include "fem/pipeline/analysis/spin.h"
#include "fem/pipeline/coupling/phase_loads.h"
#include "fem/pipeline/coupling/study_load.h"

#include <algorithm>
#include <cmath>

namespace stemware::pipeline
{

namespace
{

double half_range(const std::vector<double> &values)
{
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return (*most - *least) / 2;
}

std::vector<double> torques_at(double omega, const PhaseLoads &loads, const ring::Motion &motion)
{
  const ring::CoulombRing friction(motion.friction_coefficient);
  std::vector<double> torques;
  for (const ring::RingStack &load : loads.samples(omega))
    torques.push_back(friction.wrench(load, omega, motion.orbit_speed).torque);
  return torques;
}

PhaseStudy study_phases(const PhaseLoads &loads, const SpinRow &row, const ring::Motion &motion)
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
  study.interpolation_error = loads.error();
  for (unsigned int i = 0; i < loads.phases().size(); ++i)
    study.phases.push_back(loads.phases().phase(i));
  study.torque_at_rest = torques_at(0, loads, motion);
  study.torque_at_terminal = torques_at(row.terminal->omega, loads, motion);
  study.torque_ripple = half_range(study.torque_at_terminal);
  return study;
}

/// Bound and least load of the worst phase instead of those of the mean load.
void take_worst_phase(const PhaseLoads &loads, const ring::Motion &motion, double omega, SpinRow &row)
{
  const ring::CoulombRing friction(motion.friction_coefficient);
  for (const ring::RingStack &load : loads.samples(omega))
    row.bound =
      std::max(*row.bound, friction.truncation_bound(load, row.harmonics, omega, motion.orbit_speed));
  for (const ring::RingStack &load : loads.samples(0))
    row.at_rest->minimum = std::min(row.at_rest->minimum, load.truncated(row.harmonics).minimum());
}

std::vector<SpinRow> truncation_rows(const BalancedLoad &load, const ring::Motion &motion)
{
  SpinQuestion question = { motion };
  std::vector<SpinRow> rows;
  for (const unsigned int n : truncation_orders(load.n_harmonics()))
  {
    question.with_slope = n == load.n_harmonics();
    rows.push_back(spin_row(load.truncated(n), question));
  }
  const ring::RingStack whole = load.at(rows.back().terminal->omega);
  const SpinRow all = rows.back();
  for (SpinRow &row : rows)
  {
    relate_to_all(all, whole, question, row);
    if (load.phases())
      take_worst_phase(*load.phases(), motion, all.terminal->omega, row);
  }
  return rows;
}

TorqueCurve torque_curve(const BalancedLoad &load, const ring::Motion &motion)
{
  constexpr int n_half = 120;
  TorqueCurve curve;
  for (int i = -n_half; i <= n_half; ++i)
  {
    // Multiples of an exact step from the middle: the curve is sampled at rest, and symmetrically.
    const double slip_ratio = 1.5 * i / n_half;
    curve.slip_ratio.push_back(slip_ratio);
    curve.omega.push_back(slip_ratio * load.spin_scale(motion));
    curve.friction.push_back(wrench(load, motion, curve.omega.back()));
  }
  curve.harmonics = truncation_orders(load.n_harmonics());
  curve.harmonics.pop_back();
  for (const unsigned int n : curve.harmonics)
  {
    const BalancedLoad kept = load.truncated(n);
    std::vector<double> &torques = curve.truncations.emplace_back();
    for (const double omega : curve.omega)
      torques.push_back(wrench(kept, motion, omega).torque);
  }
  return curve;
}

/// Equal steps of the forward Euler method in each of @p n_intervals equal intervals of the spin-up.
unsigned int euler_steps(const MotionSection &motion, unsigned int n_intervals)
{
  const double n_steps = std::ceil(motion.end_time / n_intervals / motion.euler_step - 1e-9);
  return std::max(static_cast<unsigned int>(n_steps), 1u);
}

std::vector<double> spins_of(const std::vector<ring::YawSample> &samples)
{
  std::vector<double> spins;
  for (const ring::YawSample &sample : samples)
    spins.push_back(sample.omega);
  return spins;
}

/// @p rows of the same load say between which spins the curves lie.
SpinUpCurves spin_up_curves(const BalancedLoad &load, const Study &study, const std::vector<SpinRow> &rows)
{
  const ring::Motion &orbit = study.motion.orbit;
  SpinUpCurves curves;
  curves.time = output_times(study.motion.end_time);
  for (const ring::YawSample &sample : spin_up(load, orbit, curves.time))
  {
    curves.adaptive.push_back(sample.omega);
    curves.yaw_angle.push_back(sample.yaw_angle);
  }

  // Thousands of values of what is shown beside it need not be exact.
  const double all = rows.back().terminal->omega, first = rows.front().terminal->omega;
  const double margin = 0.02 * std::max(std::abs(all), std::abs(first));
  const BalancedLoad beside = load.interpolated(std::min({ 0., all - margin, first - margin }),
                                                std::max({ 0., all + margin, first + margin }));
  curves.first_harmonic = spins_of(spin_up(beside.truncated(1), orbit, curves.time));

  const auto n_intervals = static_cast<unsigned int>(curves.time.size()) - 1;
  const unsigned int stride = euler_steps(study.motion, n_intervals);
  const unsigned int n_steps = stride * n_intervals;
  const auto samples = ring::yaw_motion_euler(torque_function(beside, orbit), orbit.yaw_inertia, 0,
                                              study.motion.end_time / n_steps, n_steps);
  for (unsigned int i = 0; i <= n_intervals; ++i)
    curves.euler.push_back(samples[i * stride].omega);
  curves.paper = paper_spin_up(study, curves.time);
  return curves;
}

} // namespace

std::vector<double> paper_spin_up(const Study &study, const std::vector<double> &times)
{
  return spins_of(spin_up(first_harmonic_load(study, ring::Closure::paper), study.motion.orbit, times));
}

std::vector<SpinRow> closure_rows(const Study &study)
{
  std::vector<SpinRow> rows;
  for (const ring::Closure closure : { ring::Closure::paper, ring::Closure::hand, ring::Closure::full })
  {
    // A formal load may push for ever; the row says so.
    rows.push_back(attempt_spin_row(first_harmonic_load(study, closure), { study.motion.orbit }));
    rows.back().closure = closure;
    rows.back().load = "first harmonic";
  }
  return rows;
}

std::optional<double> relative_to(const std::optional<double> &reference,
                                  const std::optional<double> &difference, double unit)
{
  if (!reference || !difference || !(std::abs(*reference) >= 1e-9 * unit))
    return std::nullopt;
  return *difference / *reference;
}

double spin_unit(const Study &study)
{
  return study.motion.orbit.orbit_speed / study.glass.profile.contact_radius;
}

namespace
{

/// Stub: what the rows at hand say.
Budget stub_budget(const SpinStudy &spin, const BalancedLoad &load, const Study &study)
{
  Budget budget;
  const ring::Motion &motion = study.motion.orbit;
  const auto add = [&](const std::string &step, const std::string &name, const SpinRow &row)
  {
    BudgetRow added = { step, name, row.harmonics, row.omega_terminal() };
    if (&row == &spin.all())
      added.harmonics.reset();
    if (!budget.rows.empty() && added.omega_terminal && budget.rows.back().omega_terminal)
      added.difference = *added.omega_terminal - *budget.rows.back().omega_terminal;
    if (row.at_rest)
      added.torques = { row.at_rest->friction.torque, 0.5 * row.at_rest->friction.torque, 0. };
    added.standing = row.standing;
    added.reason = row.reason;
    budget.rows.push_back(added);
  };
  add("1", "paper", spin.closures[0]);
  add("2", study.load.is_static() ? "given moment" : "moment balance",
      study.load.is_static() ? spin.closures[1] : spin.closures[2]);
  add("3", "where the foot touches", spin.rows.front());
  for (std::size_t i = 1; i < spin.rows.size(); ++i)
    add(std::to_string(i + 3), "harmonics", spin.rows[i]);
  const double all = spin.all().omega_terminal().value(), first = spin.rows.front().omega_terminal().value();
  budget.harmonics.absolute = all - first;
  if (std::abs(first) > 1e-9 * load.spin_scale(motion))
    budget.harmonics.relative = all / first - 1;
  budget.shown_spins = { 0, all / 2, all };
  budget.without = { { "friction in the foot", all + 1e-3, 1e-3, "" },
                     { "elasticity of the foot", all - 3e-4, -3e-4, "" },
                     { "compliance of the interface", {}, {}, "not defined" },
                     { "tilt", all + 4e-3, 4e-3, "" } };
  const BalancedLoad one = load.truncated(1);
  for (int i = 0; i <= 32; ++i)
  {
    budget.omega.push_back(all * 1.2 * i / 32);
    budget.torque_all.push_back(wrench(load, motion, budget.omega.back()).torque);
    budget.torque_first.push_back(wrench(one, motion, budget.omega.back()).torque);
  }
  return budget;
}

} // namespace

SpinStudy study_spin(const BalancedLoad &load, const Study &study)
{
  const ring::Motion &motion = study.motion.orbit;
  SpinStudy result;
  result.rows = truncation_rows(load, motion);
  for (SpinRow &row : result.rows)
    row.closure = study.motion.closure;
  if (load.phases())
    result.phases = study_phases(*load.phases(), result.all(), motion);
  result.closures = closure_rows(study);
  result.torque = torque_curve(load, motion);
  result.spin_up = spin_up_curves(load, study, result.rows);
  result.budget = stub_budget(result, load, study);
  return result;
}

} // namespace stemware::pipeline
