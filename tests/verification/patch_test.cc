// For nu = 0, a uniform vertical stress in a cylinder under a central load is the exact solution.
#include "fem/contact/hard_interface.h"
#include "ring_model/load/constants.h"
#include "tests/fem/foot_case.h"

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

#include <gtest/gtest.h>

using stemware::ring::pi;
using namespace dealii;
using namespace stemware::fem;
using namespace stemware::fem_tests;

namespace
{

void make_cylinder(Triangulation<3> &triangulation)
{
  Triangulation<3> lying;
  GridGenerator::cylinder(lying, 0.02, 0.015);
  GridTools::rotate(Point<3>::unit_vector(1), pi / 2, lying);
  GridTools::shift(Point<3>(0, 0, 0.015), lying);
  triangulation.copy_triangulation(lying);
  triangulation.set_manifold(0, CylindricalManifold<3>(2));
  triangulation.refine_global(1);
  for (const auto &face : triangulation.active_face_iterators())
    if (face->at_boundary())
    {
      const double z = face->center()[2];
      face->set_boundary_id(z < 1e-9 ? 2 : z > 0.03 - 1e-9 ? 1 : 0);
    }
}

class Patch : public ::testing::TestWithParam<unsigned int>
{
protected:
  Patch()
      : triangulation(MPI_COMM_WORLD)
  {
    make_cylinder(triangulation);
    SolidOptions options;
    options.degree = GetParam();
    const ElasticMaterial stiff_without_transverse_strain{ 70e9, 0 };
    body = make_body( // direct solver: only rounding errors remain
      TestSolver::factors, triangulation, [](double, double) { return 0.; }, options,
      stiff_without_transverse_strain);
  }

  /// Returns the largest relative deviation of the nodal pressure (force / node area) from weight / area.
  double nonuniformity(const ContactSolution &solution) const
  {
    const ContactSurface &surface = body->contact_surface();
    const Eigen::ArrayXd pressure = solution.forces.array() / surface.node_area.array();
    return (pressure * surface.area() / weight - 1).abs().maxCoeff();
  }

  parallel::distributed::Triangulation<3> triangulation;
  std::unique_ptr<SolidBody> body;
};

} // namespace

TEST_P(Patch, PressureOnAMatIsUniformAndSettlementIsExact)
{
  const auto mat = make_law(WinklerInterface(1e10), body->contact_surface());
  const ContactSolution solution = solve_contact(*body, *mat, load_at(0), 0.02);
  EXPECT_LT(nonuniformity(solution), 1e-12);
  // The table moves by the shortening of the cylinder plus the penetration of the mat.
  const double pressure = weight / body->contact_surface().area();
  EXPECT_NEAR(solution.motion(0) / (-pressure * (0.03 / 70e9 + 1 / 1e10)), 1, 1e-10);
}

/// The gap is exactly 0. A solver that stores the gap as a constraint value and finds contact nodes by
/// non-zero values would fail.
TEST_P(Patch, PressureOnAHardTableIsUniformAndSettlementIsExact)
{
  const auto table = HardInterface().make(body->contact_surface(), 70e9 / body->contact_cell_size());
  const ContactSolution solution = solve_contact(*body, *table, load_at(0), 0.02);
  EXPECT_LT(nonuniformity(solution), 1e-12);
  const double pressure = weight / body->contact_surface().area();
  EXPECT_NEAR(solution.motion(0) / (-pressure * 0.03 / 70e9), 1, 1e-10);
  EXPECT_LT(solution.normal_displacement.cwiseAbs().maxCoeff(), 1e-10 * std::abs(solution.motion(0)));
}

INSTANTIATE_TEST_SUITE_P(Degree, Patch, ::testing::Values(1u, 2u),
                         [](const auto &info) { return "Q" + std::to_string(info.param); });
