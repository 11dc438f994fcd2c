#include "fem/pipeline/output/plots/foot_plots.h"
#include "fem/pipeline/output/plots/plots.h"
#include "fem/pipeline/output/quantities.h"
#include "fem/pipeline/output/render/gnuplot.h"
#include "fem/pipeline/output/render/number_format.h"
#include "fem/pipeline/output/render/plot_script.h"
#include "fem/pipeline/support/numbers.h"

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <limits>
#include <optional>

namespace stemware::pipeline
{

namespace
{

struct PressureUnit
{
  double pascals;
  std::string name;
};

constexpr double degree = boost::math::double_constants::degree,
                 whole_turn = boost::math::double_constants::two_pi;
constexpr double micrometre = 1e-6;

double pressure_at(const std::vector<fem::PressurePoint> &cut, double radius)
{
  const auto above =
    std::lower_bound(cut.begin(), cut.end(), radius,
                     [](const fem::PressurePoint &point, double r) { return point.radius < r; });
  if (above == cut.begin() || above == cut.end())
    return (above == cut.end() ? cut.back() : cut.front()).pressure;
  const auto below = above - 1;
  const double share = (radius - below->radius) / (above->radius - below->radius);
  return (1 - share) * below->pressure + share * above->pressure;
}

/// The cut at @p n places over the width of the contact; without a pressure where it has no load.
std::vector<fem::PressurePoint> across_contact(const std::vector<fem::PressurePoint> &cut, bool has_edge,
                                               std::size_t n)
{
  const double nothing = std::numeric_limits<double>::quiet_NaN(), azimuth = cut.front().azimuth;
  const std::optional<fem::ContactWidth> width = fem::contact_width(cut, has_edge);
  if (!width)
    return std::vector<fem::PressurePoint>(n, { cut.front().radius, azimuth, nothing });
  // The points under pressure, and the edges if they lie beyond.
  std::vector<fem::PressurePoint> loaded;
  std::copy_if(cut.begin(), cut.end(), std::back_inserter(loaded),
               [&](const fem::PressurePoint &point) { return point.pressure > 0 || !has_edge; });
  if (width->inner < loaded.front().radius)
    loaded.insert(loaded.begin(), { width->inner, azimuth, 0 });
  if (width->outer > loaded.back().radius)
    loaded.push_back({ width->outer, azimuth, 0 });
  std::vector<fem::PressurePoint> points;
  for (std::size_t i = 0; i < n; ++i)
  {
    const double share = static_cast<double>(i) / static_cast<double>(n - 1);
    const double radius =
      std::clamp((1 - share) * width->inner + share * width->outer, width->inner, width->outer);
    points.push_back({ radius, azimuth, pressure_at(loaded, radius) });
  }
  return points;
}

/// Largest and mean pressure and the width of the contact, from the cuts of a grid.
std::string measures_of(const fem::PressureMap &footprint, const PressureUnit &unit)
{
  const std::size_t n_cuts = footprint.cuts.size();
  double force = 0, area = 0, narrowest = std::numeric_limits<double>::infinity(), widest = 0;
  fem::PressurePoint largest;
  for (std::size_t c = 0; c < n_cuts; ++c)
  {
    const double before =
      c > 0 ? footprint.cuts[c - 1].front().azimuth : footprint.cuts.back().front().azimuth - whole_turn;
    const double after = c + 1 < n_cuts ? footprint.cuts[c + 1].front().azimuth
                                        : footprint.cuts.front().front().azimuth + whole_turn;
    const auto points = across_contact(footprint.cuts[c], footprint.has_edge, 2 * footprint.cuts[c].size());
    const bool has_load = points.front().pressure >= 0;
    const double width = has_load ? points.back().radius - points.front().radius : 0;
    narrowest = std::min(narrowest, width);
    widest = std::max(widest, width);
    for (std::size_t i = 1; i < points.size() && has_load; ++i)
    {
      const double piece = (after - before) / 2 * (points[i].radius - points[i - 1].radius) *
                           (points[i].radius + points[i - 1].radius) / 2;
      area += piece;
      force += piece * (points[i].pressure + points[i - 1].pressure) / 2;
    }
    for (const fem::PressurePoint &point : footprint.cuts[c])
      if (point.pressure > largest.pressure)
        largest = point;
  }
  const std::string widths =
    widest - narrowest < 0.005 * widest
      ? fmt::format(FMT_STRING("{:.3g} µm"), widest / micrometre)
      : fmt::format(FMT_STRING("{:.3g} µm to {:.3g} µm"), narrowest / micrometre, widest / micrometre);
  return fmt::format(
    FMT_STRING("Largest pressure {:.3g} {} at θ = {:.0f}°, mean {:.3g} {}; the contact is {} "
               "wide{}."),
    format::Number{ largest.pressure / unit.pascals }, unit.name, largest.azimuth / degree,
    format::Number{ force / area / unit.pascals }, unit.name, widths,
    footprint.has_edge ? "" : ", where 99 % of the load lie");
}

/// Columns azimuth, distance from the contact radius, pressure: a block for each cut.
std::string drawn_points(const std::string &title, const std::vector<std::vector<fem::PressurePoint>> &cuts,
                         double contact_radius, const PressureUnit &unit)
{
  std::string data =
    "# " + title + "\n# 1: theta (degrees)\n# 2: r - R (µm)\n# 3: pressure (" + unit.name + ")\n";
  for (const auto &cut : cuts)
  {
    for (const fem::PressurePoint &point : cut)
      data += to_short_text(point.azimuth / degree) + ' ' +
              to_short_text((point.radius - contact_radius) / micrometre) + ' ' +
              to_short_text(point.pressure / unit.pascals) + '\n';
    data += '\n';
  }
  return data;
}

/// What the vertical axis has to show; never less than a micrometre to both sides.
std::pair<double, double> height_of(const std::vector<std::vector<fem::PressurePoint>> &cuts,
                                    double contact_radius)
{
  Extent radii;
  for (const auto &cut : cuts)
    for (const fem::PressurePoint &point : cut)
      if (point.pressure >= 0)
        radii.include((point.radius - contact_radius) / micrometre);
  const auto [least, most] = radii;
  if (least > most)
    return { -1, 1 };
  const double margin = std::max(0.05 * (most - least), most - least < 1 ? 1. : 0.);
  return { least - margin, most + margin };
}

} // namespace

bool has_cells(const fem::PressureMap &footprint)
{
  return footprint.is_grid && footprint.cuts.front().size() > 1;
}

double largest_pressure(const fem::PressureMap &footprint)
{
  double largest = 0;
  for (const auto &cut : footprint.cuts)
    for (const fem::PressurePoint &point : cut)
      largest = std::max(largest, point.pressure);
  return largest;
}

std::vector<std::vector<fem::PressurePoint>> drawn_cuts(const fem::PressureMap &footprint)
{
  constexpr std::size_t n_cuts = 72, n_across = 24;
  std::vector<std::vector<fem::PressurePoint>> cuts;
  if (!has_cells(footprint))
  {
    for (const auto &cut : footprint.cuts)
    {
      cuts.emplace_back();
      std::copy_if(cut.begin(), cut.end(), std::back_inserter(cuts.back()),
                   [](const fem::PressurePoint &point) { return point.pressure > 0; });
    }
    return cuts;
  }
  const std::size_t stride = (footprint.cuts.size() - 1) / n_cuts + 1;
  for (std::size_t c = 0; c < footprint.cuts.size(); c += stride)
    cuts.push_back(across_contact(footprint.cuts[c], footprint.has_edge, n_across));
  cuts.push_back(cuts.front());
  for (fem::PressurePoint &point : cuts.back())
    point.azimuth += whole_turn;
  return cuts;
}

Plot footprint_plot(const fem::PressureMap &footprint, double contact_radius)
{
  const double largest = largest_pressure(footprint);
  const PressureUnit unit = largest < 1e6 ? PressureUnit{ 1e3, "kPa" } : PressureUnit{ 1e6, "MPa" };
  const bool is_map = has_cells(footprint);
  const std::string label = "pressure (" + unit.name + ")";
  // In a view of three dimensions places are those of the screen.
  const std::string view_margins =
    "set lmargin at screen 0.19; set bmargin at screen 0.22; set tmargin at screen 0.95; set border 15; "
    "unset grid\n"
    "set colorbox user origin screen 0.79, screen 0.22 size screen 0.03, screen 0.73\nset label 1 " +
    gnuplot_text(label) + " at screen 0.97, screen 0.58 rotate by 90 center\n";
  const std::string drawing =
    is_map ? view_margins + "set view map; set pm3d corners2color mean\nsplot data using 1:2:3 with pm3d\n"
           : "plot data using 1:2:3 with points pt 5 ps 0.4 lc palette\n";
  const std::string title =
    "Pressure of the foot on the table, unrolled: along the rim and across it, R the contact radius.";
  const auto cuts = drawn_cuts(footprint);
  return { "footprint", is_map ? title + ' ' + measures_of(footprint, unit) : title,
           axis_commands("x", { quantity::axis::azimuth, false, std::pair(0., 360.) }) +
             axis_commands("y", { quantity::axis::distance_to_rim, false, height_of(cuts, contact_radius) }) +
             colour_commands(label, 0, largest / unit.pascals) + "set xtics 90\nunset key\n" + drawing,
           drawn_points(title, cuts, contact_radius, unit) };
}

} // namespace stemware::pipeline
