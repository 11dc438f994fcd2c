#include "fem/pipeline/result/curves.h"

#include "ring_model/load/constants.h"

#include <cmath>

namespace stemware::pipeline
{

namespace
{

/// Returns a function that reads @p values, which must outlive it, at a point; NaN if @p values is empty.
auto values_in(const std::vector<double> &values)
{
  return [&values](std::size_t i) { return values.empty() ? std::nan("") : values[i]; };
}

} // namespace

std::vector<std::size_t> points_of(std::size_t n, std::size_t max_points)
{
  const std::size_t step = n > max_points ? (n + max_points - 1) / max_points : 1;
  std::vector<std::size_t> points;
  for (std::size_t i = 0; i + 1 < n; i += step)
    points.push_back(i);
  if (n > 0)
    points.push_back(n - 1);
  return points;
}

Fields<std::size_t> torque_columns(const TorqueCurve &curve)
{
  const auto torque = [&curve](double ring::Torques::*part)
  { return [=, &curve](std::size_t i) { return curve.all[i].*part; }; };
  const auto friction = [](const std::vector<ring::Torques> &torques, double ring::Wrench::*part)
  { return [=, &torques](std::size_t i) { return torques[i].friction.*part; }; };
  Fields<std::size_t> fields = {
    { "omega", "rad/s", "", values_in(curve.omega), in_file("omega", "spin"), in_picture("omega"),
      in_python("omega") },
    { "slip_ratio", "1", "", [&curve](std::size_t i) { return curve.omega[i] / curve.spin_scale; },
      in_file("slip ratio omega R / v", "slip ratio ωR/v"), in_python("slip_ratio") },
    { "tau", "N m", "", friction(curve.all, &ring::Wrench::torque),
      in_file("tau_z, all harmonics", "torque of friction"), in_picture("all"), in_python("friction") },
    { "force_x", "N", "", friction(curve.all, &ring::Wrench::force_x),
      in_file("T_x", "friction along the direction of travel"), in_python("force_x") },
    { "force_y", "N", "", friction(curve.all, &ring::Wrench::force_y), in_file("T_y", "friction to its left"),
      in_python("force_y") },
    { "lean_torque", "N m", "", torque(&ring::Torques::lean_torque),
      in_file("lean torque of the normal forces, all harmonics", "lean torque"), in_python("lean") },
    { "grip_torque", "N m", "", torque(&ring::Torques::grip_torque),
      in_file("torque of the fingers", "torque of the fingers"), in_python("grip") },
    { "torque_sum", "N m", "", [&curve](std::size_t i) { return curve.all[i].torque(); },
      in_file("tau_z, lean torque and grip torque, sum", "sum of the torques"), in_python("sum") }
  };
  if (curve.n_first > 0)
    fields.add({ "tau_up_to_*", "N m", "", friction(curve.first, &ring::Wrench::torque),
                 in_file("tau_z, harmonics up to *", "torque of friction of the harmonics up to *"),
                 in_picture("up_to_*"), with_number(std::to_string(curve.n_first)) });
  return fields;
}

Fields<std::size_t> spin_up_columns(const SpinUpCurves &curves, unsigned int n_first)
{
  const bool draws_first = !curves.first_harmonic.empty() && n_first > 0;
  return { { "time", "s", "", values_in(curves.time), in_file("time", "time from rest"), in_picture("time"),
             in_python("time") },
           { "omega", "rad/s", "", values_in(curves.adaptive), in_file("omega, adaptive", "spin"),
             in_picture("all"), in_python("omega") },
           { "omega_euler", "rad/s", "", values_in(curves.euler),
             in_file("omega, forward Euler", "spin by fixed steps") },
           { "omega_first_harmonic", "rad/s", "", values_in(curves.first_harmonic),
             in_file("omega, first harmonic alone, adaptive", "spin, first harmonic only"),
             in_picture(draws_first ? "up_to_*" : ""), in_python("first_harmonic"),
             with_number(std::to_string(n_first)) },
           { "yaw_angle", "rad", "", values_in(curves.yaw_angle), in_file("yaw angle, adaptive", "yaw angle"),
             in_python("yaw_angle") },
           { "omega_paper", "rad/s", "", values_in(curves.paper), in_picture("paper"), in_python("paper") } };
}

Fields<std::size_t> driven_columns(const DrivenSpinUp &driven)
{
  return { { "time", "s", "", values_in(driven.time), in_file("time", "time from rest"), in_picture("time") },
           { "orbit_speed", "m/s", "", values_in(driven.speed), in_file("orbit speed", "speed of the hand"),
             in_picture("speed") },
           { "acceleration", "m/s^2", "", values_in(driven.acceleration),
             in_file("dv/dt", "acceleration of the hand") },
           { "omega", "rad/s", "", values_in(driven.omega), in_file("omega", "spin"), in_picture("omega") } };
}

Fields<std::size_t> phase_columns(const PhaseStudy &phases)
{
  const auto mark = [&phases](double ring::Orientation::*azimuth, double unit)
  { return [=, &phases](std::size_t i) { return phases.phases[i].*azimuth / unit; }; };
  const auto drawn = phases.n_glass_phases > 1 ? &ring::Orientation::glass : &ring::Orientation::table;
  return { { "theta", "deg", "", mark(drawn, ring::pi / 180), in_picture("theta") },
           { "glass_mark", "rad", "", mark(&ring::Orientation::glass, 1),
             in_file("mark of the glass", "azimuth of the mark of the glass") },
           { "table_mark", "rad", "", mark(&ring::Orientation::table, 1),
             in_file("mark of the table", "azimuth of the mark of the table") },
           { "tau_at_rest", "N m", "", values_in(phases.torque_at_rest),
             in_file("tau_z at rest", "torque of friction at rest"), in_picture("at_rest") },
           { "tau_at_terminal", "N m", "", values_in(phases.torque_at_terminal),
             in_file("tau_z at the mean spin over time", "torque of friction at the mean spin"),
             in_picture("at_terminal") } };
}

Fields<std::size_t> torque_change_columns(const ring::TorqueEffects &effects)
{
  Fields<std::size_t> fields = { { "omega", "rad/s", "", values_in(effects.spins), in_file("omega", "spin"),
                                   in_picture("omega") } };
  for (const ring::TorqueEffect &effect : effects.rows)
    fields.add(
      { "up_to_*", "N m", "", values_in(effect.curve),
        in_file("tau_z up to harmonic * minus tau_z of the first", "tau_z(n) - tau_z(1), harmonics up to *"),
        in_picture(effect.harmonics > 1 ? "*" : ""), with_number(std::to_string(effect.harmonics)) });
  return fields;
}

} // namespace stemware::pipeline
