#include "fem/geometry/profile_manifold.h"

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
  // The tolerance as in pull_back().
  return radius <= fillet.middle_radius * (1 + 1e-9);
}

double ProfileChart::top(double radius) const
{
  return radius < fillet.middle_radius ? fillet.middle_height : profile.topside(radius);
}

SectionPoint ProfileChart::push_forward(const StraightPoint &point) const
{
  if (point.level <= 1 || !within_stem(point.radius))
  {
    const double bottom = profile.underside(point.radius);
    return { point.radius, bottom + point.level * (top(point.radius) - bottom) };
  }
  const double height = fillet.middle_height + (point.level - 1) * (profile.height() - fillet.middle_height);
  return { point.radius * (profile.stem_surface(height) / fillet.middle_radius), height };
}

StraightPoint ProfileChart::pull_back(const SectionPoint &point) const
{
  // A top that rises outwards may be higher than the fillet's middle. The tolerance is for what rounding does
  // to points on the stem's surface.
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

class SectionManifold : public ChartManifold<2>
{
public:
  explicit SectionManifold(const ProfileChart &chart)
      : chart(chart)
  {
  }

  std::unique_ptr<Manifold<2>> clone() const override { return std::make_unique<SectionManifold>(chart); }

  Point<2> pull_back(const Point<2> &point) const override
  {
    const StraightPoint straight = chart.pull_back({ point[0], point[1] });
    return { straight.radius, straight.level };
  }

  Point<2> push_forward(const Point<2> &point) const override
  {
    const SectionPoint section = chart.push_forward({ point[0], point[1] });
    return { section.radius, section.height };
  }

private:
  const ProfileChart chart;
};

/// Chart coordinates: straight radius, azimuth, level.
class RingManifold : public ChartManifold<3>
{
public:
  explicit RingManifold(const ProfileChart &chart)
      : ChartManifold<3>(Point<3>(0, 2 * numbers::PI, 0))
      , chart(chart)
  {
  }

  std::unique_ptr<Manifold<3>> clone() const override { return std::make_unique<RingManifold>(chart); }

  Point<3> pull_back(const Point<3> &point) const override
  {
    const StraightPoint straight = chart.pull_back({ std::hypot(point[0], point[1]), point[2] });
    const double azimuth = std::atan2(point[1], point[0]);
    return { straight.radius, azimuth < 0 ? azimuth + 2 * numbers::PI : azimuth, straight.level };
  }

  Point<3> push_forward(const Point<3> &point) const override
  {
    const SectionPoint section = chart.push_forward({ point[0], point[2] });
    return { section.radius * std::cos(point[1]), section.radius * std::sin(point[1]), section.height };
  }

private:
  const ProfileChart chart;
};

/// Chart coordinates: x and y of the straightened foot, level.
class CoreManifold : public ChartManifold<3>
{
public:
  explicit CoreManifold(const ProfileChart &chart)
      : chart(chart)
  {
  }

  std::unique_ptr<Manifold<3>> clone() const override { return std::make_unique<CoreManifold>(chart); }

  Point<3> pull_back(const Point<3> &point) const override
  {
    const double radius = std::hypot(point[0], point[1]);
    const StraightPoint straight = chart.pull_back({ radius, point[2] });
    const double stretch = radius > 0 ? straight.radius / radius : 1;
    return { stretch * point[0], stretch * point[1], straight.level };
  }

  Point<3> push_forward(const Point<3> &point) const override
  {
    const double radius = std::hypot(point[0], point[1]);
    const SectionPoint section = chart.push_forward({ radius, point[2] });
    const double stretch = radius > 0 ? section.radius / radius : 1;
    return { stretch * point[0], stretch * point[1], section.height };
  }

private:
  const ProfileChart chart;
};

} // namespace

std::unique_ptr<Manifold<2>> make_section_manifold(const GlassProfile &profile)
{
  return std::make_unique<SectionManifold>(ProfileChart(profile));
}

std::unique_ptr<Manifold<3>> make_ring_manifold(const GlassProfile &profile)
{
  return std::make_unique<RingManifold>(ProfileChart(profile));
}

std::unique_ptr<Manifold<3>> make_core_manifold(const GlassProfile &profile)
{
  return std::make_unique<CoreManifold>(ProfileChart(profile));
}

} // namespace stemware::fem
