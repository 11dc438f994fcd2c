#include "fem/pipeline/output/result_tables.h"

#include "fem/pipeline/coupling/load_file.h"
#include "fem/pipeline/support/numbers.h"
#include "fem/pipeline/support/text_file.h"

#include <boost/math/constants/constants.hpp>

#include <limits>

namespace stemware::pipeline
{

namespace
{

/// A column of one figure of each row of a list.
template <typename Row, typename Figure>
DataColumn column(const std::string &name, const std::string &unit, const std::vector<Row> &rows,
                  Figure figure)
{
  DataColumn result = { name, unit, {} };
  for (const Row &row : rows)
    result.values.push_back(static_cast<double>(figure(row)));
  return result;
}

std::string load_table(const ring::RingStack &load)
{
  constexpr unsigned int n_intervals = 720;
  const ring::RingStack first = load.truncated(1);
  DataColumn theta = { "theta", "rad", {} }, all = { "lambda, all harmonics", "N/rad", {} },
             one = { "lambda, first harmonic", "N/rad", {} };
  for (unsigned int i = 0; i <= n_intervals; ++i)
  {
    theta.values.push_back(boost::math::constants::two_pi<double>() * i / n_intervals);
    all.values.push_back(load(theta.values.back()));
    one.values.push_back(first(theta.values.back()));
  }
  return data_table("Load on the table round the ring at rest", { theta, all, one });
}

std::string pointwise_table(const std::vector<fem::AzimuthLoad> &pointwise)
{
  return data_table(
    "Load on the table round the ring at rest, pointwise: at the azimuths of the contact's lines, 0 where "
    "they carry none",
    { column("theta", "rad", pointwise, [](const auto &place) { return place.azimuth; }),
      column("lambda", "N/rad", pointwise, [](const auto &place) { return place.density; }) });
}

/// One block of rows a cut, blank lines between them: what gnuplot takes for a grid.
std::string footprint_table(const fem::Footprint &footprint)
{
  std::string text =
    std::string("# Pressure of the foot on the table at rest, where there is some: ") +
    (footprint.is_grid ? "a grid, one block for each azimuth" : "points, one block for each contact line") +
    "\n# 1: r (m)\n# 2: theta (rad)\n# 3: pressure (Pa)\n";
  for (const auto &cut : footprint.cuts)
  {
    for (const fem::FootprintPoint &point : cut)
      text +=
        to_text(point.radius) + ' ' + to_text(point.azimuth) + ' ' + to_short_text(point.pressure) + '\n';
    text += '\n';
  }
  return text;
}

std::string torque_table(const TorqueCurve &curve)
{
  std::vector<DataColumn> columns = {
    { "omega", "rad/s", curve.omega },
    { "slip ratio omega R / v", "1", curve.slip_ratio },
    column("tau_z, all harmonics", "N m", curve.friction, [](const auto &wrench) { return wrench.torque; }),
    column("T_x", "N", curve.friction, [](const auto &wrench) { return wrench.force_x; }),
    column("T_y", "N", curve.friction, [](const auto &wrench) { return wrench.force_y; })
  };
  for (std::size_t i = 0; i < curve.harmonics.size(); ++i)
    columns.push_back(
      { "tau_z, harmonics up to " + std::to_string(curve.harmonics[i]), "N m", curve.truncations[i] });
  return data_table("Friction of the table on the ring against its spin", columns);
}

std::string spin_up_table(const SpinUpCurves &curves, const std::shared_ptr<CouplingFigures> &coupling)
{
  std::string title = "Spin-up from rest";
  if (coupling && coupling->interpolation_error)
    title += "; columns 3 to 5 from loads interpolated in omega, within " +
             to_short_text(*coupling->interpolation_error) + " of a_0";
  return data_table(title, { { "time", "s", curves.time },
                             { "omega, adaptive", "rad/s", curves.adaptive },
                             { "omega, forward Euler", "rad/s", curves.euler },
                             { "omega, first harmonic alone, adaptive", "rad/s", curves.first_harmonic },
                             { "yaw angle, adaptive", "rad", curves.yaw_angle } });
}

std::string phase_table(const PhaseFigures &phases)
{
  return data_table(
    "Yaw torque over the phase: where the marks of glass and table stand in the slip frame",
    { column("mark of the glass", "rad", phases.phases, [](const auto &phase) { return phase.glass; }),
      column("mark of the table", "rad", phases.phases, [](const auto &phase) { return phase.table; }),
      { "tau_z at rest", "N m", phases.torque_at_rest },
      { "tau_z at the mean spin in the long run", "N m", phases.torque_at_terminal } });
}

std::string truncation_table(const std::vector<TruncationRow> &rows)
{
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  return data_table(
    "The answer with the load cut off after some harmonics",
    { column("harmonics", "1", rows, [](const auto &row) { return row.harmonics; }),
      column("tau_z at rest", "N m", rows, [](const auto &row) { return row.tau_at_rest; }),
      column("terminal omega", "rad/s", rows, [](const auto &row) { return row.omega_terminal; }),
      column("relative change of terminal omega to all harmonics, nan where that is 0", "1", rows,
             [=](const auto &row) { return row.relative_change.value_or(nothing); }),
      column("a-priori bound on the change of tau_z at the terminal spin", "N m", rows,
             [](const auto &row) { return row.bound; }),
      column("minimum of the load at rest", "N/rad", rows,
             [](const auto &row) { return row.load_minimum; }) });
}

std::string history_table(const std::vector<fem::ContactIteration> &history)
{
  return data_table(
    "Newton steps of the contact",
    { column("step", "1", history, [](const auto &step) { return step.number; }),
      column("loaded places", "1", history, [](const auto &step) { return step.n_loaded; }),
      column("changed places", "1", history, [](const auto &step) { return step.n_changed; }),
      column("relative imbalance of forces", "1", history, [](const auto &step) { return step.residual; }),
      column("share of the step taken", "1", history, [](const auto &step) { return step.step_fraction; }),
      column("iterations of the linear solver", "1", history,
             [](const auto &step) { return step.linear_iterations; }) });
}

} // namespace

void write_result_tables(const StudyResult &result, const std::filesystem::path &folder)
{
  write_text_file(folder / "load.dat", load_table(result.load.at_rest));
  write_text_file(folder / "harmonics.dat", load_file_text(result.load.at_rest));
  write_text_file(folder / "torque.dat", torque_table(result.torque));
  write_text_file(folder / "spin_up.dat", spin_up_table(result.spin_up, result.load.coupling));
  write_text_file(folder / "truncation.dat", truncation_table(result.yaw.truncations));
  if (result.phases)
    write_text_file(folder / "phases.dat", phase_table(*result.phases));
  if (!result.contact)
    return;
  write_text_file(folder / "load_lines.dat", pointwise_table(result.load.pointwise));
  write_text_file(folder / "footprint.dat", footprint_table(result.contact->footprint));
  write_text_file(folder / "contact_history.dat", history_table(result.contact->result.history));
}

} // namespace stemware::pipeline
