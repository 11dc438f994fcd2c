#include "tests/fem/foot_case.h"

#include <deal.II/grid/grid_generator.h>

#include <gtest/gtest.h>

using namespace stemware::fem;
using namespace stemware::fem_tests;

namespace
{
SolidOptions solver(LinearSolver kind, unsigned int degree)
{
  SolidOptions options;
  options.degree = degree;
  options.linear_solver = kind;
  return options;
}

/// The land as an ellipse, 5 % narrower along y, from a file without the meshes that it was refined from.
struct OvalFoot
{
  OvalFoot(const FootResolution &resolution, LinearSolver kind, unsigned int degree)
      : triangulation(MPI_COMM_WORLD)
  {
    dealii::Triangulation<3> drawn, flat;
    make_foot_mesh(flat_profile(), resolution, drawn);
    dealii::GridGenerator::flatten_triangulation(drawn, flat);
    flat.set_all_manifold_ids(dealii::numbers::flat_manifold_id);
    dealii::GridTools::transform(
      [](const dealii::Point<3> &x) { return dealii::Point<3>(x[0], 0.95 * x[1], x[2]); }, flat);
    triangulation.copy_triangulation(flat);
    SolidOptions options = solver(kind, degree);
    options.straight_edges = true;
    options.linear_tolerance = 1e-11;
    body = std::make_unique<SolidBody>(
      triangulation, ElasticMaterial(), [](double, double) { return 0.; }, options);
  }

  /// The answer to a moment, with the whole land on the mat.
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

/// With meshes too large for the coarsest level to be factorised, which the mean body of revolution helps.
TEST(LinearSolver, AMeshFromAFileIsSolvedWithItsMeanBodyOfRevolution)
{
  const FootResolution resolution = { 48, 4, 4, 0 };
  OvalFoot direct(resolution, LinearSolver::direct, 1);
  OvalFoot multigrid(resolution, LinearSolver::multigrid, 1);
  ASSERT_GT(multigrid.body->n_unknowns(), 10000u);
  EXPECT_FALSE(multigrid.body->has_coarser_mesh());
  const NewtonIncrement expected = direct.press(), found = multigrid.press();
  const double largest = expected.displacement.lpNorm<Eigen::Infinity>();
  EXPECT_LT((found.displacement - expected.displacement).lpNorm<Eigen::Infinity>(), 1e-8 * largest);
  EXPECT_LT((found.motion - expected.motion).norm(), 1e-8 * expected.motion.norm());
  EXPECT_NEAR(found.energy_curvature / expected.energy_curvature, 1, 1e-8);
}

/// To a residual of 1e-11; what the smoother alone needs doubles with half the cell size.
TEST(LinearSolver, ItsIterationsHardlyGrow)
{
  OvalFoot coarse({ 48, 4, 4, 0 }, LinearSolver::multigrid, 1);
  OvalFoot fine({ 48, 4, 4, 1 }, LinearSolver::multigrid, 1);
  OvalFoot quadratic({ 48, 4, 4, 0 }, LinearSolver::multigrid, 2);
  const unsigned int before = coarse.press().linear_iterations;
  EXPECT_LE(before, 50u);
  EXPECT_LE(fine.press().linear_iterations, before + 15);
  EXPECT_LE(quadratic.press().linear_iterations, before + 20);
}

/// Friction of a foot that spins in its place twists it on its stem, which the load of a table hardly does.
TEST(LinearSolver, FrictionThatTwistsTheFootTakesFewMoreIterations)
{
  OvalFoot foot({ 48, 4, 4, 0 }, LinearSolver::multigrid, 1);
  const unsigned int without = foot.press().linear_iterations;
  SlidingTraction spinning;
  spinning.friction_coefficient = 1e-6; // next to nothing for the pressure
  spinning.spin_per_speed = 1e6;
  foot.body->set_sliding(spinning);
  EXPECT_LE(foot.press().linear_iterations, 7 * without / 4);
}
