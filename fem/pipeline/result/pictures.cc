#include "fem/pipeline/result/pictures.h"

#include "fem/contact/footprint.h"
#include "ring_model/load/constants.h"
#include "ring_model/rim_slip.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace stemware::pipeline
{

namespace
{

using Columns = std::vector<std::pair<std::string, std::vector<double>>>;

constexpr double degree = ring::pi / 180;

/// Returns at most @p max_size of @p values at equal index steps, and the last value.
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

constexpr double micrometres = 1e6; ///< per metre

Json measures_of(const fem::PressureMap &footprint, double pascals, double peak,
                 const std::optional<double> &band)
{
  if (!fem::has_cells(footprint))
    return nullptr;
  const fem::FootprintMeasures measures = fem::measures_of(footprint);
  const bool is_even = measures.widest - measures.narrowest < 0.005 * measures.widest;
  return { { "largest", peak / pascals },
           { "band", band && *band > 0.1 * peak ? Json(*band / pascals) : Json(nullptr) },
           { "azimuth", measures.largest.azimuth / degree },
           { "mean", measures.mean / pascals },
           { "narrowest", is_even ? Json(nullptr) : Json(measures.narrowest * micrometres) },
           { "widest", measures.widest * micrometres },
           { "has_edge", footprint.has_edge } };
}

/// Returns the friction torque per angle at @p place, divided by the product of the radius and the friction
/// force per angle under the mean load.
double torque_of(const ring::RimSlip &place)
{
  return place.friction_y * std::cos(place.azimuth) - place.friction_x * std::sin(place.azimuth);
}

/// Rounds numbers of order 1 to the resolution of a drawing.
Json thousandths(std::vector<double> values)
{
  for (double &value : values)
    value = std::round(1e3 * value) / 1e3;
  return rounded_number(values);
}

template <typename Rows, typename Value>
std::vector<double> column_of(const Rows &rows, Value value)
{
  std::vector<double> column;
  for (const auto &row : rows)
    column.push_back(std::invoke(value, row));
  return column;
}

} // namespace

void add_load_lines(const LoadReport &report, Results &results)
{
  results.tables["load_lines"] = nullptr;
  if (!(report.contact_fraction < 1) || report.pointwise.empty())
    return;
  std::vector<fem::AzimuthLoad> lines = report.pointwise;
  lines.push_back({ lines.front().azimuth + 2 * ring::pi, lines.front().density });
  const double mean = report.rings.a(0);
  results.add_columns(
    "load_lines", { { "theta", column_of(lines, [](const auto &line) { return line.azimuth / degree; }) },
                    { "load", column_of(lines, [=](const auto &line) { return line.density / mean; }) } });
}

void add_slip_columns(const std::string &name, const ring::Motion &motion, double radius,
                      const ring::RingStack &load, double omega, Results &results)
{
  const std::vector<ring::RimSlip> places = ring::rim_slip(motion, radius, load, omega);
  results.add_columns(
    name, { { "theta", column_of(places, [](const ring::RimSlip &place) { return place.azimuth / degree; }) },
            { "slip_x", column_of(places, &ring::RimSlip::slip_x) },
            { "slip_y", column_of(places, &ring::RimSlip::slip_y) },
            { "friction_x", column_of(places, &ring::RimSlip::friction_x) },
            { "friction_y", column_of(places, &ring::RimSlip::friction_y) },
            { "torque", column_of(places, torque_of) } });
}

void add_motion(const Study &study, const std::vector<ring::Instant> &instants, Results &results)
{
  constexpr unsigned int n_places = 48;
  const ring::Motion &motion = study.motion.orbit;
  const double rate = motion.sense_sign() * motion.orbit_speed / motion.orbit_radius;
  Json &rows = results.tables["motion"] = Json::array();
  for (const ring::Instant &instant : instants)
  {
    const ring::RingState &state = instant.state;
    std::vector<double> load, friction_x, friction_y, turns;
    for (unsigned int i = 0; i < n_places; ++i)
      load.push_back(std::max(0., state.load(2 * ring::pi * i / n_places) / state.load.a(0)));
    for (const ring::RimSlip &place :
         ring::rim_slip(motion, study.glass.profile.contact_radius, state.load, instant.omega))
    {
      friction_x.push_back(place.friction_x);
      friction_y.push_back(place.friction_y);
      turns.push_back(std::copysign(1., torque_of(place)));
    }
    // Force of the hand: m a - T with the friction force T.
    const Eigen::Vector2d hand = motion.total_mass() * motion.acceleration() -
                                 Eigen::Vector2d(state.friction.force_x, state.friction.force_y);
    rows.push_back({ { "time", rounded_number(instant.time) },
                     { "omega", rounded_number(instant.omega) },
                     { "yaw", rounded_number(instant.yaw_angle) },
                     { "orbit", rounded_number(rate * instant.time) },
                     { "torque", rounded_number(state.torque()) },
                     { "hand", { rounded_number(hand.x(), 4), rounded_number(hand.y(), 4) } },
                     { "load", thousandths(load) },
                     { "friction", { thousandths(friction_x), thousandths(friction_y) } },
                     { "turns", rounded_number(turns) } });
  }
}

void add_torque_columns(const TorqueCurve &curve, const std::vector<double> &of_paper, Results &results)
{
  Columns columns = { { "omega", thinned(curve.omega) }, { "all", thinned(friction_torques(curve.all)) } };
  if (curve.n_first > 0)
    columns.emplace_back("up_to_" + std::to_string(curve.n_first), thinned(friction_torques(curve.first)));
  if (!of_paper.empty())
    columns.emplace_back("paper", thinned(of_paper));
  results.add_columns("torque", columns);
}

void add_spin_up_columns(const SpinUpCurves &curves, unsigned int n_first, Results &results)
{
  Columns columns = { { "time", thinned(curves.time) }, { "all", thinned(curves.adaptive) } };
  if (!curves.first_harmonic.empty() && n_first > 0)
    columns.emplace_back("up_to_" + std::to_string(n_first), thinned(curves.first_harmonic));
  columns.emplace_back("paper", thinned(curves.paper));
  results.add_columns("spin_up", columns);
  if (curves.driven)
    results.add_columns("driven", { { "time", thinned(curves.driven->time) },
                                    { "speed", thinned(curves.driven->speed) },
                                    { "omega", thinned(curves.driven->omega) } });
}

void add_phase_columns(const PhaseStudy &phases, Results &results)
{
  const bool of_glass = phases.n_glass_phases > 1;
  results.words["marked"] = of_glass ? "glass" : "table";
  results.add_columns("phases",
                      { { "theta", column_of(phases.phases, [=](const ring::Orientation &phase)
                                             { return (of_glass ? phase.glass : phase.table) / degree; }) },
                        { "at_rest", phases.torque_at_rest },
                        { "at_terminal", phases.torque_at_terminal } });
}

Json pressure_map(const fem::PressureMap &footprint, double contact_radius, double largest, double peak,
                  const std::optional<double> &band)
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
    theta.push_back(cut.empty() ? Json(nullptr) : rounded_number(cut.front().azimuth / degree, 6));
    distance.push_back(rounded_number(places, 4));
    pressure.push_back(rounded_number(pressures, 3));
  }
  return { { "theta", theta },
           { "distance", distance },
           { "pressure", pressure },
           { "unit", is_low ? "kPa" : "MPa" },
           { "largest", rounded_number(largest / pascals) },
           { "is_grid", fem::has_cells(footprint) },
           { "measures", measures_of(footprint, pascals, peak, band) } };
}

} // namespace stemware::pipeline
