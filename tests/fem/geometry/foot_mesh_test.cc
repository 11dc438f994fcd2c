#include "ring_model/load/constants.h"
#include "tests/fem/foot_case.h"
#include "tests/fem/geometry/profile_oracle.h"
#include "tests/ulps.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/grid_tools.h>

#include <gtest/gtest.h>

using stemware::ulps;
using stemware::ring::pi;
using namespace dealii;
using namespace stemware::fem;
using namespace stemware::fem_tests;

namespace
{
double land_area_error(GlassShape shape, unsigned int n_sectors, unsigned int degree)
{
  GlassProfile profile;
  profile.shape = shape;
  SolidOptions options;
  options.degree = degree;
  const FootCase foot(profile, { n_sectors, 2, 1 }, options);
  const double exact = pi * (profile.land_outer_radius() * profile.land_outer_radius() -
                             profile.land_inner_radius() * profile.land_inner_radius());
  return 1 - foot.body->contact_surface().area() / exact;
}
} // namespace

TEST(FootMesh, VerticesLieOnTheProfileOfAFootAndTheVolumeConverges)
{
  const GlassProfile profile = foot_profile();
  const double exact = integral_over_section(profile, [](double radius) { return 2 * pi * radius; });
  std::array<double, 2> before{};
  for (const unsigned int refinements : { 0u, 1u, 2u })
  {
    Triangulation<3> triangulation;
    make_foot_mesh(profile, { 24, 2, 1 }, triangulation);
    triangulation.refine_global(refinements);
    for (const auto &face : triangulation.active_face_iterators())
      if (face->at_boundary())
        for (const unsigned int v : face->vertex_indices())
        {
          const Point<3> &vertex = face->vertex(v);
          ASSERT_LT(distance_from_profile(profile, std::hypot(vertex[0], vertex[1]), vertex[2]),
                    ulps(140, profile.foot_radius));
        }
    for (const unsigned int degree : { 1u, 2u })
    {
      const double error = std::abs(1 - GridTools::volume(triangulation, MappingQ<3>(degree)) / exact);
      if (refinements > 0)
      {
        EXPECT_GT(std::log2(before[degree - 1] / error), 1.9 * degree) << "degree " << degree;
      }
      before[degree - 1] = error;
    }
  }
}

TEST(FootMesh, LandIsAPolygonWithLinearAndRoundWithQuadraticElements)
{
  // Chords between 24 points cut off 1 - sin(15 deg) / (15 deg in radians) = 1.138 % of the land's area.
  for (const GlassShape shape : { GlassShape::step, GlassShape::foot })
  {
    EXPECT_NEAR(land_area_error(shape, 24, 1), 1 - std::sin(pi / 12) / (pi / 12), 1e-12);
    EXPECT_LT(std::abs(land_area_error(shape, 24, 2)), 2e-5);
  }
}

TEST(FootMesh, CellsAreWellShaped)
{
  for (const unsigned int n_sectors : { 8u, 12u, 24u, 28u, 48u })
  {
    Triangulation<3> triangulation;
    make_foot_mesh(GlassProfile(), { n_sectors, 4, 2 }, triangulation);
    const MappingQ<3> mapping(2);
    const auto ratios = GridTools::compute_aspect_ratio_of_cells(mapping, triangulation, QGauss<3>(3));
    EXPECT_LT(ratios.linfty_norm(), n_sectors < 24 ? 40 : 12) << n_sectors; // infinite if a cell is inverted
    Triangulation<3> foot;
    make_foot_mesh(foot_profile(), { n_sectors, 4, 2 }, foot);
    const auto foot_ratios = GridTools::compute_aspect_ratio_of_cells(mapping, foot, QGauss<3>(3));
    EXPECT_LT(foot_ratios.linfty_norm(), n_sectors < 24 ? 45 : 15) << n_sectors;
  }
}

class FootMeshOfShape : public testing::TestWithParam<GlassShape>
{
};

INSTANTIATE_TEST_SUITE_P(Shapes, FootMeshOfShape, testing::Values(GlassShape::step, GlassShape::foot),
                         [](const auto &info) { return info.param == GlassShape::step ? "step" : "foot"; });

TEST_P(FootMeshOfShape, BoundaryIdsMarkLandAndStemCut)
{
  GlassProfile profile;
  profile.shape = GetParam();
  profile.underside_rise = 0; // the whole underside then has the height 0 of the land
  Triangulation<3> triangulation;
  make_foot_mesh(profile, { 16, 4, 1 }, triangulation);
  unsigned int n_land = 0;
  unsigned int n_cut = 0;
  for (const auto &face : triangulation.active_face_iterators())
  {
    if (!face->at_boundary())
      continue;
    const Point<3> centre = face->center();
    const double radius = std::hypot(centre[0], centre[1]);
    if (face->boundary_id() == static_cast<types::boundary_id>(FootBoundary::contact_zone))
    {
      ++n_land;
      EXPECT_NEAR(centre[2], 0, ulps(310, profile.height()));
      EXPECT_GT(radius, 0.97 * profile.land_inner_radius());
      EXPECT_LT(radius, profile.land_outer_radius());
    }
    if (face->boundary_id() == static_cast<types::boundary_id>(FootBoundary::stem_cut))
    {
      ++n_cut;
      EXPECT_NEAR(centre[2], profile.height(), ulps(310, profile.height()));
    }
  }
  EXPECT_EQ(n_land, 16u * 4u);
  EXPECT_EQ(n_cut, 16u + 16u); // core of 4 x 4 cells and the ring around the core
}

/// p4est requires consistent edge orientations in a coarse mesh, but checks them in debug builds only.
TEST_P(FootMeshOfShape, CellsHaveConsistentEdgeOrientations)
{
  GlassProfile profile;
  profile.shape = GetParam();
  for (const unsigned int n_sectors : { 12u, 28u, 48u })
  {
    Triangulation<3> triangulation;
    make_foot_mesh(profile, { n_sectors, 4, 2 }, triangulation);
    for (const auto &cell : triangulation.active_cell_iterators())
      for (const unsigned int l : cell->line_indices())
        ASSERT_TRUE(cell->line_orientation(l)) << n_sectors << " sectors, cell " << cell->index();
  }
}

TEST(FootMesh, RefusesImpossibleResolutions)
{
  EXPECT_THROW(FootResolution({ 6, 4, 2 }).validate(), std::invalid_argument);
  EXPECT_THROW(FootResolution({ 26, 4, 2 }).validate(), std::invalid_argument);
  EXPECT_THROW(FootResolution({ 24, 3, 2 }).validate(), std::invalid_argument);
  EXPECT_THROW(FootResolution({ 24, 4, 0 }).validate(), std::invalid_argument);
}
