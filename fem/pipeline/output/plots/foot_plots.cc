#include "fem/pipeline/output/plots/foot_plots.h"

#include "fem/pipeline/output/render/plot_script.h"

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <limits>

namespace stemware::pipeline
{

namespace
{

/// Pictures are in mm; what would begin with zeros there is said in µm.
std::string length_text(double length)
{
  return length < 1e-4 ? fmt::format(FMT_STRING("{:.3g} µm"), 1e6 * length)
                       : fmt::format(FMT_STRING("{:.4g} mm"), 1000 * length);
}

/// One polygon a block, as gnuplot's filledcurves takes them, with heights raised by @p lift(radius).
std::string polygons(const std::string &title, const std::vector<fem::SectionPolygon> &cells,
                     const std::function<double(double)> &lift)
{
  std::string data = "# " + title + "\n# 1: r (mm)\n# 2: z (mm)\n";
  for (const fem::SectionPolygon &cell : cells)
  {
    for (std::size_t i = 0; i <= cell.size(); ++i)
    {
      const auto &[radius, height] = cell[i % cell.size()];
      data += fmt::format(FMT_STRING("{:.6g} {:.6g}\n"), 1000 * radius, 1000 * (height + lift(radius)));
    }
    data += '\n';
  }
  return data;
}

/// Extent of a cell along one coordinate [m].
Extent extent_of(const fem::SectionPolygon &cell, unsigned int coordinate)
{
  Extent extent;
  for (const auto &corner : cell)
    extent.include(corner[coordinate]);
  return extent;
}

/// An arrow with two heads between two points, in mm, and what stands at it.
std::string dimension(double x1, double y1, double x2, double y2, const std::string &text, double text_x,
                      double text_y, const std::string &alignment)
{
  return fmt::format(FMT_STRING("set arrow from {:.5g},{:.5g} to {:.5g},{:.5g} heads size screen 0.008,20 "
                                "filled front lw 0.8 lc rgb \"#333333\"\n"
                                "set label \"{}\" at {:.5g},{:.5g} {} front font \",13\"\n"),
                     x1, y1, x2, y2, text, text_x, text_y, alignment);
}

/// A thin line of the drawing, in mm.
std::string thin_line(double x1, double y1, double x2, double y2, const std::string &dashes)
{
  return fmt::format(FMT_STRING("set arrow from {:.5g},{:.5g} to {:.5g},{:.5g} nohead lw 0.6 dt {} lc rgb "
                                "\"#777777\"\n"),
                     x1, y1, x2, y2, dashes);
}

constexpr char no_axes[] = "unset border; unset tics; unset grid; unset key\n"
                           "set lmargin 0; set rmargin 0; set tmargin 0; set bmargin 0\n";
constexpr char glass_style[] = "set style fill solid 1.0 border lc rgb \"#4a8fc0\"\n"
                               "plot data with filledcurves closed fc rgb \"#dcebf7\" lw 0.5\n";

/// The largest number of two easy digits that is not above @p factor: 1, 1.5, 2, ... 9.5, 10, 15 ...
double round_down(double factor)
{
  const double power = std::pow(10, std::floor(std::log10(factor)));
  return std::floor(2 * factor / power) / 2 * power;
}

} // namespace

FootLengths measured(const std::vector<fem::SectionPolygon> &cells, double contact_radius)
{
  FootLengths lengths;
  lengths.contact_radius = contact_radius;
  Extent radii, heights, at_rim;
  for (const fem::SectionPolygon &cell : cells)
    for (std::size_t i = 0; i < cell.size(); ++i)
    {
      const auto &begin = cell[i], &end = cell[(i + 1) % cell.size()];
      radii.include(begin[0]);
      heights.include(begin[1]);
      const double before = begin[0] - contact_radius, after = end[0] - contact_radius;
      if ((before < 0) != (after < 0))
        at_rim.include(begin[1] + before / (before - after) * (end[1] - begin[1]));
    }
  lengths.outer_radius = radii.most;
  lengths.height = heights.most;
  lengths.thickness_at_rim = at_rim.most - at_rim.least;
  return lengths;
}

std::pair<double, double> loaded_band(const fem::PressureMap &footprint)
{
  Extent radii;
  for (const auto &cut : footprint.cuts)
    if (const auto width = has_cells(footprint) ? fem::contact_width(cut, footprint.has_edge) : std::nullopt)
    {
      radii.include(width->inner);
      radii.include(width->outer);
    }
    else if (!has_cells(footprint))
      for (const fem::PressurePoint &point : cut)
        if (point.pressure > 0)
          radii.include(point.radius);
  return { radii.least, radii.most };
}

Plot section_plot(const std::vector<fem::SectionPolygon> &cells, const FootLengths &lengths)
{
  const double r = 1000 * lengths.contact_radius, edge = 1000 * lengths.outer_radius,
               top = 1000 * lengths.height, thickness = 1000 * lengths.thickness_at_rim;
  double stem = 0; // radius of the cut
  for (const fem::SectionPolygon &cell : cells)
    for (const auto &corner : cell)
      if (corner[1] > lengths.height * (1 - 1e-6))
        stem = std::max(stem, 1000 * corner[0]);
  const double row = 0.075 * edge; // between two lines of lengths
  std::string script = no_axes;
  script += fmt::format(FMT_STRING("set size ratio -1\nset xrange [{:.5g}:{:.5g}]; set yrange "
                                   "[{:.5g}:{:.5g}]\n"),
                        -0.06 * edge, 1.34 * edge, -2.6 * row, top + 1.3 * row);
  script += thin_line(-0.05 * edge, 0, 1.1 * edge, 0, "1") +
            thin_line(0, -2.4 * row, 0, top + row, "(12,4,2,4)") + thin_line(r, 0, r, -1.1 * row, "1") +
            thin_line(edge, 0, edge, -2.1 * row, "1") + thin_line(stem, top, 1.14 * edge, top, "(2,4)");
  script +=
    dimension(0, -row, r, -row, "R = " + length_text(lengths.contact_radius), r / 2, -0.62 * row, "center") +
    dimension(0, -2 * row, edge, -2 * row, "foot " + length_text(lengths.outer_radius), r / 2, -1.62 * row,
              "center") +
    dimension(1.12 * edge, 0, 1.12 * edge, top, length_text(lengths.height), 1.135 * edge, top / 2, "left") +
    dimension(r, 0, r, thickness, length_text(lengths.thickness_at_rim), r, thickness + 0.5 * row, "center");
  script += fmt::format(FMT_STRING("set label \"cut, held\" at {:.5g},{:.5g} left front font \",13\"\n"),
                        0.03 * edge, top + 0.55 * row);
  script += fmt::format(FMT_STRING("set arrow from 0,{0:.5g} to {1:.5g},{0:.5g} nohead front lw 3 lc rgb "
                                   "\"#333333\"\n"),
                        top, stem);
  script += fmt::format(FMT_STRING("set label \"table\" at {:.5g},{:.5g} left font \",13\"\n"), 1.03 * edge,
                        -0.5 * row);
  if (lengths.crown_radius > 0)
    script += fmt::format(FMT_STRING("set label \"crown {}\" at {:.5g},{:.5g} left font \",13\"\n"),
                          length_text(lengths.crown_radius), edge + 0.4 * row, -1.9 * row);
  const std::string caption = "Section of the foot with its cells, whose edges are drawn straight.";
  return { "section",
           caption,
           script + glass_style,
           polygons(caption, cells, [](double) { return 0.; }),
           540,
           540 * (top + 3.9 * row) / (1.4 * edge) };
}

Plot rim_plot(const std::vector<fem::SectionPolygon> &cells, const FootLengths &lengths)
{
  const double radius = lengths.contact_radius;
  // Three times the loaded band, to both sides of it.
  const double reach =
    3 * std::max({ radius - lengths.load_inner_radius, lengths.load_outer_radius - radius, 3e-4 * radius });
  std::vector<fem::SectionPolygon> near;
  for (const fem::SectionPolygon &cell : cells)
    if (const Extent r = extent_of(cell, 0); r.least < radius + reach && r.most > radius - reach)
      if (extent_of(cell, 1).least < reach)
        near.push_back(cell);
  const auto crown = [&](double r)
  { return lengths.crown_radius > 0 ? std::pow(r - radius, 2) / (2 * lengths.crown_radius) : 0.; };
  const double r = 1000 * radius, inner = 1000 * lengths.load_inner_radius,
               outer = 1000 * lengths.load_outer_radius, width = 1000 * reach;
  const std::string caption = lengths.crown_radius > 0
                                ? "The cells at the rim with the rounding of its crown, above the table."
                                : "The cells at the rim, above the table.";
  std::string script = no_axes;
  script +=
    fmt::format(FMT_STRING("set size ratio -1\nset xrange [{:.6g}:{:.6g}]; set yrange [{:.6g}:{:.6g}]\n"),
                r - width, r + width, -0.4 * width, 0.7 * width);
  script +=
    thin_line(r - width, 0, r + width, 0, "1") + thin_line(r, -0.2 * width, r, 0.65 * width, "(12,4,2,4)");
  script += fmt::format(
    FMT_STRING("set arrow from {:.6g},0 to {:.6g},0 nohead front lw 4 lc rgb \"#d55e00\"\n"), inner, outer);
  script += dimension(inner, -0.16 * width, outer, -0.16 * width,
                      "under load " + length_text((outer - inner) / 1000), r, -0.28 * width, "center");
  script += fmt::format(FMT_STRING("set label \"table\" at {:.6g},{:.6g} left font \",13\"\n"),
                        r - 0.98 * width, -0.07 * width);
  return { "rim", caption, script + glass_style, polygons(caption, near, crown), 540, 297 };
}

Plot view_from_below_plot(const fem::PressureMap &footprint, const FootLengths &lengths,
                          const ring::Motion &motion)
{
  constexpr double share_of_radius = 0.12;
  const double radius = lengths.contact_radius;
  const double largest = largest_pressure(footprint);
  const auto [inner, outer] = loaded_band(footprint);
  const double extent = std::max({ radius - inner, outer - radius, 1e-4 * radius });
  const double magnification = std::max(1., round_down(share_of_radius * radius / extent));
  const bool in_kilopascals = largest < 1e6;
  const double unit = in_kilopascals ? 1e3 : 1e6;
  const std::string pressure = std::string("pressure (") + (in_kilopascals ? "kPa" : "MPa") + ")";
  const std::string caption = fmt::format(
    FMT_STRING("The foot seen from below before it spins: where it presses on the table. Distances from the "
               "rim, the thin circle, are drawn {:g} times larger; v is the direction of travel."),
    magnification);

  // Seen from below y points downwards.
  std::string data = "# " + caption + "\n# 1: x (mm)\n# 2: -y (mm)\n# 3: " + pressure + "\n";
  for (const auto &cut : drawn_cuts(footprint))
  {
    for (const fem::PressurePoint &point : cut)
    {
      const double drawn = radius + magnification * (point.radius - radius);
      data += fmt::format(FMT_STRING("{:.5g} {:.5g} {}\n"), 1000 * drawn * std::cos(point.azimuth),
                          -1000 * drawn * std::sin(point.azimuth), to_short_text(point.pressure / unit));
    }
    data += '\n';
  }

  const double r = 1000 * radius, edge = 1000 * lengths.outer_radius;
  const double half = std::max(1.05 * edge, 1.2 * r);
  // The orbit's centre lies to the left, at +y, where the orbit runs counter-clockwise seen from above.
  const double side = motion.orbit_sense == ring::OrbitSense::counterclockwise ? -1 : 1;
  std::string script = no_axes;
  script +=
    "set lmargin at screen 0.02; set rmargin at screen 0.80; set bmargin at screen 0.02; set tmargin at "
    "screen 0.98\n";
  script += fmt::format(FMT_STRING("set size ratio -1\nset xrange [{0:.5g}:{1:.5g}]; set yrange "
                                   "[{0:.5g}:{1:.5g}]\nset view map\n"),
                        -half, half);
  // In a view of three dimensions places are those of the screen.
  script +=
    colour_commands(pressure, 0, largest / unit) +
    "set rmargin at screen 0.78\nset colorbox user origin screen 0.80, screen 0.10 size screen 0.03, screen "
    "0.80\nset label 1 \"" +
    pressure + "\" at screen 0.97, screen 0.5 rotate by 90 center\n";
  script += fmt::format(FMT_STRING("set object 1 circle at 0,0 size {:.5g} back fs empty border lc rgb "
                                   "\"#4a8fc0\" lw 1.5\n"
                                   "set object 2 circle at 0,0 size {:.5g} front fs empty border lc rgb "
                                   "\"#777777\" lw 0.6\n"),
                        edge, r);
  script += fmt::format(FMT_STRING("set arrow from 0,0 to {:.5g},0 front lw 2 lc rgb \"#333333\"\n"
                                   "set label \"v\" at {:.5g},0 left front\n"),
                        0.45 * r, 0.48 * r);
  script +=
    fmt::format(FMT_STRING("set arrow from 0,0 to 0,{:.5g} front lw 1 dt (6,4) lc rgb \"#333333\"\n"
                           "set label \"to the orbit's centre,\\n{} from here\" at 0,{:.5g} center "
                           "front font \",13\"\n"),
                side * 0.36 * r, length_text(motion.orbit_radius), side * (side > 0 ? 0.54 : 0.44) * r);
  script += has_cells(footprint) ? "splot data using 1:2:3 with pm3d\n"
                                 : "splot data using 1:2:3 with points pt 5 ps 0.5 lc palette\n";
  return { "foot_from_below", caption, script, data, 540, 430 };
}

} // namespace stemware::pipeline
