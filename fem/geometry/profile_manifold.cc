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

bool ProfileChart::within_stem(double radius) const
{
  // Same tolerance as in pull_back().
  return radius <= fillet.middle_radius * (1 + 1e-9);
}

double ProfileChart::top(double radius) const
{
  return radius < fillet.middle_radius ? fillet.middle_height : profile.topside(radius);
}

SectionPoint ProfileChart::push_forward(const ChartPoint &point) const
{
  if (point.level <= 1 || !within_stem(point.radius))
  {
    const double bottom = profile.underside(point.radius);
    return { point.radius, bottom + point.level * (top(point.radius) - bottom) };
  }
  const double height = fillet.middle_height + (point.level - 1) * (profile.height() - fillet.middle_height);
  return { point.radius * (profile.stem_surface(height) / fillet.middle_radius), height };
}

ChartPoint ProfileChart::pull_back(const SectionPoint &point) const
{
  // If the top rises outwards, points of the foot may lie above the middle of the fillet, but only outside
  // the stem. The tolerance allows for rounding of points on the stem's surface.
  if (point.height <= fillet.middle_height || point.radius > profile.stem_surface(point.height) * (1 + 1e-9))
  {
    const double bottom = profile.underside(point.radius);
    return { point.radius, (point.height - bottom) / (top(point.radius) - bottom) };
  }
  return { point.radius / (profile.stem_surface(point.height) / fillet.middle_radius),
           1 + (point.height - fillet.middle_height) / (profile.height() - fillet.middle_height) };
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

/// Returns @p point at @p height, with its distance from the axis changed from @p radius to @p other.
Point<3> moved_radially(const Point<3> &point, double radius, double other, double height)
{
  const double stretch = radius > 0 ? other / radius : 1;
  return { stretch * point[0], stretch * point[1], height };
}

} // namespace

std::unique_ptr<ChartManifold<2>> make_section_manifold(const GlassProfile &profile)
{
  return std::make_unique<StraightenedManifold<2>>(
    ProfileChart(profile),
    [](const ProfileChart &chart, const Point<2> &point) -> Point<2>
    {
      const ChartPoint straight = chart.pull_back({ point[0], point[1] });
      return { straight.radius, straight.level };
    },
    [](const ProfileChart &chart, const Point<2> &point) -> Point<2>
    {
      const SectionPoint section = chart.push_forward({ point[0], point[1] });
      return { section.radius, section.height };
    });
}

std::unique_ptr<ChartManifold<3>> make_ring_manifold(const GlassProfile &profile)
{
  return std::make_unique<StraightenedManifold<3>>(
    ProfileChart(profile),
    [](const ProfileChart &chart, const Point<3> &point) -> Point<3>
    {
      const ChartPoint straight = chart.pull_back({ std::hypot(point[0], point[1]), point[2] });
      const double azimuth = std::atan2(point[1], point[0]);
      return { straight.radius, azimuth < 0 ? azimuth + 2 * ring::pi : azimuth, straight.level };
    },
    [](const ProfileChart &chart, const Point<3> &point) -> Point<3>
    {
      const SectionPoint section = chart.push_forward({ point[0], point[2] });
      return { section.radius * std::cos(point[1]), section.radius * std::sin(point[1]), section.height };
    },
    Point<3>(0, 2 * ring::pi, 0));
}

std::unique_ptr<ChartManifold<3>> make_core_manifold(const GlassProfile &profile)
{
  return std::make_unique<StraightenedManifold<3>>(
    ProfileChart(profile),
    [](const ProfileChart &chart, const Point<3> &point) -> Point<3>
    {
      const double radius = std::hypot(point[0], point[1]);
      const ChartPoint straight = chart.pull_back({ radius, point[2] });
      return moved_radially(point, radius, straight.radius, straight.level);
    },
    [](const ProfileChart &chart, const Point<3> &point) -> Point<3>
    {
      const double radius = std::hypot(point[0], point[1]);
      const SectionPoint section = chart.push_forward({ radius, point[2] });
      return moved_radially(point, radius, section.radius, section.height);
    });
}

} // namespace stemware::fem
