#include "fem/pipeline/report/picture_columns.h"

#include "ring_model/rim_slip.h"

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>

namespace stemware::pipeline
{

namespace
{

using Json = nlohmann::ordered_json;
using Columns = std::vector<std::pair<std::string, std::vector<double>>>;

constexpr double degree_of_picture = boost::math::double_constants::degree;

/// Every k-th value and the last, so that at most @p max_size are left: a picture shows no more.
std::vector<double> thinned(const std::vector<double> &values, std::size_t max_size = 200)
{
  const std::size_t step = std::max<std::size_t>(1, (values.size() + max_size - 1) / max_size);
  std::vector<double> kept;
  for (std::size_t i = 0; i + 1 < values.size(); i += step)
    kept.push_back(values[i]);
  if (!values.empty())
    kept.push_back(values.back());
  return kept;
}

/// Values of @p rows by a member or function.
template <typename Rows, typename Value>
std::vector<double> column_of(const Rows &rows, Value value)
{
  std::vector<double> column;
  for (const auto &row : rows)
    column.push_back(std::invoke(value, row));
  return column;
}

} // namespace

std::vector<double> spectrum_band(const ErrorBands &bands, unsigned int n_harmonics)
{
  if (bands.empty())
    return {};
  std::vector<double> widths(n_harmonics + 1, 0);
  for (unsigned int n = 1; n <= std::min(n_harmonics, n_harmonics_of_interest); ++n)
    widths[n] = std::hypot(band_of(bands, "a" + std::to_string(n)).value(),
                           band_of(bands, "b" + std::to_string(n)).value());
  return widths;
}

void add_load_columns(const LoadReport &report, const std::vector<double> &band, double sense_sign,
                      Document &document)
{
  constexpr unsigned int n_intervals = 180;
  const ring::RingStack &load = report.rings;
  std::vector<double> theta;
  for (unsigned int i = 0; i <= n_intervals; ++i)
    theta.push_back(360. * i / n_intervals);
  Columns curves = { { "theta", theta } };
  for (unsigned int order = 1; order <= 3 && order < load.n_harmonics(); ++order)
    curves.emplace_back("up_to_" + std::to_string(order),
                        column_of(theta, [kept = load.truncated(order), &load](double angle)
                                  { return kept(angle * degree_of_picture) / load.a(0); }));
  curves.emplace_back(
    "all", column_of(theta, [&](double angle) { return load(angle * degree_of_picture) / load.a(0); }));
  document.add_columns("load_curves", curves);
  const bool lifts = report.contact_fraction < 1 && !report.pointwise.empty();
  if (lifts) // a series overshoots there
  {
    std::vector<fem::AzimuthLoad> lines = report.pointwise;
    lines.push_back({ lines.front().azimuth + boost::math::double_constants::two_pi, lines.front().density });
    document.add_columns(
      "load_lines",
      { { "theta", column_of(lines, [](const auto &line) { return line.azimuth / degree_of_picture; }) },
        { "all", column_of(lines, [&](const auto &line) { return line.density / load.a(0); }) } });
  }
  // The orbit's centre lies at theta = 90 degrees of a counter-clockwise orbit.
  const double side = sense_sign * boost::math::double_constants::half_pi;
  const auto line_load = [&](double angle) // where the foot has lifted off the series swings about zero
  { return (lifts ? std::max(0., load(angle)) : load(angle)) / load.radius(); };
  document.words["load"] = { { "harmonics", load.n_harmonics() },
                             { "mean", load.a(0) },
                             { "line_load", load.a(0) / load.radius() },
                             { "turn",
                               std::abs(load.b(1)) > 1e-9 * load.a(0) ? std::copysign(1., load.b(1)) : 0. },
                             { "inside", line_load(side) },
                             { "outside", line_load(-side) } };

  // Harmonics without a band of their own are judged by the last one that has some.
  const auto last_banded = std::find_if(band.rbegin(), band.rend(), [](double width) { return width > 0; });
  std::vector<double> n, amplitudes, bands, resolved;
  for (unsigned int k = 1; k <= load.n_harmonics(); ++k)
  {
    const double amplitude = std::hypot(load.a(k), load.b(k)) / load.a(0),
                 own = band.empty() ? 0 : band.at(k);
    const double judge = own > 0 || last_banded == band.rend() ? own : *last_banded;
    if (amplitude <= 1e-12) // rounding
      continue;
    n.push_back(k);
    amplitudes.push_back(amplitude);
    bands.push_back(own);
    resolved.push_back(amplitude > judge ? 1 : 0);
  }
  document.add_columns(
    "spectrum", { { "n", n }, { "amplitude", amplitudes }, { "band", bands }, { "resolved", resolved } });
}

void add_slip_columns(const std::string &name, const ring::Motion &motion, double radius,
                      const ring::RingStack &load, double omega, Document &document)
{
  const std::vector<ring::RimSlip> places = ring::rim_slip(motion, radius, load, omega);
  const auto torque = [](const ring::RimSlip &place)
  { return place.friction_y * std::cos(place.azimuth) - place.friction_x * std::sin(place.azimuth); };
  document.add_columns(name, { { "theta", column_of(places, [](const ring::RimSlip &place)
                                                    { return place.azimuth / degree_of_picture; }) },
                               { "slip_x", column_of(places, &ring::RimSlip::slip_x) },
                               { "slip_y", column_of(places, &ring::RimSlip::slip_y) },
                               { "friction_x", column_of(places, &ring::RimSlip::friction_x) },
                               { "friction_y", column_of(places, &ring::RimSlip::friction_y) },
                               { "torque", column_of(places, torque) } });
}

void add_torque_columns(const TorqueCurve &curve, const std::vector<ring::Answer> &rows, Document &document)
{
  Columns columns = { { "omega", thinned(curve.omega) },
                      { "all", thinned(column_of(curve.friction, &ring::Wrench::torque)) } };
  for (std::size_t i = 0; i < curve.harmonics.size(); ++i)
    if (curve.harmonics[i] <= 3 && curve.harmonics[i] < rows.back().harmonics)
      columns.emplace_back("up_to_" + std::to_string(curve.harmonics[i]), thinned(curve.truncations[i]));
  document.add_columns("torque", columns);
  std::vector<double> harmonics, spins;
  for (const ring::Answer &row : rows)
    if (const bool all = &row == &rows.back(); row.omega_terminal() && (all || row.harmonics <= 3))
    {
      harmonics.push_back(all ? 0 : row.harmonics); // 0: all
      spins.push_back(*row.omega_terminal());
    }
  document.add_columns("terminal_points", { { "harmonics", harmonics }, { "omega", spins } });
  document.words["spin_unit"] = curve.spin_unit();
}

void add_harmonic_torque_columns(const Budget &budget, Document &document)
{
  std::vector<double> difference;
  double largest = 0, largest_difference = 0;
  for (std::size_t i = 0; i < budget.omega.size(); ++i)
  {
    difference.push_back(budget.torque_all[i] - budget.torque_first[i]);
    largest = std::max(largest, std::abs(budget.torque_all[i]));
    largest_difference = std::max(largest_difference, std::abs(difference.back()));
  }
  if (largest_difference <= 1e-9 * largest) // rounding would fill the picture with noise
    std::fill(difference.begin(), difference.end(), 0);
  document.add_columns("harmonic_torque", { { "omega", thinned(budget.omega) },
                                            { "all", thinned(budget.torque_all) },
                                            { "first", thinned(budget.torque_first) },
                                            { "difference", thinned(difference) } });
}

void add_spin_up_columns(const SpinUpCurves &curves, const std::vector<MeasuredSpin> &measured,
                         Document &document)
{
  Columns columns = { { "time", thinned(curves.time) }, { "all", thinned(curves.adaptive) } };
  if (!curves.first_harmonic.empty())
    columns.emplace_back("up_to_1", thinned(curves.first_harmonic));
  columns.emplace_back("paper", thinned(curves.paper));
  document.add_columns("spin_up", columns);
  if (!measured.empty())
    document.add_columns("measured", { { "time", column_of(measured, &MeasuredSpin::time) },
                                       { "omega", column_of(measured, &MeasuredSpin::omega) } });
  if (curves.driven)
    document.add_columns("driven", { { "time", thinned(curves.driven->time) },
                                     { "speed", thinned(curves.driven->speed) },
                                     { "omega", thinned(curves.driven->omega) } });
}

void add_phase_columns(const PhaseStudy &phases, Document &document)
{
  const bool of_glass = phases.n_glass_phases > 1;
  document.words["marked"] = of_glass ? "glass" : "table";
  document.add_columns(
    "phases",
    { { "theta", column_of(phases.phases, [=](const ring::Orientation &phase)
                           { return (of_glass ? phase.glass : phase.table) / degree_of_picture; }) },
      { "at_rest", phases.torque_at_rest },
      { "at_terminal", phases.torque_at_terminal } });
}

} // namespace stemware::pipeline
