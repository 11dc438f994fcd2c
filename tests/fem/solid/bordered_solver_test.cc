#include "tests/fem/foot_case.h"

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

/// Conjugate-gradient iterations with the whole land on the mat.
unsigned int multigrid_iterations(const FootResolution &resolution)
{
  FootCase foot(flat_profile(), resolution, solver(LinearSolver::multigrid, 1));
  const ContactSurface &surface = foot.body->contact_surface();
  const auto mat = make_law(WinklerInterface(1e10), surface);
  ContactForces contact;
  mat->evaluate(Eigen::VectorXd::Constant(surface.n_nodes(), -1e-6), contact);
  const LinearConditions conditions = prescribed_resultants(surface, load_at(0.3));
  return foot.body->solve(contact.tangent, contact.forces, conditions, Eigen::Vector3d::Zero())
    .linear_iterations;
}
} // namespace

TEST(LinearSolver, MultigridAndFactorisationAgree)
{
  for (const unsigned int degree : { 1u, 2u })
  {
    FootCase direct(flat_profile(), { 12, 2, 1 }, solver(LinearSolver::direct, degree));
    FootCase multigrid(flat_profile(), { 12, 2, 1 }, solver(LinearSolver::multigrid, degree));
    const LoadHarmonics left = direct.solve_on_winkler(1e11, load_at(1.3));
    const LoadHarmonics right = multigrid.solve_on_winkler(1e11, load_at(1.3));
    for (unsigned int n = 0; n <= 8; ++n)
      EXPECT_NEAR(left.a[0][n] / left.a[0][0], right.a[0][n] / right.a[0][0], 1e-8)
        << "Q" << degree << ", n = " << n;
  }
}

/// With a wrong near-null space (zero vectors, say) multigrid needs about 400 iterations here.
TEST(LinearSolver, MultigridKnowsTheRigidBodyModes)
{
  EXPECT_LT(multigrid_iterations({ 24, 4, 2 }), 120u);
  EXPECT_LT(multigrid_iterations({ 48, 8, 4 }), 120u);
}
