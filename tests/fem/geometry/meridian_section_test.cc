#include "fem/geometry/foot_mesh.h"
#include "fem/geometry/meridian_section.h"
#include "fem/geometry/section_view.h"
#include "ring_model/load/constants.h"
#include "tests/fem/geometry/profile_oracle.h"
#include "tests/fem/revolution/revolution_case.h"
#include "tests/ulps.h"

#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/grid_tools.h>

#include <gtest/gtest.h>

#include <algorithm>

using stemware::ulps;
using stemware::ring::pi;
using namespace stemware::revolution_tests;
using namespace stemware::fem_tests;

namespace
{

using Polyline = std::vector<SectionVertex>;

/// Returns the polyline through @p points [mm]. The first point is on line 2 of its file.
Polyline in_millimetres(const std::vector<std::pair<double, double>> &points)
{
  Polyline polyline;
  for (const auto &[radius, height] : points)
    polyline.push_back({ radius / 1000, height / 1000, static_cast<unsigned int>(polyline.size()) + 2 });
  return polyline;
}

/// Points (r, z) [mm] from the axis to the stem cut, with a flat land from 28 to 32 mm and corners of more
/// than 0.2 rad.
const std::vector<std::pair<double, double>> plain_foot = { { 0, 2 },  { 20, 2 }, { 28, 0 }, { 32, 0 },
                                                            { 34, 1 }, { 34, 3 }, { 16, 4 }, { 6, 8 },
                                                            { 4, 16 }, { 0, 16 } };

/// Returns the area between polyline and axis [m^2] and the volume of the glass [m^3], as sums over trapezia
/// and frusta.
std::pair<double, double> area_and_volume(const Polyline &polyline)
{
  double area = 0, volume = 0;
  for (std::size_t i = 1; i < polyline.size(); ++i)
  {
    const double a = polyline[i - 1].radius, b = polyline[i].radius;
    const double rise = polyline[i].height - polyline[i - 1].height;
    area += rise * (a + b) / 2;
    volume += rise * pi * (a * a + a * b + b * b) / 3;
  }
  return { area, volume };
}

GlassProfile drawn(const Polyline &polyline)
{
  GlassProfile profile;
  profile.shape = GlassShape::profile;
  profile.section = std::make_shared<MeridianSection>(polyline);
  return profile;
}

std::string refusal_of(const std::vector<std::pair<double, double>> &points)
{
  try
  {
    MeridianSection section(in_millimetres(points));
  }
  catch (const std::invalid_argument &error)
  {
    return error.what();
  }
  return {};
}

std::string refusal_with(std::size_t index, double radius, double height)
{
  std::vector<std::pair<double, double>> points = plain_foot;
  points[index] = { radius, height };
  return refusal_of(points);
}

} // namespace

TEST(MeridianSection, FindsUndersideTopAndStemOfAPolylineInEitherPointOrder)
{
  std::vector<std::pair<double, double>> lifted = plain_foot; // heights are measured from the lowest point
  for (auto &point : lifted)
    point.second += 7;
  for (const bool reversed : { false, true })
  {
    Polyline polyline = in_millimetres(lifted);
    if (reversed)
      std::reverse(polyline.begin(), polyline.end());
    const MeridianSection section(polyline);
    EXPECT_NEAR(section.underside(0.010), 0.002, ulps(15, 0.034));
    EXPECT_NEAR(section.underside(0.024), 0.001, ulps(15, 0.034));
    EXPECT_NEAR(section.underside(0.030), 0, ulps(15, 0.034));
    EXPECT_NEAR(section.topside(0.025), 0.0035, ulps(15, 0.034));
    EXPECT_NEAR(section.topside(0.011), 0.006, ulps(15, 0.034));
    EXPECT_NEAR(section.stem_surface(0.012), 0.005, ulps(15, 0.034));
    EXPECT_NEAR(section.middle_radius(), 0.006, ulps(15, 0.034));
    EXPECT_NEAR(section.middle_height(), 0.008, ulps(15, 0.034));
    EXPECT_NEAR(section.outer_radius(), 0.034, ulps(15, 0.034));
    EXPECT_NEAR(section.height(), 0.016, ulps(15, 0.034));
  }
}

TEST(MeridianSection, TruncatesASharpEdge)
{
  // The wedge at the edge is 3.2 mm thick at r = 32 mm and sharp at 36 mm. At the lowest point, the foot is 4
  // mm thick. The edge is cut off where the wedge is 0.2 mm thick, a twentieth of 4 mm.
  const MeridianSection section(in_millimetres(
    { { 0, 2 }, { 30, 0 }, { 32, 0.8 }, { 36, 2.4 }, { 32, 4 }, { 5, 4 }, { 5, 12 }, { 0, 12 } }));
  EXPECT_NEAR(section.topside(0.030) - section.underside(0.030), 0.004, ulps(16, 0.03));
  EXPECT_NEAR(section.outer_radius(), 0.036 - 0.004 * 0.2 / 3.2, 1e-12);
}

TEST(MeridianSection, RedundantPointsHardlyChangeTheProfile)
{
  Polyline dense;
  const Polyline corners = in_millimetres(plain_foot);
  for (std::size_t i = 1; i < corners.size(); ++i)
    for (unsigned int j = 0; j < 1000; ++j)
    {
      const double share = j / 1000.;
      dense.push_back({ (1 - share) * corners[i - 1].radius + share * corners[i].radius,
                        (1 - share) * corners[i - 1].height + share * corners[i].height + 1e-8 * (j % 3),
                        2 });
    }
  dense.push_back(corners.back());
  dense[dense.size() - 1001].height = corners.back().height;
  const MeridianSection section(dense), plain(corners);
  for (const double radius : { 0.001, 0.013, 0.027, 0.031, 0.033 })
    EXPECT_NEAR(section.underside(radius), plain.underside(radius), 4e-7) << radius;
  for (const double radius : { 0.007, 0.02, 0.033 })
    EXPECT_NEAR(section.topside(radius), plain.topside(radius), 4e-7) << radius;
}

TEST(MeridianSection, RefusesInvalidPolylinesAndNamesTheLineOfTheFile)
{
  EXPECT_EQ(refusal_of(plain_foot), "");
  const auto expect_line = [](const std::string &sentence, const std::string &words)
  { EXPECT_NE(sentence.find(words), std::string::npos) << sentence; };
  std::vector<std::pair<double, double>> points(plain_foot.begin(), plain_foot.end() - 1);
  expect_line(refusal_of(points), "line 10");
  points.assign(plain_foot.begin() + 1, plain_foot.end());
  expect_line(refusal_of(points), "line 2");
  points = plain_foot; // upside down
  for (auto &point : points)
    point.second = -point.second;
  expect_line(refusal_of(points), "line 11");
  points.assign(plain_foot.begin(), plain_foot.begin() + 3);
  expect_line(refusal_of(points), "3 points");

  expect_line(refusal_with(1, 29, 2), "line 4");   // the underside turns back
  expect_line(refusal_with(1, 20, 6), "(line 3)"); // the underside crosses the top
  EXPECT_NE(refusal_with(6, 40, 4), "");
  expect_line(refusal_with(7, 18, 3.5), "line 9"); // the outside of the stem turns back
  EXPECT_NE(refusal_with(8, 4, 15), "");           // the stem cut is not horizontal
  expect_line(refusal_with(1, -20, 2), "line 3");  // a radius is negative
}

TEST(DrawnProfile, MeshHasTheAreaAndVolumeOfThePolygon)
{
  const Polyline polyline = in_millimetres(plain_foot);
  const GlassProfile profile = drawn(polyline);
  const auto [area, volume] = area_and_volume(polyline);
  for (const double size : { 0., 1e-4 })
  {
    MeridianResolution resolution;
    resolution.focus_size = size;
    dealii::Triangulation<2> section;
    make_meridian_mesh(profile, resolution, section);
    EXPECT_NEAR(dealii::GridTools::volume(section) / area, 1, 1e-12);
    double drawn_area = 0;
    for (const SectionPolygon &cell : section_cells(section))
      for (std::size_t i = 0; i < cell.size(); ++i)
      {
        const auto &a = cell[i], &b = cell[(i + 1) % cell.size()];
        drawn_area += (a[0] * b[1] - b[0] * a[1]) / 2;
      }
    EXPECT_NEAR(drawn_area / area, 1, 1e-12);
  }
  dealii::Triangulation<3> solid;
  make_foot_mesh(profile, { 48, 8, 4 }, solid);
  // The cells do not resolve the corners of the polygon.
  EXPECT_NEAR(dealii::GridTools::volume(solid, dealii::MappingQ<3>(3)) / volume, 1, 5e-3);
}

TEST(SectionCells, OfASolidMeshHaveTheAreaOfTheProfile)
{
  GlassProfile step;
  dealii::Triangulation<3> solid;
  make_foot_mesh(step, { 48, 4, 2 }, solid);
  double area = 0;
  for (const SectionPolygon &cell : section_cells(solid, 0.02))
    for (std::size_t i = 0; i < cell.size(); ++i)
    {
      const auto &a = cell[i], &b = cell[(i + 1) % cell.size()];
      area += (a[0] * b[1] - b[0] * a[1]) / 2;
    }
  // Edges are chords of 7.5 degrees, so the radii are up to 0.2 % too small.
  EXPECT_NEAR(area, 0.004 * 0.001 + 0.034 * 0.004 + 0.005 * 0.010, 3e-3 * area);
}

TEST(DrawnProfile, LandIsFlattenedWithAGradualTransitionAndMustContainTheLowestPoint)
{
  // The rim has a radius of 3 mm at r = 30 mm. At the borders of a land of 1 mm, the underside is more than
  // 0.04 mm above the lowest point.
  std::vector<std::pair<double, double>> points = { { 0, 3 }, { 20, 3 } };
  for (int i = -10; i <= 10; ++i)
    points.emplace_back(30 + 0.2 * i, 3 - std::sqrt(9 - 0.04 * i * i));
  points.insert(points.end(), { { 34, 2 }, { 34, 4 }, { 6, 8 }, { 5, 16 }, { 0, 16 } });
  GlassProfile profile = drawn(in_millimetres(points));
  profile.land_width = 0.001;
  profile.validate();
  const double risen = profile.section->underside(0.0305);
  EXPECT_GT(risen, 4e-5);
  EXPECT_EQ(profile.underside(0.0295), 0);
  EXPECT_EQ(profile.underside(0.0305), 0);
  EXPECT_NEAR(profile.underside(0.03075), profile.section->underside(0.03075) - risen / 2, ulps(16, 0.03));
  EXPECT_NEAR(profile.underside(0.031), profile.section->underside(0.031), ulps(16, 0.03));
  EXPECT_NEAR(profile.underside(0.025), profile.section->underside(0.025), ulps(16, 0.03));

  profile.contact_radius = 0.0306;
  EXPECT_THROW(profile.validate(), std::invalid_argument);
}
