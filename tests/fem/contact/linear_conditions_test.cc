// Conditions L'f = t on the nodal forces f with weights L that differ from the motion modes Q, as in a moment
// balance with a friction arm. Reference: fixed-point iteration over prescribed resultants.
#include "fem/contact/rigid_foot.h"
#include "fem/contact/sliding_traction.h"
#include "tests/fem/foot_case.h"
#include "tests/fem/revolution/revolution_case.h"

#include <gtest/gtest.h>

using namespace stemware::revolution_tests;

namespace
{

/// Returns x and y components of the friction per normal force at the nodes, shape [n_nodes, 2].
Eigen::MatrixX2d friction_per_force(const ContactSurface &surface)
{
  const SlidingTraction traction{ 0.25, -11. };
  Eigen::MatrixX2d result(surface.n_nodes(), 2);
  for (Eigen::Index i = 0; i < result.rows(); ++i)
  {
    const double azimuth = std::atan2(surface.node_position(i, 1), surface.node_position(i, 0));
    const Eigen::Vector2d polar = traction.direction(surface.node_position.row(i).norm(), azimuth);
    result.row(i) << polar(0) * std::cos(azimuth) - polar(1) * std::sin(azimuth),
      polar(0) * std::sin(azimuth) + polar(1) * std::cos(azimuth);
  }
  return result;
}

constexpr double arm = 0.05;

/// Prescribed moments sum x f + arm T_x(f) and sum y f + arm T_y(f) of the forces f and friction T [N m].
const Eigen::Vector2d prescribed(-0.010, 0.012);

LinearConditions friction_arm_conditions(const ContactSurface &surface)
{
  Eigen::MatrixX3d weights = surface.motion_modes();
  weights.rightCols<2>() += arm * friction_per_force(surface);
  return LinearConditions(surface, weights, { weight, prescribed(0), prescribed(1) });
}

double norm(const ContactSurface &surface, const Eigen::VectorXd &forces)
{
  return std::sqrt(surface.parts.sum(forces.squaredNorm()));
}

/// Returns the limit of a fixed-point iteration: the prescribed resultants of each contact solution are
/// corrected by the friction moment of the previous solution.
ContactSolution by_fixed_point(ElasticBody &body, TableLaw &law)
{
  const ContactSurface &surface = body.contact_surface();
  const Eigen::MatrixX2d friction = friction_per_force(surface);
  Eigen::Vector2d target = prescribed;
  ContactSolution solution;
  for (unsigned int i = 0; i < 60; ++i)
  {
    const ContactStart before = from(solution);
    solution = solve_contact(body, law, Resultants{ weight, target(1), -target(0) }, 0.03, {},
                             i > 0 ? &before : nullptr);
    const Eigen::Vector2d next = prescribed - arm * surface.parts.sum(friction.transpose() * solution.forces);
    if ((next - target).norm() < 1e-12 * weight * 0.03)
      return solution;
    target = next;
  }
  ADD_FAILURE() << "the fixed-point iteration did not converge";
  return solution;
}

void expect_fixed_point(ElasticBody &body, TableLaw &law)
{
  const ContactSurface &surface = body.contact_surface();
  const LinearConditions conditions = friction_arm_conditions(surface);
  ASSERT_FALSE(conditions.are_resultants());
  const ContactSolution solution = solve_contact(body, law, conditions, 0.03);
  EXPECT_LT(conditions.residual(solution.forces, solution.motion).norm(), 1e-10 * weight);
  const ContactSolution expected = by_fixed_point(body, law);
  EXPECT_LT(norm(surface, solution.forces - expected.forces), 1e-8 * norm(surface, expected.forces));
  EXPECT_LT((solution.motion - expected.motion).norm(), 1e-8 * expected.motion.norm());
  EXPECT_LE(solution.n_iterations, 12u);
  const ContactSolution without =
    solve_contact(body, law, Resultants{ weight, prescribed(1), -prescribed(0) }, 0.03);
  EXPECT_GT(norm(surface, solution.forces - without.forces), 0.1 * norm(surface, expected.forces));
}

} // namespace

TEST(LinearConditions, AgreeWithTheFixedPointIterationUnderARigidFoot)
{
  const FootCase foot(GlassProfile(), { 24, 4, 1 });
  RigidFoot rigid(foot.body->contact_surface());
  const auto law = make_law(WinklerInterface(1e10), rigid.contact_surface());
  expect_fixed_point(rigid, *law);
}

TEST(LinearConditions, AgreeWithTheFixedPointIterationUnderASolidFoot)
{
  for (const TestSolver solver : { TestSolver::factors, TestSolver::multigrid })
  {
    SolidOptions options;
    options.degree = 1;
    FootCase foot(GlassProfile(), { 12, 4, 1 }, options, solver);
    const auto law = make_law(WinklerInterface(1e10), foot.body->contact_surface());
    expect_fixed_point(*foot.body, *law);
  }
}

TEST(LinearConditions, AgreeWithTheFixedPointIterationUnderABodyOfRevolution)
{
  const GlassProfile profile;
  RevolutionCase foot(profile, foot_compliance(profile, graded_cells(), MeridianOptions{ 2, 16 }), 64);
  const auto law = make_law(WinklerInterface(1e11), foot.body.contact_surface());
  expect_fixed_point(foot.body, *law);
  foot.body.set_sliding(SlidingTraction{ 0.25, -11. });
  expect_fixed_point(foot.body, *law);
}

TEST(LinearConditions, AreRefusedIfInvalidAndEndInTippingIfImpossible)
{
  const FootCase foot(GlassProfile(), { 12, 2, 1 });
  RigidFoot rigid(foot.body->contact_surface());
  const ContactSurface &surface = rigid.contact_surface();
  const Eigen::MatrixX3d modes = surface.motion_modes();
  EXPECT_THROW(LinearConditions(surface, Eigen::MatrixX3d::Ones(modes.rows() + 1, 3), { 1, 0, 0 }),
               std::invalid_argument);
  EXPECT_THROW(LinearConditions(surface, 2 * modes, { 1, 0, 0 }), std::invalid_argument);
  EXPECT_THROW(LinearConditions(surface, modes, { 0, 0, 0 }), std::invalid_argument);
  EXPECT_THROW(LinearConditions(surface, modes, { 1, std::nan(""), 0 }), std::invalid_argument);
  // Under compressive forces, the force-weighted mean of the weights (here 0.2) cannot exceed the largest
  // weight (here 0.13).
  const auto law = make_law(WinklerInterface(1e10), surface);
  Eigen::MatrixX3d shifted = modes;
  shifted.col(1).array() += 0.1;
  const LinearConditions impossible(surface, shifted, { 1, 0.2, 0 });
  EXPECT_EQ(outcome_of([&] { solve_contact(rigid, *law, impossible, 0.03); }), ContactOutcome::tipping);
}
