#include "fem/pipeline/report/run_tables.h"

#include "fem/pipeline/report/quantities.h"
#include "fem/pipeline/report/render/table_renderers.h"
#include "fem/pipeline/support/numbers.h"

#include <boost/math/constants/constants.hpp>

#include <cmath>

namespace stemware::pipeline
{

namespace
{

/// lambda_j(theta) of one ring [N/rad].
double value_of(const ring::RingStack::Ring &ring, double angle)
{
  double value = ring.a[0];
  for (std::size_t n = 1; n < ring.a.size(); ++n)
    value += ring.a[n] * std::cos(static_cast<double>(n) * angle) +
             ring.b[n] * std::sin(static_cast<double>(n) * angle);
  return value;
}

} // namespace

Table contact_table(const FootReport &foot)
{
  const fem::ContactSolution &solution = foot.at_rest.solution;
  nlohmann::ordered_json mesh_summary = nlohmann::ordered_json::object();
  if (foot.foot.n_cells)
    mesh_summary["cells"] = *foot.foot.n_cells;
  if (const auto &mesh = foot.foot.mesh_report)
    mesh_summary.update({ { "round_rim", mesh->round_rim },
                          { "rim_radius", mesh->rim_radius },
                          { "land_area_deficit", mesh->land_area_deficit } });
  return {
    "",
    { single(quantity::body, foot.foot.body), single(quantity::friction_coupling, foot.friction_coupling),
      single(quantity::outcome, fem::to_string(solution.outcome)), single(quantity::mesh, mesh_summary),
      single(quantity::unknowns, foot.foot.n_unknowns),
      single(quantity::contact_nodes, foot.foot.n_contact_nodes),
      single(quantity::loaded_nodes, solution.n_loaded_nodes),
      single(quantity::nodes_across, solution.n_nodes_across),
      single(quantity::iterations, solution.n_iterations),
      single(quantity::linear_iterations, solution.n_linear_iterations),
      single(quantity::force_residual, solution.force_residual),
      single(quantity::moment_residual, solution.moment_residual),
      single(quantity::equilibrium_residual, solution.equilibrium_residual),
      single(quantity::table_heave, solution.motion(0)), single(quantity::table_tilt_1, solution.motion(1)),
      single(quantity::table_tilt_2, solution.motion(2)) }
  };
}

Table friction_table(const Study &study, const SpinRow &all)
{
  const ring::RingStack &load = all.at_rest.value().load;
  const double force = study.motion.orbit.friction_at_rest() * load.normal_force();
  const double torque = force * load.radius();
  std::vector<std::string> names = { "at rest" };
  std::vector<RingState> states = { *all.at_rest };
  if (all.at_terminal || all.fall)
  {
    names.push_back(all.fall ? "where it falls over" : "at the terminal spin");
    states.push_back(all.fall ? all.fall->state : *all.at_terminal);
  }
  const auto of_friction = [](double ring::Wrench::*part)
  { return [part](const RingState &state) { return state.friction.*part; }; };
  return { "The torques on the glass, and the friction force of the table",
           { column(Quantity("name", "", ""), names),
             column(quantity::tau_z, states, of_friction(&ring::Wrench::torque), 1e-12 * torque),
             column(quantity::lean_torque, states, &RingState::lean_torque, 1e-12 * torque),
             column(quantity::grip_torque, states, &RingState::grip_torque, 1e-12 * torque),
             column(quantity::torque_sum, states, &RingState::torque, 1e-9 * torque),
             column(quantity::force_x, states, of_friction(&ring::Wrench::force_x), 1e-12 * force),
             column(quantity::force_y, states, of_friction(&ring::Wrench::force_y), 1e-12 * force) } };
}

Table load_table(const ring::RingStack &load)
{
  constexpr unsigned int n_intervals = 720;
  const ring::RingStack first = load.truncated(1);
  std::vector<double> angles;
  for (unsigned int i = 0; i <= n_intervals; ++i)
    angles.push_back(boost::math::double_constants::two_pi * i / n_intervals);
  Table table = { "Load on the table round the rim at rest",
                  { column(quantity::theta, angles),
                    column(quantity::lambda_all, angles, [&](double angle) { return load(angle); }),
                    column(quantity::lambda_first, angles, [&](double angle) { return first(angle); }) } };
  if (load.rings().size() > 1)
    for (const ring::RingStack::Ring &ring : load.rings())
    {
      std::vector<double> values;
      for (const double angle : angles)
        values.push_back(value_of(ring, angle));
      table.columns.push_back(
        numbers("lambda, ring of radius " + to_short_text(ring.radius) + " m", "N/rad", values));
    }
  return table;
}

Table ring_table(const ring::RingStack &load)
{
  std::vector<std::vector<double>> rows;
  for (std::size_t j = 0; j < load.rings().size(); ++j)
    for (std::size_t n = 0; n <= load.n_harmonics(); ++n)
    {
      const ring::RingStack::Ring &ring = load.rings()[j];
      rows.push_back(
        { static_cast<double>(j + 1), ring.radius, static_cast<double>(n), ring.a[n], ring.b[n] });
    }
  return number_rows(
    "Load at rest ring by ring: lambda_j(theta) = a_0 + sum a_n cos(n theta) + b_n sin(n "
    "theta); the load is the sum of the rings",
    { { "ring j", "1" }, { "r_j", "m" }, { "n", "1" }, { "a_n", "N/rad" }, { "b_n", "N/rad" } }, rows);
}

std::string load_file_text(const ring::RingStack &load)
{
  std::vector<double> order, a, b, share, crest;
  for (unsigned int n = 0; n <= load.n_harmonics(); ++n)
  {
    order.push_back(n);
    a.push_back(load.a(n));
    b.push_back(load.b(n));
    share.push_back(std::hypot(load.a(n), load.b(n)) / load.a(0));
    crest.push_back(n == 0 ? 0 : std::atan2(load.b(n), load.a(n)) / n);
  }
  return "# ring radius: " + to_text(load.radius()) + " (m)\n" +
         data_table(
           { "lambda(theta) = a_0 + sum a_n cos(n theta) + b_n sin(n theta)",
             { numbers("n", "1", order), numbers("a_n", "N/rad", a), numbers("b_n", "N/rad", b),
               numbers("amplitude / a_0", "1", share), numbers("direction of a crest", "rad", crest) } });
}

Table pointwise_table(const std::vector<fem::AzimuthLoad> &pointwise)
{
  return { "Load on the table round the ring at rest, pointwise: at the azimuths of the contact's lines, 0 "
           "where they carry none",
           { column(quantity::theta, pointwise, &fem::AzimuthLoad::azimuth),
             column(quantity::lambda, pointwise, &fem::AzimuthLoad::density) } };
}

Table footprint_table(const fem::PressureMap &footprint)
{
  std::vector<double> radius, azimuth, pressure;
  for (const auto &cut : footprint.cuts)
    for (const fem::PressurePoint &point : cut)
    {
      radius.push_back(point.radius);
      azimuth.push_back(point.azimuth);
      pressure.push_back(point.pressure);
    }
  return { "Pressure of the foot on the table, where there is some",
           { numbers("r", "m", radius), numbers("theta", "rad", azimuth),
             numbers("pressure", "Pa", pressure) } };
}

Table torque_table(const TorqueCurve &curve)
{
  Table table = { "The torques on the glass and the friction force of the table against the spin",
                  { column(quantity::omega, curve.omega), column(quantity::slip_ratio, curve.slip_ratio),
                    column(quantity::tau_z, curve.friction, &ring::Wrench::torque),
                    column(quantity::force_x, curve.friction, &ring::Wrench::force_x),
                    column(quantity::force_y, curve.friction, &ring::Wrench::force_y),
                    column(quantity::lean_torque, curve.lean_torque),
                    column(quantity::grip_torque, curve.grip_torque),
                    column(quantity::torque_sum, curve.sum) } };
  for (std::size_t i = 0; i < curve.harmonics.size(); ++i)
    table.columns.push_back(column(
      quantity::tau_z.with(&Quantity::name, "tau_z, harmonics up to " + std::to_string(curve.harmonics[i])),
      curve.truncations[i]));
  return table;
}

Table spin_up_table(const SpinUpCurves &curves, const std::optional<CouplingStatistics> &coupling)
{
  std::string title = "Spin-up from rest";
  if (coupling && coupling->interpolation_error)
    title += "; columns 3 to 5 from loads interpolated in omega, within " +
             to_short_text(*coupling->interpolation_error) + " of a_0";
  const std::vector<double> nothing(curves.time.size(), std::nan(""));
  return { title,
           { column(quantity::time, curves.time), column(quantity::omega_adaptive, curves.adaptive),
             column(quantity::omega_euler, curves.euler),
             column(quantity::omega_first, curves.first_harmonic.empty() ? nothing : curves.first_harmonic),
             column(quantity::yaw_angle, curves.yaw_angle) } };
}

Table phase_table(const PhaseStudy &phases)
{
  return { "Yaw torque over the phase: where the marks of glass and table stand in the slip frame",
           { column(quantity::mark_of_glass, phases.phases, &ring::Orientation::glass),
             column(quantity::mark_of_table, phases.phases, &ring::Orientation::table),
             column(quantity::tau_at_phase, phases.torque_at_rest),
             column(quantity::tau_at_phase_in_the_long_run, phases.torque_at_terminal) } };
}

Table history_table(const std::vector<fem::ContactIteration> &history)
{
  using Step = fem::ContactIteration;
  return { "Newton steps of the contact",
           { column(quantity::step, history, &Step::number),
             column(quantity::step_active, history, &Step::n_loaded),
             column(quantity::step_changed, history, &Step::n_changed),
             column(quantity::step_residual, history, &Step::residual),
             column(quantity::step_length, history, &Step::step_length),
             column(quantity::step_linear_iterations, history, &Step::linear_iterations) } };
}

} // namespace stemware::pipeline
