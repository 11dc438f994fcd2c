#include "fem/pipeline/output/plots/rim_fit_plots.h"

#include "fem/pipeline/output/render/plot_script.h"

#include <cmath>
#include <fmt/format.h>

namespace stemware::pipeline
{

namespace
{

/// Points that count fully, and those near the land's border that count less, as curves of @p value [m] in µm
/// over r in mm.
std::vector<Curve> point_curves(const fem::RimCircle &circle, double fem::RimPoint::*value)
{
  Curve full = { "points" }, less = { "points that count less" };
  full.style = less.style = CurveStyle::points;
  full.line_type = less.line_type = 2;
  less.is_hollow = true;
  for (const fem::RimPoint &point : circle.points)
    (point.weight < 1 ? less : full).add(1e3 * point.radius, 1e6 * (point.*value));
  std::vector<Curve> curves;
  for (const Curve &curve : { full, less })
    if (!curve.x.empty())
      curves.push_back(curve);
  return curves;
}

/// Least and largest radius of the points [m].
Extent extent_of(const fem::RimCircle &circle)
{
  Extent radii;
  for (const fem::RimPoint &point : circle.points)
    radii.include(point.radius);
  return radii;
}

} // namespace

Plot rim_circle_plot(const fem::RimCircle &circle)
{
  constexpr unsigned int n_intervals = 100;
  const Extent radii = extent_of(circle);
  Curve arc = { "circle" };
  arc.line_type = 1;
  for (unsigned int i = 0; i <= n_intervals; ++i)
  {
    const double radius = radii.least + (radii.most - radii.least) * i / n_intervals;
    const double share = (radius - circle.contact_radius) / circle.crown_radius;
    if (std::abs(share) <= 1)
      arc.add(1e3 * radius, 1e6 * circle.crown_radius * (1 - std::sqrt(1 - share * share)));
  }
  CurvePlot plot = { "rim_circle",
                     "The points of the land and the circle through them: the crown.",
                     { "r (mm)" },
                     { "height (µm)" },
                     { arc } };
  for (const Curve &curve : point_curves(circle, &fem::RimPoint::height))
    plot.curves.push_back(curve);
  return curve_plot(plot);
}

Plot rim_residual_plot(const fem::RimCircle &circle)
{
  const Extent radii = extent_of(circle);
  CurvePlot plot = { "rim_residuals",
                     fmt::format(FMT_STRING("Distance of the points from the circle, upwards positive; the "
                                            "lines are at the scatter, {:.2g} µm. Points that follow a curve "
                                            "instead of scattering say that the land is no circle: take a "
                                            "smaller Glass/Land width."),
                                 1e6 * circle.scatter),
                     { "r (mm)" },
                     { "distance (µm)" },
                     point_curves(circle, &fem::RimPoint::distance) };
  for (const double at : { -circle.scatter, 0., circle.scatter })
  {
    Curve line = { "", { 1e3 * radii.least, 1e3 * radii.most }, { 1e6 * at, 1e6 * at } };
    line.line_type = 1;
    plot.curves.push_back(line);
  }
  return curve_plot(plot);
}

} // namespace stemware::pipeline
