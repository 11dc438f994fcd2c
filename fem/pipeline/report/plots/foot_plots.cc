#include "fem/pipeline/report/plots/foot_plots.h"

#include "fem/pipeline/report/render/table_renderers.h"

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace stemware::pipeline
{

namespace
{

constexpr double degree = boost::math::double_constants::degree;
constexpr double micrometre = 1e-6;

struct PressureUnit
{
  double pascals;
  std::string name;
};

PressureUnit unit_of(const fem::PressureMap &footprint)
{
  return fem::largest_pressure(footprint) < 1e6 ? PressureUnit{ 1e3, "kPa" } : PressureUnit{ 1e6, "MPa" };
}

/// The largest number of two easy digits that is not above @p factor: 1, 1.5, 2, ... 9.5, 10, 15 ...
double round_down(double factor)
{
  const double power = std::pow(10, std::floor(std::log10(factor)));
  return std::floor(2 * factor / power) / 2 * power;
}

/// The corners of polygons in mm, the first again at the end.
template <typename Polygon>
std::vector<std::vector<std::vector<double>>> outlines(const std::vector<Polygon> &polygons)
{
  std::vector<std::vector<std::vector<double>>> closed(polygons.size());
  for (std::size_t p = 0; p < polygons.size(); ++p)
    for (std::size_t i = 0; i <= polygons[p].size(); ++i)
    {
      const auto &corner = polygons[p][i % polygons[p].size()];
      closed[p].push_back({ 1000 * corner[0], 1000 * corner[1] });
    }
  return closed;
}

/// Largest and mean pressure and the width of the contact.
std::string measures_sentence(const fem::PressureMap &footprint, const PressureUnit &unit)
{
  const fem::FootprintMeasures measures = fem::measures_of(footprint);
  const double narrowest = measures.narrowest / micrometre, widest = measures.widest / micrometre;
  const std::string widths = widest - narrowest < 0.005 * widest
                               ? fmt::format(FMT_STRING("{:.3g} µm"), widest)
                               : fmt::format(FMT_STRING("{:.3g} µm to {:.3g} µm"), narrowest, widest);
  return fmt::format(
    FMT_STRING(" Largest pressure {:.3g} {} at θ = {:.0f}°, mean {:.3g} {}; the contact is {} "
               "wide{}."),
    format::Number{ measures.largest.pressure / unit.pascals }, unit.name, measures.largest.azimuth / degree,
    format::Number{ measures.mean / unit.pascals }, unit.name, widths,
    footprint.has_edge ? "" : ", where 99 % of the load lie");
}

/// Values in the templates of both pictures of the pressure.
PlotValues pressure_values(const fem::PressureMap &footprint)
{
  const PressureUnit unit = unit_of(footprint);
  return { { "colour_label", "pressure (" + unit.name + ")" },
           { "largest", fem::largest_pressure(footprint) / unit.pascals },
           { "is_grid", fem::has_cells(footprint) } };
}

} // namespace

FootLengths measured(const std::vector<fem::SectionPolygon> &cells, double contact_radius)
{
  FootLengths lengths;
  lengths.contact_radius = contact_radius;
  double lower = std::numeric_limits<double>::infinity(), upper = -lower; // above the contact radius
  for (const fem::SectionPolygon &cell : cells)
    for (std::size_t i = 0; i < cell.size(); ++i)
    {
      const auto &begin = cell[i], &end = cell[(i + 1) % cell.size()];
      lengths.outer_radius = std::max(lengths.outer_radius, begin[0]);
      lengths.height = std::max(lengths.height, begin[1]);
      const double before = begin[0] - contact_radius, after = end[0] - contact_radius;
      if ((before < 0) == (after < 0))
        continue;
      const double crossing = begin[1] + before / (before - after) * (end[1] - begin[1]);
      lower = std::min(lower, crossing);
      upper = std::max(upper, crossing);
    }
  lengths.thickness_at_rim = upper - lower;
  for (const fem::SectionPolygon &cell : cells)
    for (const auto &corner : cell)
      if (corner[1] > lengths.height * (1 - 1e-6))
        lengths.stem_radius = std::max(lengths.stem_radius, corner[0]);
  return lengths;
}

Plot section_plot(const std::vector<fem::SectionPolygon> &cells, const FootLengths &lengths)
{
  return plot_from("section",
                   { { "radius", 1000 * lengths.contact_radius },
                     { "edge", 1000 * lengths.outer_radius },
                     { "top", 1000 * lengths.height },
                     { "stem", 1000 * lengths.stem_radius },
                     { "thickness", 1000 * lengths.thickness_at_rim },
                     { "crown", 1000 * lengths.crown_radius } },
                   grouped_data("Section of the foot, its cells", { "r (mm)", "z (mm)" }, outlines(cells)));
}

Plot rim_plot(const FootLengths &lengths)
{
  Plot plot = plot_from("rim", { { "radius", 1000 * lengths.contact_radius },
                                 { "crown", 1000 * lengths.crown_radius },
                                 { "inner", 1000 * lengths.load_inner_radius },
                                 { "outer", 1000 * lengths.load_outer_radius } });
  if (!(lengths.crown_radius > 0))
    plot.caption = "The cells at the rim, above the table.";
  return plot;
}

Plot footprint_plot(const fem::PressureMap &footprint, double contact_radius, double largest)
{
  const PressureUnit unit = unit_of(footprint);
  std::vector<std::vector<std::vector<double>>> cuts;
  for (const auto &cut : fem::loaded_cuts(footprint))
  {
    cuts.emplace_back();
    for (const fem::PressurePoint &point : cut)
      cuts.back().push_back({ point.azimuth / degree, (point.radius - contact_radius) / micrometre,
                              point.pressure / unit.pascals });
  }
  PlotValues values = pressure_values(footprint);
  if (largest > 0)
    values.push_back({ "largest", largest / unit.pascals }); // instead of its own
  Plot plot =
    plot_from("footprint", values,
              grouped_data("Pressure of the foot on the table",
                           { "theta (degrees)", "r - R (µm)", "pressure (" + unit.name + ")" }, cuts));
  if (fem::has_cells(footprint))
    plot.caption += measures_sentence(footprint, unit);
  return plot;
}

Plot section_stress_plot(const std::vector<fem::StressedPatch> &section)
{
  constexpr double share_of_radius = 0.04, megapascal = 1e6;
  double edge = 0, top = 0, move = 0, stress = 0;
  for (const fem::StressedPatch &patch : section)
    for (const auto &row : patch)
      for (const fem::StressedPoint &point : row)
      {
        edge = std::max(edge, std::abs(point.x));
        top = std::max(top, point.z);
        move = std::max(move, std::hypot(point.move_x, point.move_z));
        stress = std::max(stress, point.von_mises);
      }
  const double magnification =
    move > 0 ? std::pow(10, std::round(std::log10(share_of_radius * edge / move))) : 1;
  std::string data =
    "# Section of the loaded foot, cell by cell\n# 1: x (mm)\n# 2: z (mm)\n# 3: x, moved (mm)\n"
    "# 4: z, moved (mm)\n# 5: stress of von Mises (MPa)\n";
  for (const fem::StressedPatch &patch : section)
  {
    for (const auto &row : patch)
    {
      for (const fem::StressedPoint &point : row)
        data += fmt::format(FMT_STRING("{:.6g} {:.6g} {:.6g} {:.6g} {:.5g}\n"), 1e3 * point.x, 1e3 * point.z,
                            1e3 * (point.x + magnification * point.move_x),
                            1e3 * (point.z + magnification * point.move_z), point.von_mises / megapascal);
      data += '\n';
    }
    data += '\n';
  }
  Plot plot =
    plot_from("section_stress",
              { { "edge", 1e3 * edge }, { "top", 1e3 * top }, { "largest", stress / megapascal } }, data);
  plot.caption = fmt::format(
    FMT_STRING(
      "The loaded foot at rest, cut along the line to the orbit's centre; displacements are drawn {:g} times "
      "larger, up to {:.2g} µm. Largest stress of von Mises {:.3g} MPa."),
    magnification, 1e6 * move, stress / megapascal);
  return plot;
}

Plot view_from_above_plot(const fem::PressureMap &footprint, const FootLengths &lengths,
                          const ring::Motion &motion)
{
  constexpr double share_of_radius = 0.12;
  const double radius = lengths.contact_radius;
  const fem::ContactWidth band = fem::loaded_band(footprint);
  const double extent = std::max({ radius - band.inner, band.outer - radius, 1e-4 * radius });
  const double magnification = std::max(1., round_down(share_of_radius * radius / extent));
  PlotValues values = pressure_values(footprint);
  values.insert(values.end(),
                { { "radius", 1000 * radius },
                  { "edge", 1000 * lengths.outer_radius },
                  { "magnification", magnification },
                  { "orbit_radius", 1000 * motion.orbit_radius },
                  { "side", motion.orbit_sense == ring::OrbitSense::counterclockwise ? 1. : -1. } });
  Plot plot = plot_from("foot_from_above", values);
  plot.caption = fmt::format(
    FMT_STRING(
      "Where the foot presses on the table before it spins, seen from above, through the glass. "
      "Distances from the rim, the thin circle, are drawn {:g} times larger; v is the direction of travel."),
    magnification);
  return plot;
}

Plot rim_circle_plot(const fem::RimCircle &circle)
{
  std::vector<std::vector<double>> rows;
  for (const fem::RimPoint &point : circle.points)
    rows.push_back({ 1e3 * point.radius, 1e6 * point.height, 1e6 * point.distance, point.weight });
  return plot_from(
    "rim_circle", { { "radius", 1e3 * circle.contact_radius }, { "crown", 1e3 * circle.crown_radius } },
    data_table(number_rows(
      "The points of the land",
      { { "r", "mm" }, { "height", "µm" }, { "distance from the circle", "µm" }, { "weight", "1" } }, rows)));
}

Plot rim_residual_plot(const fem::RimCircle &circle)
{
  Plot plot = plot_from("rim_residuals", { { "scatter", 1e6 * circle.scatter } });
  plot.caption = fmt::format(
    FMT_STRING("Distance of the points from the circle, upwards positive; the lines are at the scatter, "
               "{:.2g} µm. Points that follow a curve instead of scattering say that the land is no circle: "
               "take a smaller Glass/Land width."),
    1e6 * circle.scatter);
  return plot;
}

Plot contact_zone_plot(const std::vector<fem::Quadrilateral> &faces)
{
  return plot_from("contact_zone", {},
                   grouped_data("The faces of the contact zone", { "x (mm)", "y (mm)" }, outlines(faces)));
}

Plot quality_plot(const std::vector<double> &jacobians)
{
  constexpr unsigned int n_bins = 20;
  std::vector<double> bins, counts(n_bins, 0);
  for (unsigned int b = 0; b < n_bins; ++b)
    bins.push_back((b + 0.5) / n_bins);
  for (const double jacobian : jacobians)
  {
    const int bin = static_cast<int>(jacobian * n_bins);
    ++counts[static_cast<std::size_t>(std::clamp(bin, 0, static_cast<int>(n_bins) - 1))];
  }
  return plot_from(
    "quality", {},
    data_table({ "Scaled Jacobians of the cells",
                 { numbers("middle of the bin", "1", bins), numbers("cells", "1", counts) } }));
}

} // namespace stemware::pipeline
