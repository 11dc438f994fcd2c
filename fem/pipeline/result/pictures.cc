#include "fem/contact/footprint.h"
#include "fem/pipeline/result/curves.h"
#include "ring_model/load/constants.h"
#include "ring_model/spin/curves.h"

#include <algorithm>
#include <cmath>

namespace stemware::pipeline
{

namespace
{

constexpr double degree = ring::pi / 180;

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

} // namespace

void add_load_lines(const LoadReport &report, Results &results)
{
  results.tables["load_lines"] = nullptr;
  if (!(report.contact_fraction < 1) || report.pointwise.empty())
    return;
  std::vector<fem::AzimuthValue> lines = report.pointwise;
  lines.push_back({ lines.front().azimuth + 2 * ring::pi, lines.front().value });
  const double mean = report.a(0);
  const auto fields = Fields<fem::AzimuthValue>{
    { "theta", "deg", "", [](const auto &line) { return line.azimuth / degree; }, in_picture("theta") },
    { "load", "1", "", [=](const auto &line) { return line.value / mean; }, in_picture("load") }
  };
  results.add_table("load_lines", fields.table(lines, Face::picture), Face::picture);
}

void add_slip(const std::string &name, const ring::Motion &motion, double radius, const ring::RingStack &load,
              double omega, Results &results)
{
  using Place = ring::RimSlip;
  static const auto fields =
    Fields<Place>{ { "theta", "deg", "", [](const Place &place) { return place.azimuth / degree; },
                     in_picture("theta") },
                   { "slip_x", "1", "", &Place::slip_x, in_picture("slip_x") },
                   { "slip_y", "1", "", &Place::slip_y, in_picture("slip_y") },
                   { "friction_x", "1", "", &Place::friction_x, in_picture("friction_x") },
                   { "friction_y", "1", "", &Place::friction_y, in_picture("friction_y") },
                   { "torque", "1", "", torque_of, in_picture("torque") } };
  results.add_table(name, fields.table(ring::rim_slip(motion, radius, load, omega), Face::picture),
                    Face::picture);
}

void add_motion(const ring::Motion &motion, double radius, const std::vector<ring::Instant> &instants,
                Results &results)
{
  constexpr unsigned int n_places = 48;
  const double rate = motion.sense_sign() * motion.orbit_speed / motion.orbit_radius;
  Json &rows = results.tables["motion"] = Json::array();
  for (const ring::Instant &instant : instants)
  {
    const ring::RingState &state = instant.state;
    std::vector<double> load, friction_x, friction_y, turns;
    for (unsigned int i = 0; i < n_places; ++i)
      load.push_back(std::max(0., state.load(2 * ring::pi * i / n_places) / state.load.a(0)));
    for (const ring::RimSlip &place : ring::rim_slip(motion, radius, state.load, instant.omega))
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

void add_curves(const StudyCurves &curves, const Fields<std::size_t> &torque,
                const Fields<std::size_t> &spin_up, Results &results)
{
  const auto add = [&](const char *name, const Fields<std::size_t> &columns, std::size_t n_points)
  {
    constexpr std::size_t drawn_points = 200;
    results.add_table(name, columns.table(points_of(n_points, drawn_points), Face::picture), Face::picture);
  };
  const SpinUpCurves &up = curves.spin_up;
  add("torque", torque, curves.torque.omega.size());
  add("spin_up", spin_up, up.time.size());
  if (up.driven)
    add("driven", driven_columns(*up.driven), up.driven->time.size());
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
