#include "fem/pipeline/output/plots/plots.h"
#include "fem/pipeline/output/quantities.h"
#include "fem/pipeline/output/render/gnuplot.h"
#include "fem/pipeline/output/render/plot_script.h"
#include "fem/pipeline/output/render/table_renderers.h"

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace stemware::pipeline
{

namespace
{

/// What lambda is called where it is drawn as it was solved, all harmonics without the overshoot of a series.
constexpr char pointwise_title[] = "all harmonics";

/// Azimuths at which series are drawn.
std::vector<double> azimuths()
{
  constexpr unsigned int n_intervals = 360;
  std::vector<double> theta;
  for (unsigned int i = 0; i <= n_intervals; ++i)
    theta.push_back(boost::math::double_constants::two_pi * i / n_intervals);
  return theta;
}

/// The truncations that pictures show: after the first harmonic, after 2 and 3 where that differs from all by
/// more than a hundredth of @p scale [N/rad] somewhere, and all.
std::vector<unsigned int> shown_truncations(const ring::RingStack &load, double scale)
{
  const auto is_seen = [&](unsigned int n)
  {
    const ring::RingStack truncated = load.truncated(n);
    const std::vector<double> theta = azimuths();
    return std::any_of(theta.begin(), theta.end(),
                       [&](double angle) { return std::abs(truncated(angle) - load(angle)) > 0.01 * scale; });
  };
  std::vector<unsigned int> orders;
  for (const unsigned int n : { 1u, 2u, 3u })
    if (n < load.n_harmonics() && (n == 1 || is_seen(n)))
      orders.push_back(n);
  orders.push_back(load.n_harmonics());
  return orders;
}

/// lambda itself, closed after a whole turn: @p pointwise, or the series where that is empty.
std::vector<fem::AzimuthLoad> whole_load(const ring::RingStack &load, std::vector<fem::AzimuthLoad> pointwise)
{
  if (pointwise.empty())
    for (const double theta : azimuths())
      pointwise.push_back({ theta, load(theta) });
  else
    pointwise.push_back(
      { pointwise.front().azimuth + boost::math::double_constants::two_pi, pointwise.front().density });
  return pointwise;
}

/// Logarithmic range that shows @p values down to where rounding begins.
std::pair<double, double> amplitude_range(const std::vector<double> &values)
{
  double smallest = 1e-2;
  for (const double value : values)
    if (value > 1e-12)
      smallest = std::min(smallest, value);
  return { std::pow(10, std::floor(std::log10(smallest))), 10 };
}

/// 1 where the rim carries load, nan elsewhere, so that gnuplot interrupts the line.
Table contact_arc(const std::vector<fem::AzimuthLoad> &whole)
{
  return { "Arc of the rim that carries load",
           { column(quantity::theta, whole, &fem::AzimuthLoad::azimuth),
             column(quantity::under_load, whole,
                    [](const fem::AzimuthLoad &place)
                    { return place.density > 0 ? 1 : std::numeric_limits<double>::quiet_NaN(); }) } };
}

/// The rim has radius 1 and the load is drawn outwards from it, its mean as half a radius.
constexpr char view_from_above[] =
  R"gp(x(theta, load) = (1 + load / 2.) * cos(theta) # the rim has radius 1, the mean load half of that
y(theta, load) = (1 + load / 2.) * sin(theta)
set size ratio -1
set lmargin at screen 0.02; set rmargin at screen 0.65; set tmargin at screen 0.97; set bmargin at screen 0.03
unset border; unset tics; unset grid
set offsets 0.1, 0.1, 0.1, 0.1
set key at screen 0.67, screen 0.72 left top vertical
set arrow 1 from 0,0 to 0.4,0 lw 1.5 lc rgb "#333333"
set label 1 "v" at 0.46,0 left
set arrow 2 from 0,0 to 0,side * 0.3 lw 1 dt (6,4) lc rgb "#333333"
set label 6 "orbit's centre" at 0,side * 0.45 center font ",12"
set for [i=0:3] label i + 2 sprintf("%d°", 90 * i) at 0.78 * cos(pi * i / 2),0.78 * sin(pi * i / 2) center font ",12"
set parametric; set trange [0:2 * pi]; set samples 181
plot cos(t), sin(t) with lines lt 8 title rim, \
     data index arc using ($2 * cos($1)):($2 * sin($1)) with lines lt 7 lw 5 title "under load", \
     x(t, 1), y(t, 1) with lines lt 8 dt 3 title mean)gp";

} // namespace

std::string truncation_title(unsigned int n, unsigned int n_all)
{
  if (n == 1)
    return "first harmonic";
  return (n == n_all ? "all, n ≤ " : "n ≤ ") + std::to_string(n);
}

Plot load_plot(const ring::RingStack &load, const std::vector<fem::AzimuthLoad> &pointwise,
               ring::OrbitSense sense)
{
  const std::vector<unsigned int> orders = shown_truncations(load, load.a(0));
  const std::vector<fem::AzimuthLoad> whole = whole_load(load, pointwise);
  std::vector<Table> blocks;
  std::string curves;
  for (std::size_t i = 0; i < orders.size(); ++i)
  {
    const bool is_pointwise = i + 1 == orders.size() && !pointwise.empty();
    const ring::RingStack truncated = load.truncated(orders[i]);
    const std::string name = is_pointwise ? pointwise_title : truncation_title(orders[i], load.n_harmonics());
    blocks.push_back(
      { "λ(θ)/a_0, " + name,
        { column(quantity::theta, is_pointwise ? whole : whole_load(load, {}), &fem::AzimuthLoad::azimuth),
          column(quantity::load_over_mean, is_pointwise ? whole : whole_load(truncated, {}),
                 [&](const fem::AzimuthLoad &place) { return place.density / load.a(0); }) } });
    curves += ", \\\n     data index " + std::to_string(i) + " using (x($1, $2)):(y($1, $2)) with lines lt " +
              std::to_string(i + 1 == orders.size() ? 1 : i + 2) + " title " + gnuplot_text(name);
  }
  blocks.push_back(contact_arc(whole));
  const bool carries_everywhere =
    std::all_of(whole.begin(), whole.end(), [](const fem::AzimuthLoad &place) { return place.density > 0; });
  return {
    "load",
    "Load round the rim, seen from above and drawn outwards from the rim, the mean load as half a radius; "
    "v is the direction of travel, n the harmonics kept. A curve inside the rim would pull on the table.",
    std::string("side = ") + (sense == ring::OrbitSense::counterclockwise ? "1" : "-1") +
      "; arc = " + std::to_string(orders.size()) + "; rim = \"" + (carries_everywhere ? "" : "rim") +
      "\"; mean = \"mean, " + format::significant<3>(load.a(0) / load.radius()) + " N/m\"\n" +
      view_from_above + curves + "\n",
    data_tables(blocks),
    540,
    380
  };
}

Plot higher_harmonics_plot(const ring::RingStack &load, const std::vector<fem::AzimuthLoad> &pointwise)
{
  const ring::RingStack first = load.truncated(1);
  CurvePlot plot = {
    "higher_harmonics",
    "What the harmonics beyond the first add to the load, relative to its mean a_0; n harmonics kept.",
    { quantity::axis::azimuth, false, std::pair(0., 360.) },
    { "(λ - λ_1) / a_0" },
    {},
    "set xtics 90; set xzeroaxis lt 8; set key width 0\n"
  };
  double largest = 0;
  for (const double theta : azimuths())
    largest = std::max(largest, std::abs(load(theta) - first(theta)));
  for (const unsigned int n : shown_truncations(load, largest))
    if (n > 1)
    {
      const bool is_whole = n == load.n_harmonics(), is_pointwise = is_whole && !pointwise.empty();
      Curve curve = { is_pointwise ? "all" : truncation_title(n, load.n_harmonics()) };
      curve.line_type = is_whole ? 1 : n + 1;
      for (const fem::AzimuthLoad &place :
           is_pointwise ? whole_load(load, pointwise) : whole_load(load.truncated(n), {}))
        curve.add(place.azimuth / boost::math::double_constants::degree,
                  (place.density - first(place.azimuth)) / load.a(0));
      plot.curves.push_back(curve);
    }
  return curve_plot(plot);
}

Plot line_load_plot(const ring::RingStack &load, const std::vector<fem::AzimuthLoad> &pointwise,
                    ring::OrbitSense sense)
{
  const ring::RingStack first = load.truncated(1);
  const double radius = load.radius();
  CurvePlot plot = {
    "line_load",
    "The load per length of the rim, λ(θ)/R: what a strip of the table feels before the glass spins.",
    { quantity::axis::azimuth, false, std::pair(0., 360.) },
    { "λ / R (N/m)" },
    {},
    "set xzeroaxis lt 8\n"
  };
  const auto add =
    [&](const std::string &title, unsigned int line_type, const std::vector<fem::AzimuthLoad> &places)
  {
    Curve curve = { title };
    curve.line_type = line_type;
    for (const fem::AzimuthLoad &place : places)
      curve.add(place.azimuth / boost::math::double_constants::degree, place.density / radius);
    plot.curves.push_back(curve);
  };
  add(load.n_harmonics() > 1 ? pointwise_title : "first harmonic", 1, whole_load(load, pointwise));
  if (load.n_harmonics() > 1)
    add("first harmonic", 2, whole_load(first, {}));
  add("mean", 8, { { 0, load.a(0) }, { boost::math::double_constants::two_pi, load.a(0) } });
  // The orbit's centre lies to the left of the direction of travel where the orbit runs counter-clockwise.
  const bool is_left = sense == ring::OrbitSense::counterclockwise;
  const std::string centre = "orbit's centre", outside = "outside";
  plot.commands += "set xtics (\"0\\nfront\" 0, \"90\\n" + (is_left ? centre : outside) +
                   "\" 90, \"180\\nback\" 180, \"270\\n" + (is_left ? outside : centre) +
                   "\" 270, \"360\\nfront\" 360)\nset xlabel offset 0,-0.9; set bmargin 5\n";
  return curve_plot(plot);
}

Plot spectrum_plot(const ring::RingStack &load, const std::vector<double> &band)
{
  // Harmonics without a band of their own are judged by the last one that has some.
  unsigned int last_banded = 0;
  for (unsigned int n = 1; n < band.size(); ++n)
    if (band[n] > 0)
      last_banded = n;
  Curve resolved = { "resolved", {}, {}, CurveStyle::points },
        unresolved = { "not resolved", {}, {}, CurveStyle::points };
  unresolved.is_hollow = true;
  resolved.line_type = unresolved.line_type = 1;
  for (unsigned int n = 1; n <= load.n_harmonics(); ++n)
  {
    const double amplitude = std::hypot(load.a(n), load.b(n)) / load.a(0);
    const double own = band.empty() ? 0 : band.at(n);
    if (amplitude <= (own > 0 || last_banded == 0 ? own : band[last_banded]))
    {
      unresolved.add(n, amplitude);
      continue;
    }
    resolved.add(n, amplitude);
    if (!band.empty())
      resolved.band.push_back(own);
  }
  std::vector<double> shown = resolved.y;
  shown.insert(shown.end(), unresolved.y.begin(), unresolved.y.end());
  CurvePlot plot = {
    "spectrum",
    "Harmonics of the load relative to its mean a_0. What is below 10⁻¹² is rounding and not "
    "shown.",
    { "harmonic n", false, std::pair(0.5, load.n_harmonics() + 0.5) },
    { "√(a_n² + b_n²) / a_0", true, amplitude_range(shown) },
    { resolved }
  };
  const auto is_drawn = [](double amplitude) { return amplitude > 1e-12; };
  if (std::any_of(unresolved.y.begin(), unresolved.y.end(), is_drawn))
  {
    plot.curves.push_back(unresolved);
    plot.caption +=
      " Hollow: smaller than the error band, or than the last band that is known; not resolved.";
  }
  else
    plot.curves.front().title = "";
  // The axis ends with the last harmonic that is drawn.
  double last = 1;
  for (const Curve &curve : plot.curves)
    for (std::size_t i = 0; i < curve.x.size(); ++i)
      if (is_drawn(curve.y[i]))
        last = std::max(last, curve.x[i]);
  plot.x.range = std::pair(0.5, last + 0.5);
  if (last <= 10)
    plot.commands = "set xtics 1\n";
  return curve_plot(plot);
}

} // namespace stemware::pipeline
