#include "fem/geometry/foot_mesh.h"
#include "tests/fem/geometry/profile_oracle.h"
#include "tests/fem/revolution/revolution_case.h"
#include "tests/ulps.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/grid_tools.h>

#include <gtest/gtest.h>

using namespace stemware::revolution_tests;
using namespace stemware::fem_tests;

namespace
{

struct Measures
{
  double area = 0;
  double contact_length = 0;
};

Measures measure(const dealii::Triangulation<2> &triangulation)
{
  Measures result;
  for (const auto &cell : triangulation.active_cell_iterators())
  {
    result.area += cell->measure();
    for (const auto &face : cell->face_iterators())
      if (face->at_boundary() && face->boundary_id() == static_cast<unsigned int>(FootBoundary::contact_zone))
        result.contact_length += face->measure();
  }
  return result;
}

} // namespace

TEST(MeridianMesh, HasTheAreaAndTheLandWidthOfTheStepProfile)
{
  const GlassProfile profile;
  for (const double size : { 0., 1e-4 })
  {
    MeridianResolution resolution;
    resolution.focus_size = size;
    dealii::Triangulation<2> triangulation;
    make_meridian_mesh(profile, resolution, triangulation);
    const Measures measures = measure(triangulation);
    const double expected = profile.land_width * profile.land_height +
                            profile.foot_radius * profile.foot_thickness +
                            profile.stem_radius * profile.stem_height;
    EXPECT_NEAR(measures.area / expected, 1, 1e-12);
    EXPECT_NEAR(measures.contact_length / profile.land_width, 1, 1e-12);
  }
}

TEST(MeridianMesh, BoundaryPointsLieOnTheProfileOfAFoot)
{
  const GlassProfile profile = foot_profile();
  for (const double size : { 0., 1e-5 })
  {
    MeridianResolution resolution;
    resolution.refinements = 3;
    resolution.focus_size = size;
    dealii::Triangulation<2> triangulation;
    make_meridian_mesh(profile, resolution, triangulation);
    for (const unsigned int degree : { 1u, 2u, 3u, 4u })
    {
      const dealii::MappingQ<2> mapping(degree);
      const dealii::QGaussLobatto<1> edge_points(degree + 1);
      dealii::FE_Nothing<2> nothing;
      dealii::FEFaceValues<2> values(mapping, nothing, edge_points, dealii::update_quadrature_points);
      for (const auto &cell : triangulation.active_cell_iterators())
        for (const unsigned int f : cell->face_indices())
        {
          if (!cell->at_boundary(f))
            continue;
          values.reinit(cell, f);
          for (const dealii::Point<2> &point : values.get_quadrature_points())
            ASSERT_LT(distance_from_profile(profile, point[0], point[1]),
                      stemware::ulps(140, profile.foot_radius))
              << "degree " << degree << " at " << point;
        }
    }
  }
}

/// The area enclosed by curves through Gauss-Lobatto points of degree p converges at the order 2 p.
TEST(MeridianMesh, AreaConvergesAtTwiceTheDegreeOfTheGeometry)
{
  const GlassProfile profile = foot_profile();
  const double exact = integral_over_section(profile, [](double) { return 1.; });
  for (const unsigned int degree : { 1u, 2u, 3u })
  {
    double before = 0;
    for (const unsigned int refinements : { 2u, 3u })
    {
      dealii::Triangulation<2> triangulation;
      make_meridian_mesh(profile, graded_cells(refinements), triangulation);
      const double error =
        std::abs(1 - dealii::GridTools::volume(triangulation, dealii::MappingQ<2>(degree)) / exact);
      if (before > 0)
      {
        EXPECT_NEAR(std::log2(before / error), 2 * degree, 0.1 * degree) << "degree " << degree;
      }
      before = error;
    }
  }
}

/// Without a fillet, the bottom of the stem and the top of the foot have the same height except for rounding.
/// The difference must not create a row of sliver cells.
TEST(MeridianMesh, AvoidsSliverCellsAtASharpCorner)
{
  for (const double stem_radius : { 0.004, 0.0045, 0.005, 0.0061, 0.0074774, 0.00761733 })
  {
    GlassProfile profile;
    profile.shape = GlassShape::foot;
    profile.stem_radius = stem_radius;
    profile.fillet_radius = 0;
    dealii::Triangulation<2> triangulation;
    make_meridian_mesh(profile, MeridianResolution(), triangulation);
    for (const auto &cell : triangulation.active_cell_iterators())
      EXPECT_GT(cell->minimum_vertex_distance(), 1e-6) << "at " << cell->center();
  }
}

TEST(MeridianMesh, RefusesInvalidResolutionsAndDiscs)
{
  dealii::Triangulation<2> triangulation;
  MeridianResolution resolution;
  resolution.land_cells = 3;
  EXPECT_THROW(make_meridian_mesh(GlassProfile(), resolution, triangulation), std::invalid_argument);
  TableDisc disc;
  disc.radius = 0.02;
  EXPECT_THROW(make_meridian_mesh(disc, GlassProfile(), MeridianResolution(), triangulation),
               std::invalid_argument);
}
