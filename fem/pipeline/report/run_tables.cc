#include "fem/pipeline/report/common_sections.h"
#include "fem/pipeline/report/table_renderers.h"
#include "fem/pipeline/support/numbers.h"

#include <boost/math/constants/constants.hpp>

#include <cmath>

namespace stemware::pipeline
{

namespace
{

/// lambda_j(theta) of one ring [N/rad], which may pull on average.
double value_of(const ring::RingStack::Ring &ring, double angle)
{
  double value = ring.a[0];
  for (std::size_t n = 1; n < ring.a.size(); ++n)
    value += ring.a[n] * std::cos(static_cast<double>(n) * angle) +
             ring.b[n] * std::sin(static_cast<double>(n) * angle);
  return value;
}

} // namespace

Table load_table(const ring::RingStack &load)
{
  constexpr unsigned int n_intervals = 720;
  const ring::RingStack first = load.truncated(1);
  std::vector<double> angles;
  for (unsigned int i = 0; i <= n_intervals; ++i)
    angles.push_back(boost::math::double_constants::two_pi * i / n_intervals);
  Table table = { "",
                  { numbers("theta", "rad", angles), numbers("lambda, all harmonics", "N/rad", angles, load),
                    numbers("lambda, first harmonic", "N/rad", angles, first) } };
  if (load.rings().size() > 1)
    for (const ring::RingStack::Ring &ring : load.rings())
      table.columns.push_back(numbers("lambda, ring of radius " + to_short_text(ring.radius) + " m", "N/rad",
                                      angles, [&](double angle) { return value_of(ring, angle); }));
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
    "", { { "ring j", "1" }, { "r_j", "m" }, { "n", "1" }, { "a_n", "N/rad" }, { "b_n", "N/rad" } }, rows);
}

std::string load_file_text(const ring::RingStack &load)
{
  std::vector<std::vector<double>> rows;
  for (unsigned int n = 0; n <= load.n_harmonics(); ++n)
    rows.push_back({ static_cast<double>(n), load.a(n), load.b(n),
                     std::hypot(load.a(n), load.b(n)) / load.a(0),
                     n == 0 ? 0 : std::atan2(load.b(n), load.a(n)) / n });
  return "# ring radius: " + to_text(load.radius()) + " (m)\n" +
         data_table(number_rows("lambda(theta) = a_0 + sum a_n cos(n theta) + b_n sin(n theta)",
                                { { "n", "1" },
                                  { "a_n", "N/rad" },
                                  { "b_n", "N/rad" },
                                  { "amplitude / a_0", "1" },
                                  { "direction of a crest", "rad" } },
                                rows));
}

Table pointwise_table(const std::vector<fem::AzimuthLoad> &pointwise)
{
  return { "",
           { numbers("theta", "rad", pointwise, &fem::AzimuthLoad::azimuth),
             numbers("lambda", "N/rad", pointwise, &fem::AzimuthLoad::density) } };
}

Table footprint_table(const fem::PressureMap &footprint)
{
  std::vector<std::vector<double>> rows;
  for (const auto &cut : footprint.cuts)
    for (const fem::PressurePoint &point : cut)
      rows.push_back({ point.radius, point.azimuth, point.pressure });
  return number_rows("", { { "r", "m" }, { "theta", "rad" }, { "pressure", "Pa" } }, rows);
}

Table torque_table(const TorqueCurve &curve)
{
  using ring::Wrench;
  Table table = { "",
                  { numbers("omega", "rad/s", curve.omega),
                    numbers("slip ratio omega R / v", "1", curve.slip_ratio),
                    numbers("tau_z, all harmonics", "N m", curve.friction, &Wrench::torque),
                    numbers("T_x", "N", curve.friction, &Wrench::force_x),
                    numbers("T_y", "N", curve.friction, &Wrench::force_y),
                    numbers("lean torque of the normal forces, all harmonics", "N m", curve.lean_torque),
                    numbers("torque of the fingers", "N m", curve.grip_torque),
                    numbers("tau_z, lean torque and grip torque, sum", "N m", curve.sum) } };
  for (std::size_t i = 0; i < curve.harmonics.size(); ++i)
    table.columns.push_back(
      numbers("tau_z, harmonics up to " + std::to_string(curve.harmonics[i]), "N m", curve.truncations[i]));
  return table;
}

Table spin_up_table(const SpinUpCurves &curves)
{
  const std::vector<double> nothing(curves.time.size(), std::nan(""));
  return { "",
           { numbers("time", "s", curves.time), numbers("omega, adaptive", "rad/s", curves.adaptive),
             numbers("omega, forward Euler", "rad/s", curves.euler),
             numbers("omega, first harmonic alone, adaptive", "rad/s",
                     curves.first_harmonic.empty() ? nothing : curves.first_harmonic),
             numbers("yaw angle, adaptive", "rad", curves.yaw_angle) } };
}

Table driven_spin_table(const DrivenSpinUp &driven)
{
  return { "",
           { numbers("time", "s", driven.time), numbers("orbit speed", "m/s", driven.speed),
             numbers("dv/dt", "m/s^2", driven.acceleration), numbers("omega", "rad/s", driven.omega) } };
}

Table phase_table(const PhaseStudy &phases)
{
  return { "",
           { numbers("mark of the glass", "rad", phases.phases, &ring::Orientation::glass),
             numbers("mark of the table", "rad", phases.phases, &ring::Orientation::table),
             numbers("tau_z at rest", "N m", phases.torque_at_rest),
             numbers("tau_z at the mean spin over time", "N m", phases.torque_at_terminal) } };
}

Table truncation_table(const nlohmann::ordered_json &truncation)
{
  return table_of(truncation,
                  "harmonics tau_at_rest change_half change_half_relative change_terminal "
                  "change_terminal_relative change_largest change_largest_at rest_half bound_half "
                  "rest_terminal bound omega_terminal relative_change load_minimum",
                  "truncation");
}

Table torque_change_table(const ring::TorqueEffects &effects)
{
  Table table = { "", { numbers("omega", "rad/s", effects.spins) } };
  for (const ring::TorqueEffect &effect : effects.rows)
    table.columns.push_back(
      numbers("tau_z up to harmonic " + std::to_string(effect.harmonics) + " minus tau_z of the first", "N m",
              effect.curve));
  return table;
}

Table history_table(const std::vector<fem::ContactIteration> &history)
{
  using Step = fem::ContactIteration;
  return { "",
           { numbers("step", "1", history, &Step::number),
             numbers("loaded places", "1", history, &Step::n_loaded),
             numbers("changed places", "1", history, &Step::n_changed),
             numbers("relative imbalance of forces", "1", history, &Step::residual),
             numbers("share of the step taken", "1", history, &Step::step_length),
             numbers("iterations of the linear solver", "1", history, &Step::linear_iterations) } };
}

} // namespace stemware::pipeline
