#include "fem/pipeline/report/plots/plots.h"
#include "fem/pipeline/report/render/table_renderers.h"

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>

namespace stemware::pipeline
{

namespace
{

constexpr double whole_turn = boost::math::double_constants::two_pi;

/// Azimuths at which series are drawn.
std::vector<double> azimuths()
{
  constexpr unsigned int n_intervals = 360;
  std::vector<double> theta;
  for (unsigned int i = 0; i <= n_intervals; ++i)
    theta.push_back(whole_turn * i / n_intervals);
  return theta;
}

std::vector<double> series(const ring::RingStack &load)
{
  std::vector<double> values;
  for (const double theta : azimuths())
    values.push_back(load(theta));
  return values;
}

} // namespace

Plot load_plot(const ring::RingStack &load, const std::vector<fem::AzimuthLoad> &pointwise,
               ring::OrbitSense sense)
{
  const auto over_mean = [&](std::vector<double> values)
  {
    for (double &value : values)
      value /= load.a(0);
    return values;
  };
  Table truncations = { "Load over its mean, by the harmonics that are kept",
                        { numbers("theta", "rad", azimuths()) } };
  for (const unsigned int order : { 1u, 2u, 3u, load.n_harmonics() })
  {
    const unsigned int n = std::min(order, load.n_harmonics());
    truncations.columns.push_back(
      numbers("n up to " + std::to_string(n), "1", over_mean(series(load.truncated(n)))));
  }
  std::vector<double> theta, whole;
  for (const fem::AzimuthLoad &place : pointwise)
  {
    theta.push_back(place.azimuth);
    whole.push_back(place.density);
  }
  const bool is_pointwise = !pointwise.empty();
  if (is_pointwise) // closed after a whole turn
  {
    theta.push_back(theta.front() + whole_turn);
    whole.push_back(whole.front());
  }
  const Table all = { is_pointwise ? "As it was solved" : "All harmonics",
                      { numbers("theta", "rad", is_pointwise ? theta : azimuths()),
                        numbers("lambda / a_0", "1", over_mean(is_pointwise ? whole : series(load))) } };
  return plot_from("load",
                   { { "side", sense == ring::OrbitSense::counterclockwise ? 1. : -1. },
                     { "turn", std::abs(load.b(1)) > 1e-9 * load.a(0) ? std::copysign(1., load.b(1)) : 0. },
                     { "mean", load.a(0) / load.radius() },
                     { "n_all", double(load.n_harmonics()) },
                     { "is_pointwise", is_pointwise } },
                   data_tables({ truncations, all }));
}

Plot slip_plot(const ring::Motion &motion, double radius, const std::vector<SlidingState> &states)
{
  constexpr unsigned int n_places = 24;
  std::vector<std::string> titles;
  std::vector<Table> blocks;
  for (const SlidingState &state : states)
  {
    titles.push_back(state.title);
    const double mean = motion.friction_at_rest() * state.load.a(0);
    std::vector<std::vector<double>> rows;
    for (unsigned int i = 0; i < n_places; ++i)
    {
      const double theta = whole_turn * i / n_places;
      const double slip_x = motion.orbit_speed - state.omega * radius * std::sin(theta),
                   slip_y = state.omega * radius * std::cos(theta), slip = std::hypot(slip_x, slip_y);
      const double share =
        slip > 0 ? -motion.friction_at(slip) * std::max(0., state.load(theta)) / (mean * slip) : 0;
      const double torque = share * (slip_y * std::cos(theta) - slip_x * std::sin(theta));
      rows.push_back({ theta, slip_x / motion.orbit_speed, slip_y / motion.orbit_speed, share * slip_x,
                       share * slip_y, torque < 0 ? -1. : 1. });
    }
    blocks.push_back(number_rows(state.title,
                                 { { "theta", "rad" },
                                   { "slip along v, over v", "1" },
                                   { "slip to the left, over v", "1" },
                                   { "friction along v, over that of the mean load", "1" },
                                   { "friction to the left", "1" },
                                   { "-1: it turns the glass clockwise", "1" } },
                                 rows));
  }
  return plot_from("slip", { { "title", titles } }, data_tables(blocks));
}

Plot line_load_plot(const ring::RingStack &load, ring::OrbitSense sense)
{
  return plot_from("line_load", { { "side", sense == ring::OrbitSense::counterclockwise ? 1. : -1. },
                                  { "mean", load.a(0) / load.radius() },
                                  { "n_all", double(load.n_harmonics()) } });
}

Plot higher_harmonics_plot(const ring::RingStack &load, bool is_pointwise)
{
  return plot_from("higher_harmonics", { { "n_all", double(load.n_harmonics()) },
                                         { "is_pointwise", is_pointwise },
                                         { "a_1", load.a(1) / load.a(0) },
                                         { "b_1", load.b(1) / load.a(0) } });
}

Plot spectrum_plot(const ring::RingStack &load, const std::vector<double> &band)
{
  // Harmonics without a band of their own are judged by the last one that has some.
  const auto last_banded = std::find_if(band.rbegin(), band.rend(), [](double width) { return width > 0; });
  const double last_band = last_banded == band.rend() ? 0 : *last_banded;
  std::vector<std::vector<double>> rows;
  bool has_hollow = false;
  for (unsigned int n = 1; n <= load.n_harmonics(); ++n)
  {
    const double amplitude = std::hypot(load.a(n), load.b(n)) / load.a(0);
    const double own = band.empty() ? 0 : band.at(n);
    const bool is_resolved = amplitude > (own > 0 ? own : last_band);
    has_hollow = has_hollow || (!is_resolved && amplitude > 1e-12);
    rows.push_back({ double(n), amplitude, own, double(is_resolved) });
  }
  Plot plot = plot_from("spectrum", {},
                        data_table(number_rows("Harmonics of the load",
                                               { { "n", "1" },
                                                 { "amplitude over the mean", "1" },
                                                 { "half-width of its error band, 0: none", "1" },
                                                 { "resolved", "1" } },
                                               rows)));
  if (has_hollow)
    plot.caption +=
      " Hollow: smaller than the error band, or than the last band that is known; not resolved.";
  return plot;
}

} // namespace stemware::pipeline
