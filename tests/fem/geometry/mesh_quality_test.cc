#include "fem/geometry/foot_mesh.h"
#include "fem/geometry/mesh_io.h"
#include "fem/geometry/mesh_quality.h"
#include "ring_model/load/constants.h"
#include "tests/fem/vtu_file.h"
#include "tests/ulps.h"

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

using stemware::ring::pi;
using namespace dealii;
using namespace stemware::fem;
using namespace stemware::fem_tests;

namespace
{

/// Returns check_mesh() of a unit cube with each vertex moved by @p move. The bottom is the contact zone.
template <typename Move>
MeshCheck check_cube(const Move &move)
{
  Triangulation<3> cube;
  GridGenerator::hyper_cube(cube);
  cube.begin_active()->face(4)->set_boundary_id(2); // bottom of the cube
  cube.begin_active()->face(5)->set_boundary_id(1);
  GridTools::transform(move, cube);
  return check_mesh(cube);
}

double sectors_area(const GlassProfile &profile, unsigned int n_sectors)
{
  const double inner = profile.land_inner_radius(), outer = profile.land_outer_radius();
  return 0.5 * n_sectors * std::sin(2 * pi / n_sectors) * (outer * outer - inner * inner);
}

} // namespace

TEST(MeshCheck, ReportsScaledJacobiansAndCountsInvertedCells)
{
  const MeshCheck brick = check_cube([](const Point<3> &x) { return Point<3>(2 * x[0], 3 * x[1], x[2]); });
  EXPECT_NEAR(brick.min_jacobian, 1, stemware::ulps(5, 1));
  EXPECT_EQ(brick.n_inverted, 0u);
  // The scaled Jacobian of a parallelepiped is the sine of the angle between its edges.
  const MeshCheck sheared =
    check_cube([](const Point<3> &x) { return Point<3>(x[0] + std::sqrt(3.) * x[2], x[1], x[2]); });
  EXPECT_NEAR(sheared.min_jacobian, 0.5, stemware::ulps(9, 0.5));
  EXPECT_NEAR(sheared.mean_jacobian, 0.5, stemware::ulps(9, 0.5));
  const MeshCheck folded = check_cube([](const Point<3> &x) { return x.norm() > 1.7 ? -1. * x : x; });
  EXPECT_EQ(folded.n_inverted, 1u);
  EXPECT_LT(folded.min_jacobian, 0);
}

TEST(MeshCheck, ReportsContactAreaDimensionsAndQualityOfAGeneratedFoot)
{
  Triangulation<3> foot;
  const GlassProfile profile;
  make_foot_mesh(profile, { 24, 4, 1 }, foot);
  const MeshCheck check = check_mesh(foot);
  EXPECT_EQ(check.n_faces.at(2), 24u * 4u);
  EXPECT_NEAR(check.contact_area / sectors_area(profile, 24), 1, 1e-12);
  EXPECT_NEAR(check.inner_radius, profile.land_inner_radius(), 1e-12);
  EXPECT_NEAR(check.outer_radius, profile.land_outer_radius(), 1e-12);
  EXPECT_NEAR(check.upper[2], profile.height(), 1e-12);
  EXPECT_GT(check.min_jacobian, 0.1);
  EXPECT_EQ(check.upward_share, 0);
}

TEST(MeshWriter, VtuFileIsReproducibleAndContainsVerticesJacobiansAndBoundaryIds)
{
  Triangulation<3> foot;
  make_foot_mesh(GlassProfile(), { 8, 2, 1 }, foot);
  std::ostringstream first, second;
  write_mesh_vtu(foot, first);
  write_mesh_vtu(foot, second);
  EXPECT_EQ(first.str(), second.str());
  EXPECT_EQ(first.str().rfind("<?xml", 0), 0u);
  const VtuFile file(first.str());
  ASSERT_EQ(file.n_cells(), foot.n_active_cells());
  const std::vector<double> jacobians = scaled_jacobians(foot);
  for (const auto &cell : foot.active_cell_iterators())
  {
    const unsigned int c = cell->active_cell_index();
    EXPECT_NEAR(file.array("scaled_jacobian")[8 * c], jacobians[c], 1e-6);
    for (unsigned int d = 0; d < 3; ++d)
      EXPECT_NEAR(file.array("points")[24 * c + d], cell->vertex(0)[d], 1e-8);
  }
  EXPECT_EQ(*std::max_element(file.array("boundary_id").begin(), file.array("boundary_id").end()), 2);
}
