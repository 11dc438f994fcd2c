#include "fem/pipeline/output/render/gnuplot.h"
#include "fem/pipeline/output/render/plot_script.h"
#include "fem/pipeline/output/render/table_renderers.h"
#include "fem/pipeline/support/numbers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace stemware::pipeline
{

namespace
{

/// Where one cell of a map ends and the next begins: half-way between their values on the axis.
std::vector<double> cell_bounds(const std::vector<double> &values, bool logarithmic)
{
  const auto middle = [=](double a, double b) { return logarithmic ? std::sqrt(a * b) : (a + b) / 2; };
  const auto beyond = [=](double edge, double bound)
  { return logarithmic ? edge * edge / bound : 2 * edge - bound; };
  if (values.size() == 1)
    return { logarithmic ? values[0] / 2 : values[0] - 0.5, logarithmic ? values[0] * 2 : values[0] + 0.5 };
  std::vector<double> bounds = { 0 };
  for (std::size_t i = 1; i < values.size(); ++i)
    bounds.push_back(middle(values[i - 1], values[i]));
  bounds.front() = beyond(values.front(), bounds[1]);
  bounds.push_back(beyond(values.back(), bounds.back()));
  return bounds;
}

/// An empty line after every @p n_columns rows, at which gnuplot ends a line of a grid.
std::string with_grid_lines(const std::string &table, std::size_t n_columns)
{
  std::istringstream lines(table);
  std::string grid;
  std::size_t n_rows = 0;
  for (std::string line; std::getline(lines, line);)
  {
    grid += line + '\n';
    if (line[0] != '#' && ++n_rows % n_columns == 0)
      grid += '\n';
  }
  return grid;
}

/// The range of colours for what could be computed; a width of its own for a single value.
std::pair<double, double> colour_range(const ValueMap &map)
{
  Extent colours;
  for (const std::vector<double> &row : map.values)
    for (const double value : row)
      colours.include(value);
  const auto [least, most] = colours;
  if (least > most)
    return { 0, 1 };
  const double margin = least < most ? 0 : std::max(1e-6 * std::abs(least), 1e-300);
  return { least - margin, most + margin };
}

} // namespace

Plot map_plot(const ValueMap &map)
{
  const std::vector<double> x = cell_bounds(map.x_values, map.x.logarithmic);
  const std::vector<double> y = cell_bounds(map.y_values, map.y.logarithmic);
  std::vector<std::vector<double>> rows;
  for (std::size_t j = 0; j < map.y_values.size(); ++j)
    for (std::size_t i = 0; i < map.x_values.size(); ++i)
      rows.push_back(
        { map.x_values[i], map.y_values[j], map.values.at(j).at(i), x[i], x[i + 1], y[j], y[j + 1] });
  const Table table = number_rows(map.caption,
                                  { { map.x.label, "x" },
                                    { map.y.label, "y" },
                                    { map.quantity, "value" },
                                    { "left bound of the cell", "x" },
                                    { "right bound", "x" },
                                    { "lower bound", "y" },
                                    { "upper bound", "y" } },
                                  rows);
  Axis x_axis = map.x, y_axis = map.y;
  x_axis.range = std::pair(x.front(), x.back());
  y_axis.range = std::pair(y.front(), y.back());
  const auto [least, most] = colour_range(map);
  std::string logscales;
  for (const auto &[which, axis] : { std::pair("x", map.x), std::pair("y", map.y) })
    if (axis.logarithmic)
      logscales += std::string("set logscale ") + which + "\n";
  const std::string contours =
    R"gp(# Contour lines first: the table of their points would heed the formats of the axes.
set contour base; unset surface; set cntrparam levels auto 8
set table $contours
splot data using 1:2:3 notitle
unset table
)gp";
  const std::string drawing = R"gp(unset grid; unset key; set border 15; set tics out
set style fill solid noborder
plot data using 1:2:4:5:6:7:3 with boxxyerror lc palette, \
     $contours using 1:2 with lines lc rgb "#ffffff" lw 1.2 dt 1
)gp";
  const std::string script = logscales + contours + axis_commands("x", x_axis) + axis_commands("y", y_axis) +
                             colour_commands(map.quantity, least, most) + drawing;
  return { map.name, map.caption, script, with_grid_lines(data_table(table), map.x_values.size()), 540, 380 };
}

Plot tornado_plot(const std::string &name, const std::string &caption, const std::string &quantity,
                  std::vector<Sensitivity> sensitivities)
{
  const auto reach = [](const Sensitivity &item)
  { return std::max(std::abs(item.low), std::abs(item.high)); };
  std::stable_sort(sensitivities.begin(), sensitivities.end(),
                   [&](const auto &a, const auto &b) { return reach(a) < reach(b); });
  std::vector<double> place, low, high;
  std::string tics;
  for (const Sensitivity &item : sensitivities)
  {
    place.push_back(static_cast<double>(place.size()) + 1);
    low.push_back(item.low);
    high.push_back(item.high);
    tics += (tics.empty() ? "" : ", ") + gnuplot_text(item.parameter) + " " + to_text(place.back());
  }
  const double widest = sensitivities.empty() ? 0 : reach(sensitivities.back());
  const std::string script = "set xlabel " + gnuplot_text(quantity) + "\n" +
                             tic_commands("x", -widest, widest) + "set ytics (" + tics +
                             ")\nset yrange [0.4:" + std::to_string(sensitivities.size()) + R"gp(.6]
unset border; set border 1; set grid noytics; set xzeroaxis; set yzeroaxis lt 7
set key at screen 0.98, screen 0.97 right top horizontal width 1; set tmargin 3
set style fill solid noborder
plot data using (0):1:(0):2:($1 - 0.35):($1 + 0.35) with boxxyerror lt 1 title "parameter down", \
     data using (0):1:(0):3:($1 - 0.35):($1 + 0.35) with boxxyerror lt 2 title "parameter up"
)gp";
  return { name,
           caption,
           script,
           data_table(
             { caption,
               { numbers("place from below", "1", place), numbers("change when it goes down", quantity, low),
                 numbers("change when it goes up", quantity, high) } }),
           540,
           120 + 40. * static_cast<double>(sensitivities.size()) };
}

} // namespace stemware::pipeline
