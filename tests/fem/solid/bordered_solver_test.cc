#include "tests/fem/foot_case.h"

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <gtest/gtest.h>

using namespace stemware::fem;
using namespace stemware::fem_tests;

namespace
{
/// Foot with an elliptic land (5 % narrower along y) on a mesh without coarser levels.
struct OvalFoot
{
  OvalFoot(const FootResolution &resolution, TestSolver solver, unsigned int degree)
      : triangulation(MPI_COMM_WORLD)
  {
    dealii::Triangulation<3> drawn, flat;
    make_foot_mesh(flat_profile(), resolution, drawn);
    dealii::GridGenerator::flatten_triangulation(drawn, flat);
    flat.set_all_manifold_ids(dealii::numbers::flat_manifold_id);
    dealii::GridTools::transform(
      [](const dealii::Point<3> &x) { return dealii::Point<3>(x[0], 0.95 * x[1], x[2]); }, flat);
    triangulation.copy_triangulation(flat);
    SolidOptions options;
    options.degree = degree;
    options.straight_edges = true;
    const SolidGap flat_land = [](double, double) { return 0.; };
    body = make_body(solver, triangulation, flat_land, options);
    body->set_linear_tolerance(1e-11);
  }

  NewtonIncrement press()
  {
    const ContactSurface &surface = body->contact_surface();
    const auto mat = make_law(WinklerInterface(1e11), surface);
    ContactForces contact;
    mat->evaluate(Eigen::VectorXd::Constant(surface.n_nodes(), -1e-6), contact);
    const LinearConditions conditions = prescribed_resultants(surface, load_at(0.9));
    return body->solve(contact.tangent, contact.forces, conditions, Eigen::Vector3d::Zero());
  }

  dealii::parallel::distributed::Triangulation<3> triangulation;
  std::unique_ptr<SolidBody> body;
};
} // namespace

TEST(LinearSolver, AggregationMultigridAgreesWithTheFactorisation)
{
  const FootResolution resolution = { 48, 4, 4, 0 };
  OvalFoot direct(resolution, TestSolver::factors, 1);
  OvalFoot multigrid(resolution, TestSolver::multigrid, 1);
  EXPECT_FALSE(multigrid.body->has_coarser_mesh());
  expect_equal(multigrid.press(), direct.press());
}

/// The iterations reduce the residual by the factor 1e-11. If the cells are halved, a smoother without a
/// coarse grid would need twice as many iterations.
TEST(LinearSolver, IterationsHardlyGrowWithRefinementAndDegree)
{
  OvalFoot coarse({ 48, 4, 4, 0 }, TestSolver::multigrid, 1);
  OvalFoot fine({ 48, 4, 4, 1 }, TestSolver::multigrid, 1);
  OvalFoot quadratic({ 48, 4, 4, 0 }, TestSolver::multigrid, 2);
  const unsigned int before = coarse.press().linear_iterations;
  EXPECT_LE(before, 50u);
  EXPECT_LE(fine.press().linear_iterations, before + 15);
  EXPECT_LE(quadratic.press().linear_iterations, before + 20);
}
