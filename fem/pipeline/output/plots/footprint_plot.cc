#include "fem/pipeline/output/plots/plots.h"
#include "fem/pipeline/output/quantities.h"
#include "fem/pipeline/output/render/plot_script.h"
#include "fem/pipeline/output/render/table_renderers.h"

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <limits>

namespace stemware::pipeline
{

namespace
{

/// Cuts that are drawn of a footprint with many: a picture needs no more.
constexpr std::size_t n_drawn_cuts = 72;

struct PressureUnit
{
  double pascals;
  std::string name;
};

double largest_pressure(const fem::PressureMap &footprint)
{
  double largest = 0;
  for (const auto &cut : footprint.cuts)
    for (const fem::PressurePoint &point : cut)
      largest = std::max(largest, point.pressure);
  return largest;
}

/// Every so many cuts, and the first one again after a whole turn.
std::vector<std::vector<fem::PressurePoint>> drawn_cuts(const fem::PressureMap &footprint)
{
  if (!footprint.is_grid)
    return footprint.cuts;
  std::vector<std::vector<fem::PressurePoint>> cuts;
  const std::size_t stride = (footprint.cuts.size() - 1) / n_drawn_cuts + 1;
  for (std::size_t c = 0; c < footprint.cuts.size(); c += stride)
    cuts.push_back(footprint.cuts[c]);
  cuts.push_back(cuts.front());
  for (fem::PressurePoint &point : cuts.back())
    point.azimuth += boost::math::double_constants::two_pi;
  return cuts;
}

/// Columns azimuth, distance from the contact radius, pressure, and the bounds of the cell that a point of a
/// grid stands for, a little wider than it is: that closes the seams in the picture.
Table drawn_points(const std::string &title, const std::vector<std::vector<fem::PressurePoint>> &cuts,
                   double contact_radius, const PressureUnit &unit)
{
  constexpr double overlap = 1.03, degree = boost::math::double_constants::degree;
  std::vector<std::vector<double>> rows;
  for (std::size_t c = 0; c < cuts.size(); ++c)
  {
    const double azimuth = cuts[c].front().azimuth;
    const double before = c > 0 ? azimuth - cuts[c - 1].front().azimuth : 0;
    const double after = c + 1 < cuts.size() ? cuts[c + 1].front().azimuth - azimuth : 0;
    const double half_step = cuts[c].size() > 1 ? (cuts[c][1].radius - cuts[c][0].radius) / 2 : 0;
    for (const fem::PressurePoint &point : cuts[c])
    {
      if (!(point.pressure > 0))
        continue;
      const double r = point.radius - contact_radius;
      rows.push_back({ point.azimuth / degree, 1e6 * r, point.pressure / unit.pascals,
                       (azimuth - overlap * before / 2) / degree, (azimuth + overlap * after / 2) / degree,
                       1e6 * (r - overlap * half_step), 1e6 * (r + overlap * half_step) });
    }
  }
  return number_rows(title,
                     { { "theta", "degrees" },
                       { "r - R", "µm" },
                       { "pressure", unit.name },
                       { "from theta", "degrees" },
                       { "to", "degrees" },
                       { "from r - R", "µm" },
                       { "to", "µm" } },
                     rows);
}

/// What the vertical axis has to show; never less than a micrometre to both sides.
std::pair<double, double> height_of(const Table &points)
{
  Extent radii;
  for (const std::size_t bound : { 5, 6 })
    for (const Cell &cell : points.columns[bound].cells)
      radii.include(std::get<double>(cell));
  const auto [least, most] = radii;
  if (least > most)
    return { -1, 1 };
  const double margin = std::max(0.05 * (most - least), most - least < 1 ? 1. : 0.);
  return { least - margin, most + margin };
}

} // namespace

Plot footprint_plot(const fem::PressureMap &footprint, double contact_radius)
{
  const double largest = largest_pressure(footprint);
  const PressureUnit unit = largest < 1e6 ? PressureUnit{ 1e3, "kPa" } : PressureUnit{ 1e6, "MPa" };
  const bool has_cells = footprint.is_grid && footprint.cuts.front().size() > 1;
  const std::string drawing = has_cells ? "plot data using 1:2:4:5:6:7:3 with boxxyerror lc palette\n"
                                        : "plot data using 1:2:3 with points pt 5 ps 0.4 lc palette\n";
  const std::string caption =
    "Pressure of the foot on the table, unrolled: along the rim and across it, R the contact radius.";
  const Table points = drawn_points(caption, drawn_cuts(footprint), contact_radius, unit);
  return { "footprint", caption,
           axis_commands("x", { quantity::axis::azimuth, false, std::pair(0., 360.) }) +
             axis_commands("y", { quantity::axis::distance_to_rim, false, height_of(points) }) +
             colour_commands("pressure (" + unit.name + ")", 0, largest / unit.pascals) +
             "set xtics 90\nunset key\nset style fill solid noborder\n" + drawing,
           data_table(points) };
}

} // namespace stemware::pipeline
