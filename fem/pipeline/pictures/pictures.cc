#include "fem/pipeline/pictures/pictures.h"

#include "fem/contact/footprint.h"
#include "fem/pipeline/support/numbers.h"
#include "ring_model/rim_slip.h"

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>

namespace stemware::pipeline
{

namespace
{

using Json = nlohmann::ordered_json;
using Columns = std::vector<std::pair<std::string, std::vector<double>>>;

using boost::math::double_constants::degree;

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

constexpr double micrometres = 1e6; ///< of a metre

/// Largest and mean pressure, and the width of the contact.
Json measures_of(const fem::PressureMap &footprint, double pascals)
{
  if (!fem::has_cells(footprint))
    return nullptr;
  const fem::FootprintMeasures measures = fem::measures_of(footprint);
  const bool is_even = measures.widest - measures.narrowest < 0.005 * measures.widest;
  return { { "largest", measures.largest.pressure / pascals },
           { "azimuth", measures.largest.azimuth / degree },
           { "mean", measures.mean / pascals },
           { "narrowest", is_even ? Json(nullptr) : Json(measures.narrowest * micrometres) },
           { "widest", measures.widest * micrometres },
           { "has_edge", footprint.has_edge } };
}

/// Torque of the friction on a place, over the mean friction and the radius.
double torque_of(const ring::RimSlip &place)
{
  return place.friction_y * std::cos(place.azimuth) - place.friction_x * std::sin(place.azimuth);
}

/// Numbers of the size of 1 for a drawing, rounded to thousandths.
Json thousandths(std::vector<double> values)
{
  for (double &value : values)
    value = std::round(1e3 * value) / 1e3;
  return shortened(values);
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

void Pictures::add_columns(const std::string &name,
                           const std::vector<std::pair<std::string, std::vector<double>>> &columns)
{
  Json &shown = tables[name] = { { "keys", Json::array() }, { "values", Json::array() } };
  for (const auto &[key, numbers] : columns)
  {
    shown["keys"].push_back(key);
    shown["values"].push_back(shortened(numbers));
  }
}

Json shortened(double value, int n_digits)
{
  if (!std::isfinite(value))
    return nullptr;
  const double number = rounded(value, n_digits);
  if (number == std::round(number) && std::abs(number) < 1e15)
    return static_cast<std::int64_t>(number); // 3 is shorter than 3.0
  return number;
}

Json shortened(const std::vector<double> &values, int n_digits)
{
  Json list = Json::array();
  for (const double value : values)
    list.push_back(shortened(value, n_digits));
  return list;
}

TruncatedLoads first_harmonics_of(const ring::RingStack &load)
{
  TruncatedLoads loads;
  for (unsigned int order = 1; order <= 3 && order < load.n_harmonics(); ++order)
    loads.emplace_back(order, load.truncated(order));
  return loads;
}

void add_load_columns(const LoadReport &report, const TruncatedLoads &truncated, double sense_sign,
                      Pictures &pictures)
{
  constexpr unsigned int n_intervals = 180;
  const ring::RingStack &load = report.rings;
  std::vector<double> theta;
  for (unsigned int i = 0; i <= n_intervals; ++i)
    theta.push_back(360. * i / n_intervals);
  Columns curves = { { "theta", theta } };
  for (const auto &[order, kept] : truncated)
    curves.emplace_back(
      "up_to_" + std::to_string(order),
      column_of(theta, [&kept = kept, &load](double angle) { return kept(angle * degree) / load.a(0); }));
  curves.emplace_back("all",
                      column_of(theta, [&](double angle) { return load(angle * degree) / load.a(0); }));
  pictures.add_columns("load_curves", curves);
  const bool lifts = report.contact_fraction < 1 && !report.pointwise.empty();
  if (lifts) // a series overshoots there
  {
    std::vector<fem::AzimuthLoad> lines = report.pointwise;
    lines.push_back({ lines.front().azimuth + boost::math::double_constants::two_pi, lines.front().density });
    pictures.add_columns(
      "load_lines",
      { { "theta", column_of(lines, [](const auto &line) { return line.azimuth / degree; }) },
        { "all", column_of(lines, [&](const auto &line) { return line.density / load.a(0); }) } });
  }
  // The orbit's centre lies at theta = 90 degrees of a counter-clockwise orbit.
  const double side = sense_sign * boost::math::double_constants::half_pi;
  const auto line_load = [&](double angle) // where the foot has lifted off the series swings about zero
  { return (lifts ? std::max(0., load(angle)) : load(angle)) / load.radius(); };
  pictures.words["load"] = { { "harmonics", load.n_harmonics() },
                             { "mean", load.a(0) },
                             { "line_load", load.a(0) / load.radius() },
                             { "turn",
                               std::abs(load.b(1)) > 1e-9 * load.a(0) ? std::copysign(1., load.b(1)) : 0. },
                             { "inside", line_load(side) },
                             { "outside", line_load(-side) } };
}

void add_spectrum_columns(const ring::RingStack &load, const std::vector<double> &band, Pictures &pictures)
{
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
  pictures.add_columns(
    "spectrum", { { "n", n }, { "amplitude", amplitudes }, { "band", bands }, { "resolved", resolved } });
}

void add_slip_columns(const std::string &name, const ring::Motion &motion, double radius,
                      const ring::RingStack &load, double omega, Pictures &pictures)
{
  const std::vector<ring::RimSlip> places = ring::rim_slip(motion, radius, load, omega);
  pictures.add_columns(
    name, { { "theta", column_of(places, [](const ring::RimSlip &place) { return place.azimuth / degree; }) },
            { "slip_x", column_of(places, &ring::RimSlip::slip_x) },
            { "slip_y", column_of(places, &ring::RimSlip::slip_y) },
            { "friction_x", column_of(places, &ring::RimSlip::friction_x) },
            { "friction_y", column_of(places, &ring::RimSlip::friction_y) },
            { "torque", column_of(places, torque_of) } });
}

void add_motion(const Study &study, const std::vector<ring::Instant> &instants, Pictures &pictures)
{
  constexpr unsigned int n_places = 48;
  const ring::Motion &motion = study.motion.orbit;
  const double rate = motion.sense_sign() * motion.orbit_speed / motion.orbit_radius;
  Json &rows = pictures.tables["motion"] = Json::array();
  for (const ring::Instant &instant : instants)
  {
    const ring::RingState &state = instant.state;
    std::vector<double> load, friction_x, friction_y, turns;
    for (unsigned int i = 0; i < n_places; ++i)
      load.push_back(
        std::max(0., state.load(boost::math::double_constants::two_pi * i / n_places) / state.load.a(0)));
    for (const ring::RimSlip &place :
         ring::rim_slip(motion, study.glass.profile.contact_radius, state.load, instant.omega))
    {
      friction_x.push_back(place.friction_x);
      friction_y.push_back(place.friction_y);
      turns.push_back(std::copysign(1., torque_of(place)));
    }
    // The hand accelerates the glass against the friction of the table.
    const Eigen::Vector2d hand = motion.total_mass() * motion.acceleration() -
                                 Eigen::Vector2d(state.friction.force_x, state.friction.force_y);
    rows.push_back({ { "time", shortened(instant.time) },
                     { "omega", shortened(instant.omega) },
                     { "yaw", shortened(instant.yaw_angle) },
                     { "orbit", shortened(rate * instant.time) },
                     { "torque", shortened(state.torque()) },
                     { "hand", { shortened(hand.x(), 4), shortened(hand.y(), 4) } },
                     { "load", thousandths(load) },
                     { "friction", { thousandths(friction_x), thousandths(friction_y) } },
                     { "turns", shortened(turns) } });
  }
}

void add_torque_columns(const TorqueCurve &curve, const std::vector<ring::Answer> &rows,
                        const std::vector<double> &of_paper, Pictures &pictures)
{
  Columns columns = { { "omega", thinned(curve.omega) },
                      { "all", thinned(column_of(curve.friction, &ring::Wrench::torque)) } };
  for (std::size_t i = 0; i < curve.harmonics.size(); ++i)
    if ((curve.harmonics[i] <= 3 || rows.size() == 2) && curve.harmonics[i] < rows.back().harmonics)
      columns.emplace_back("up_to_" + std::to_string(curve.harmonics[i]), thinned(curve.truncations[i]));
  if (!of_paper.empty())
    columns.emplace_back("paper", thinned(of_paper));
  pictures.add_columns("torque", columns);
  std::vector<double> harmonics, spins;
  for (const ring::Answer &row : rows)
    if (const bool all = &row == &rows.back();
        row.omega_terminal() && (all || row.harmonics <= 3 || rows.size() == 2))
    {
      harmonics.push_back(all ? 0 : row.harmonics); // 0: all
      spins.push_back(*row.omega_terminal());
    }
  pictures.add_columns("terminal_points", { { "harmonics", harmonics }, { "omega", spins } });
  const std::optional<double> unit = curve.spin_unit();
  pictures.words["spin_unit"] = unit ? Json(*unit) : Json(nullptr);
}

void add_harmonic_torque_columns(const Budget &budget, Pictures &pictures)
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
  pictures.add_columns("harmonic_torque", { { "omega", thinned(budget.omega) },
                                            { "all", thinned(budget.torque_all) },
                                            { "first", thinned(budget.torque_first) },
                                            { "difference", thinned(difference) } });
}

void add_spin_up_columns(const SpinUpCurves &curves, unsigned int n_first, Pictures &pictures)
{
  Columns columns = { { "time", thinned(curves.time) }, { "all", thinned(curves.adaptive) } };
  if (!curves.first_harmonic.empty())
    columns.emplace_back("up_to_" + std::to_string(n_first), thinned(curves.first_harmonic));
  columns.emplace_back("paper", thinned(curves.paper));
  pictures.add_columns("spin_up", columns);
  if (curves.driven)
    pictures.add_columns("driven", { { "time", thinned(curves.driven->time) },
                                     { "speed", thinned(curves.driven->speed) },
                                     { "omega", thinned(curves.driven->omega) } });
}

void add_phase_columns(const PhaseStudy &phases, Pictures &pictures)
{
  const bool of_glass = phases.n_glass_phases > 1;
  pictures.words["marked"] = of_glass ? "glass" : "table";
  pictures.add_columns("phases",
                       { { "theta", column_of(phases.phases, [=](const ring::Orientation &phase)
                                              { return (of_glass ? phase.glass : phase.table) / degree; }) },
                         { "at_rest", phases.torque_at_rest },
                         { "at_terminal", phases.torque_at_terminal } });
}

std::vector<BudgetRow> named_steps(const std::vector<BudgetRow> &rows)
{
  std::vector<BudgetRow> steps;
  std::optional<double> first; // terminal spin of the first harmonic alone
  for (const BudgetRow &row : rows)
  {
    if (row.name != "harmonics" || steps.empty() || steps.back().name != "harmonics")
    {
      first = row.difference ? std::optional(*row.omega_terminal - *row.difference) : std::nullopt;
      steps.push_back(row);
      continue;
    }
    steps.back() = row;
    steps.back().difference =
      first && row.omega_terminal ? std::optional(*row.omega_terminal - *first) : std::nullopt;
  }
  return steps;
}

void add_waterfall(const std::vector<BudgetRow> &rows, double rounding, Pictures &pictures)
{
  std::vector<BudgetRow> steps = named_steps(rows);
  if (!steps.empty())
  {
    steps.push_back(steps.back());
    steps.back().name = "this study";
    steps.back().status = ring::Status::no_balance; // whose row says whether it is formal
    steps.front().name = "the paper's model";
    steps.front().difference = steps.back().difference = std::nullopt;
  }
  Json name = Json::array(), omega = Json::array(), difference = Json::array(), band = Json::array(),
       formal = Json::array();
  const auto number = [](const std::optional<double> &value)
  { return value ? shortened(*value, 10) : Json(nullptr); };
  for (const BudgetRow &row : steps)
  {
    const bool is_formal = row.status == ring::Status::formal;
    name.push_back(row.name + (is_formal ? " (formal)" : ""));
    omega.push_back(number(row.omega_terminal));
    difference.push_back(number(row.difference));
    band.push_back(number(row.band));
    formal.push_back(is_formal);
  }
  pictures.tables["waterfall"] = { { "keys", { "row", "omega_terminal", "difference", "band", "formal" } },
                                   { "values", { name, omega, difference, band, formal } } };
  pictures.words["rounding"] = rounding;
}

Json pressure_map(const fem::PressureMap &footprint, double contact_radius, double largest)
{
  const bool is_low = fem::largest_pressure(footprint) < 1e6;
  const double pascals = is_low ? 1e3 : 1e6;
  Json theta = Json::array(), distance = Json::array(), pressure = Json::array();
  for (const auto &cut : fem::loaded_cuts(footprint))
  {
    std::vector<double> places, pressures;
    for (const fem::PressurePoint &point : cut)
    {
      places.push_back((point.radius - contact_radius) * micrometres);
      pressures.push_back(point.pressure / pascals);
    }
    theta.push_back(cut.empty() ? Json(nullptr) : shortened(cut.front().azimuth / degree, 6));
    distance.push_back(shortened(places, 4));
    pressure.push_back(shortened(pressures, 3));
  }
  return { { "theta", theta },
           { "distance", distance },
           { "pressure", pressure },
           { "unit", is_low ? "kPa" : "MPa" },
           { "largest", shortened(largest / pascals) },
           { "is_grid", fem::has_cells(footprint) },
           { "measures", measures_of(footprint, pascals) } };
}

} // namespace stemware::pipeline
