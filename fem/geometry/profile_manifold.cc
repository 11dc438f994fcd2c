#include "fem/geometry/profile_manifold.h"

#include "ring_model/load/constants.h"

#include <deal.II/grid/manifold.h>

#include <cmath>

namespace stemware::fem
{

using namespace dealii;

ProfileChart::ProfileChart(const GlassProfile &profile)
    : profile(profile)
    , fillet(profile.fillet())
{
}

double ProfileChart::top(double radius) const
{
  return radius < fillet.middle_radius ? fillet.middle_height : profile.topside(radius);
}

Point<2> ProfileChart::push_forward(const Point<2> &point) const
{
  const double radius = point[0], level = point[1];
  if (level <= 1 || radius > fillet.middle_radius * (1 + 1e-9)) // the tolerance of pull_back()
  {
    const double bottom = profile.underside(radius);
    return { radius, bottom + level * (top(radius) - bottom) };
  }
  const double height = fillet.middle_height + (level - 1) * (profile.height() - fillet.middle_height);
  return { radius * (profile.stem_surface(height) / fillet.middle_radius), height };
}

Point<2> ProfileChart::pull_back(const Point<2> &point) const
{
  const double radius = point[0], height = point[1];
  // If the top rises outwards, points of the foot may lie above the middle of the fillet, but only outside
  // the stem. The tolerance allows for rounding of points on the stem's surface.
  if (height <= fillet.middle_height || radius > profile.stem_surface(height) * (1 + 1e-9))
  {
    const double bottom = profile.underside(radius);
    return { radius, (height - bottom) / (top(radius) - bottom) };
  }
  return { radius / (profile.stem_surface(height) / fillet.middle_radius),
           1 + (height - fillet.middle_height) / (profile.height() - fillet.middle_height) };
}

namespace
{

/// Manifold whose geodesics are straight lines in the coordinates of ProfileChart.
template <int dim>
class StraightenedManifold : public ChartManifold<dim>
{
public:
  using Map = Point<dim> (*)(const ProfileChart &, const Point<dim> &);

  StraightenedManifold(const ProfileChart &chart, Map to_chart, Map from_chart,
                       const Tensor<1, dim> &periodicity = {})
      : ChartManifold<dim>(periodicity)
      , chart(chart)
      , to_chart(to_chart)
      , from_chart(from_chart)
  {
  }

  std::unique_ptr<Manifold<dim>> clone() const override
  {
    return std::make_unique<StraightenedManifold>(chart, to_chart, from_chart, this->get_periodicity());
  }
  Point<dim> pull_back(const Point<dim> &point) const override { return to_chart(chart, point); }
  Point<dim> push_forward(const Point<dim> &point) const override { return from_chart(chart, point); }

private:
  const ProfileChart chart;
  const Map to_chart, from_chart;
};

/// Returns @p point with its distance from the axis and its height changed to those of @p section, from the
/// distance @p radius.
Point<3> moved_to(const Point<2> &section, const Point<3> &point, double radius)
{
  const double stretch = radius > 0 ? section[0] / radius : 1;
  return { stretch * point[0], stretch * point[1], section[1] };
}

} // namespace

std::unique_ptr<ChartManifold<2>> make_section_manifold(const GlassProfile &profile)
{
  return std::make_unique<StraightenedManifold<2>>(
    ProfileChart(profile),
    [](const ProfileChart &chart, const Point<2> &point) { return chart.pull_back(point); },
    [](const ProfileChart &chart, const Point<2> &point) { return chart.push_forward(point); });
}

std::unique_ptr<ChartManifold<3>> make_ring_manifold(const GlassProfile &profile)
{
  return std::make_unique<StraightenedManifold<3>>(
    ProfileChart(profile),
    [](const ProfileChart &chart, const Point<3> &point) -> Point<3>
    {
      const Point<2> straight = chart.pull_back({ std::hypot(point[0], point[1]), point[2] });
      const double azimuth = std::atan2(point[1], point[0]);
      return { straight[0], azimuth < 0 ? azimuth + 2 * ring::pi : azimuth, straight[1] };
    },
    [](const ProfileChart &chart, const Point<3> &point) -> Point<3>
    {
      const Point<2> section = chart.push_forward({ point[0], point[2] });
      return { section[0] * std::cos(point[1]), section[0] * std::sin(point[1]), section[1] };
    },
    Point<3>(0, 2 * ring::pi, 0));
}

std::unique_ptr<ChartManifold<3>> make_core_manifold(const GlassProfile &profile)
{
  return std::make_unique<StraightenedManifold<3>>(
    ProfileChart(profile),
    [](const ProfileChart &chart, const Point<3> &point)
    {
      const double radius = std::hypot(point[0], point[1]);
      return moved_to(chart.pull_back({ radius, point[2] }), point, radius);
    },
    [](const ProfileChart &chart, const Point<3> &point)
    {
      const double radius = std::hypot(point[0], point[1]);
      return moved_to(chart.push_forward({ radius, point[2] }), point, radius);
    });
}

} // namespace stemware::fem
