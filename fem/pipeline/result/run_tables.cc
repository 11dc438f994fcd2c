#include "fem/pipeline/base/numbers.h"
#include "fem/pipeline/result/common_sections.h"
#include "fem/pipeline/result/table_renderers.h"
#include "ring_model/load/constants.h"

#include <cmath>

namespace stemware::pipeline
{

namespace
{

constexpr char azimuth[] = "azimuth from the direction of travel";

/// Returns the load lambda_j(theta) of one ring [N/rad]. Single rings may have a negative mean a_0.
double value_of(const ring::RingStack::Ring &ring, double angle)
{
  double value = ring.a[0];
  for (std::size_t n = 1; n < ring.a.size(); ++n)
    value += ring.a[n] * std::cos(static_cast<double>(n) * angle) +
             ring.b[n] * std::sin(static_cast<double>(n) * angle);
  return value;
}

struct Coefficient
{
  std::size_t ring;
  double radius;
  unsigned int n;
  double a, b;
};

} // namespace

Table load_table(const ring::RingStack &load)
{
  constexpr unsigned int n_intervals = 720;
  const ring::RingStack first = load.truncated(1);
  std::vector<double> angles;
  for (unsigned int i = 0; i <= n_intervals; ++i)
    angles.push_back(2 * ring::pi * i / n_intervals);
  Table table = { "",
                  { column_of("theta", "theta", "rad", azimuth, angles),
                    column_of("load", "lambda, all harmonics", "N/rad", "load at rest, all harmonics", angles,
                              load),
                    column_of("load_first_harmonic", "lambda, first harmonic", "N/rad",
                              "load at rest, first harmonic", angles, first) } };
  if (load.rings().size() > 1)
    for (const ring::RingStack::Ring &ring : load.rings())
    {
      table.columns.push_back(column_of("load_at_radius_*", "lambda, ring of radius * m", "N/rad",
                                        "load at rest of the ring of radius * m", angles,
                                        [&](double angle) { return value_of(ring, angle); }));
      table.columns.back().quantity.number = to_short_text(ring.radius);
    }
  return table;
}

Table ring_table(const ring::RingStack &load)
{
  std::vector<Coefficient> rows;
  for (std::size_t j = 0; j < load.rings().size(); ++j)
    for (unsigned int n = 0; n <= load.n_harmonics(); ++n)
    {
      const ring::RingStack::Ring &ring = load.rings()[j];
      rows.push_back({ j + 1, ring.radius, n, ring.a[n], ring.b[n] });
    }
  return { "",
           { column_of("ring", "ring j", "1", "ring, counted from 1", rows, &Coefficient::ring),
             column_of("radius", "r_j", "m", "radius of the ring", rows, &Coefficient::radius),
             column_of("n", "n", "1", "harmonic", rows, &Coefficient::n),
             column_of("a", "a_n", "N/rad", "cosine coefficient", rows, &Coefficient::a),
             column_of("b", "b_n", "N/rad", "sine coefficient", rows, &Coefficient::b) } };
}

std::string load_file_text(const ring::RingStack &load)
{
  std::vector<Coefficient> rows;
  for (unsigned int n = 0; n <= load.n_harmonics(); ++n)
    rows.push_back({ 0, load.radius(), n, load.a(n), load.b(n) });
  const auto amplitude = [&](const Coefficient &row) { return std::hypot(row.a, row.b) / load.a(0); };
  const auto crest = [](const Coefficient &row) { return row.n == 0 ? 0 : std::atan2(row.b, row.a) / row.n; };
  const Table table = { "lambda(theta) = a_0 + sum a_n cos(n theta) + b_n sin(n theta)",
                        { column_of("n", "n", "1", "", rows, &Coefficient::n),
                          column_of("a", "a_n", "N/rad", "", rows, &Coefficient::a),
                          column_of("b", "b_n", "N/rad", "", rows, &Coefficient::b),
                          column_of("amplitude", "amplitude / a_0", "1", "", rows, amplitude),
                          column_of("crest", "direction of a crest", "rad", "", rows, crest) } };
  return "# ring radius: " + to_text(load.radius()) + " (m)\n" + data_table(table);
}

Table pointwise_table(const std::vector<fem::AzimuthLoad> &pointwise)
{
  return { "",
           { column_of("theta", "theta", "rad", azimuth, pointwise, &fem::AzimuthLoad::azimuth),
             column_of("load", "lambda", "N/rad", "load at rest on the lines of the contact", pointwise,
                       &fem::AzimuthLoad::density) } };
}

Table footprint_table(const fem::PressureMap &footprint)
{
  using Point = fem::PressurePoint;
  std::vector<Point> points;
  for (const auto &cut : footprint.cuts)
    points.insert(points.end(), cut.begin(), cut.end());
  return { "",
           { column_of("radius", "r", "m", "radius", points, &Point::radius),
             column_of("theta", "theta", "rad", azimuth, points, &Point::azimuth),
             column_of("pressure", "pressure", "Pa", "pressure of the foot on the table", points,
                       &Point::pressure) } };
}

Table torque_table(const TorqueCurve &curve)
{
  using ring::Torques;
  const auto friction = [](double ring::Wrench::*part)
  { return [=](const Torques &torques) { return torques.friction.*part; }; };
  Table table = {
    "",
    { column_of("omega", "omega", "rad/s", "spin", curve.omega),
      column_of("slip_ratio", "slip ratio omega R / v", "1", "slip ratio ωR/v", curve.omega,
                [&](double omega) { return omega / curve.spin_scale; }),
      column_of("tau", "tau_z, all harmonics", "N m", "torque of friction", friction_torques(curve.all)),
      column_of("force_x", "T_x", "N", "friction along the direction of travel", curve.all,
                friction(&ring::Wrench::force_x)),
      column_of("force_y", "T_y", "N", "friction to its left", curve.all, friction(&ring::Wrench::force_y)),
      column_of("lean_torque", "lean torque of the normal forces, all harmonics", "N m", "lean torque",
                curve.all, &Torques::lean_torque),
      column_of("grip_torque", "torque of the fingers", "N m", "torque of the fingers", curve.all,
                &Torques::grip_torque),
      column_of("torque_sum", "tau_z, lean torque and grip torque, sum", "N m", "sum of the torques",
                curve.all, &Torques::torque) }
  };
  if (curve.n_first > 0)
    table.columns.push_back(column_of("tau_up_to_*", "tau_z, harmonics up to *", "N m",
                                      "torque of friction of the harmonics up to *",
                                      friction_torques(curve.first), std::to_string(curve.n_first)));
  return table;
}

Table spin_up_table(const SpinUpCurves &curves)
{
  const std::vector<double> nothing(curves.time.size(), std::nan(""));
  return { "",
           { column_of("time", "time", "s", "time from rest", curves.time),
             column_of("omega", "omega, adaptive", "rad/s", "spin", curves.adaptive),
             column_of("omega_euler", "omega, forward Euler", "rad/s", "spin by fixed steps", curves.euler),
             column_of("omega_first_harmonic", "omega, first harmonic alone, adaptive", "rad/s",
                       "spin, first harmonic only",
                       curves.first_harmonic.empty() ? nothing : curves.first_harmonic),
             column_of("yaw_angle", "yaw angle, adaptive", "rad", "yaw angle", curves.yaw_angle) } };
}

Table driven_spin_table(const DrivenSpinUp &driven)
{
  return { "",
           { column_of("time", "time", "s", "time from rest", driven.time),
             column_of("orbit_speed", "orbit speed", "m/s", "speed of the hand", driven.speed),
             column_of("acceleration", "dv/dt", "m/s^2", "acceleration of the hand", driven.acceleration),
             column_of("omega", "omega", "rad/s", "spin", driven.omega) } };
}

Table phase_table(const PhaseStudy &phases)
{
  return { "",
           { column_of("glass_mark", "mark of the glass", "rad", "azimuth of the mark of the glass",
                       phases.phases, &ring::Orientation::glass),
             column_of("table_mark", "mark of the table", "rad", "azimuth of the mark of the table",
                       phases.phases, &ring::Orientation::table),
             column_of("tau_at_rest", "tau_z at rest", "N m", "torque of friction at rest",
                       phases.torque_at_rest),
             column_of("tau_at_terminal", "tau_z at the mean spin over time", "N m",
                       "torque of friction at the mean spin", phases.torque_at_terminal) } };
}

Table torque_change_table(const ring::TorqueEffects &effects)
{
  Table table = { "", { column_of("omega", "omega", "rad/s", "spin", effects.spins) } };
  for (const ring::TorqueEffect &effect : effects.rows)
    table.columns.push_back(column_of("up_to_*", "tau_z up to harmonic * minus tau_z of the first", "N m",
                                      "tau_z(n) - tau_z(1), harmonics up to *", effect.curve,
                                      std::to_string(effect.harmonics)));
  return table;
}

Table history_table(const std::vector<fem::ContactIteration> &history)
{
  using Step = fem::ContactIteration;
  return { "",
           { column_of("step", "step", "1", "Newton step", history, &Step::number),
             column_of("loaded_places", "loaded places", "1", "loaded places", history, &Step::n_loaded),
             column_of("changed_places", "changed places", "1", "places that changed between loaded and free",
                       history, &Step::n_changed),
             column_of("residual", "relative imbalance of forces", "1", "relative imbalance of forces",
                       history, &Step::residual),
             column_of("step_length", "share of the step taken", "1", "step length", history,
                       &Step::step_length),
             column_of("linear_iterations", "iterations of the linear solver", "1",
                       "iterations of the linear solver", history, &Step::linear_iterations) } };
}

} // namespace stemware::pipeline
