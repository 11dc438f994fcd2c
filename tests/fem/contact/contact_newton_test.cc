#include "fem/contact/hard_interface.h"
#include "fem/contact/rigid_foot.h"
#include "tests/fem/foot_case.h"

#include <gtest/gtest.h>

using namespace stemware::fem;
using namespace stemware::fem_tests;

namespace
{

SolidOptions linear_elements()
{
  SolidOptions options;
  options.degree = 1;
  return options;
}

const FootResolution coarse{ 12, 4, 1 };

ContactOutcome outcome_on_mat(FootCase &foot, const Resultants &load, const ContactControl &control)
{
  const auto mat = make_law(WinklerInterface(1e11), foot.body->contact_surface());
  return outcome_of([&] { solve_contact(*foot.body, *mat, load, 0.03, control); });
}

class StuckBody : public RigidFoot
{
public:
  using RigidFoot::RigidFoot;
  NewtonIncrement solve(const Eigen::SparseMatrix<double> &, const Eigen::VectorXd &,
                        const LinearConditions &, const Eigen::Vector3d &) override
  {
    NewtonIncrement step;
    step.displacement = Eigen::VectorXd::Zero(contact_surface().n_nodes());
    step.motion.setZero();
    return step;
  }
  double equilibrium_residual(const Eigen::VectorXd &) const override { return 0.5; }
};

} // namespace

TEST(ContactDriver, ReportsTippingOnlyUnderTooLargeAMoment)
{
  FootCase foot(GlassProfile(), coarse, linear_elements());
  EXPECT_EQ(outcome_on_mat(foot, load_at(2.2), {}), ContactOutcome::tipping);
  EXPECT_EQ(outcome_on_mat(foot, load_at(1.9), {}), ContactOutcome::converged);
}

TEST(ContactDriver, ReportsTooManySteps)
{
  FootCase foot(GlassProfile(), coarse, linear_elements());
  ContactControl control;
  control.max_steps = 1;
  EXPECT_EQ(outcome_on_mat(foot, load_at(1.7), control), ContactOutcome::too_many_steps);
}

TEST(ContactDriver, ReportsARepeatedActiveSet)
{
  const FootCase foot(flat_profile(), coarse, linear_elements());
  StuckBody stuck(foot.body->contact_surface());
  const auto mat = make_law(WinklerInterface(1e11), foot.body->contact_surface());
  EXPECT_EQ(outcome_of([&] { solve_contact(stuck, *mat, load_at(0.3), 0.03); }),
            ContactOutcome::repeated_set);
}

TEST(ContactDriver, ReportsNarrowContactsAndTheNumberOfNodesAcross)
{
  FootCase crowned(GlassProfile(), coarse);
  crowned.solve_on_winkler(1e11,
                           // The contact is 0.2 mm wide and the nodes are 0.5 mm apart.
                           load_at(0.3));
  EXPECT_EQ(crowned.solution.outcome, ContactOutcome::narrow_contact);
  EXPECT_EQ(crowned.solution.n_nodes_across, 1u);
  EXPECT_EQ(crowned.solution.n_loaded_nodes, 2 * coarse.azimuthal_cells);
  FootCase flat(flat_profile(), coarse);
  flat.solve_on_winkler(1e11, load_at(0.3));
  EXPECT_EQ(flat.solution.outcome, ContactOutcome::converged);
  EXPECT_EQ(flat.solution.n_nodes_across, 9u);
}

TEST(ContactDriver, ReportsOverflow)
{
  FootCase foot(GlassProfile(), coarse, linear_elements());
  EXPECT_EQ(outcome_on_mat(foot, { 1e306, 0, -1e304 }, {}), ContactOutcome::overflow);
}

TEST(ContactDriver, RefusesInvalidLoadsAndLaws)
{
  FootCase foot(GlassProfile(), coarse, linear_elements());
  const auto mat = make_law(WinklerInterface(1e11), foot.body->contact_surface());
  EXPECT_THROW(solve_contact(*foot.body, *mat, { 0, 0, 0 }, 0.03), std::invalid_argument);
  EXPECT_THROW(solve_contact(*foot.body, *mat, { -1, 0, 0 }, 0.03), std::invalid_argument);
  EXPECT_THROW(solve_contact(*foot.body, *mat, { 1, std::nan(""), 0 }, 0.03), std::invalid_argument);
  EXPECT_THROW(make_law(WinklerInterface(0), foot.body->contact_surface()), std::invalid_argument);
  EXPECT_THROW(make_law(WinklerInterface(std::nan("")), foot.body->contact_surface()), std::invalid_argument);
  EXPECT_THROW(HardInterface().make(foot.body->contact_surface(), -1), std::invalid_argument);
}

TEST(ContactDriver, ConvergedSolutionsHaveTheGivenResultantsAndNoTension)
{
  FootCase foot(GlassProfile(), coarse, linear_elements());
  for (const double modulus : { 1e8, 1e10, 1e12 })
    for (const double m : { 0., 0.7, 1.4, 1.95 })
    {
      const auto mat = make_law(WinklerInterface(modulus), foot.body->contact_surface());
      const Resultants demand = load_at(m, 2.1);
      foot.solve(*mat, demand);
      const ContactSurface &surface = foot.body->contact_surface();
      Eigen::Vector3d of_pressure(0, 0, 0), of_nodes(0, 0, 0);
      for (const PointForce &point : mat->load(foot.solution, 1).points)
        of_pressure += point.force * Eigen::Vector3d(1, point.y, -point.x);
      for (Eigen::Index i = 0; i < surface.n_nodes(); ++i)
        of_nodes += foot.solution.forces(i) *
                    Eigen::Vector3d(1, surface.node_position(i, 1), -surface.node_position(i, 0));
      const Eigen::Vector3d asked(demand.normal_force, demand.moment_x, demand.moment_y);
      const Eigen::Vector3d units(weight, weight * 0.03, weight * 0.03);
      EXPECT_LT((of_pressure - asked).cwiseQuotient(units).norm(), 1e-8) << modulus << ", " << m;
      EXPECT_LT((of_nodes - asked).cwiseQuotient(units).norm(), 1e-8) << modulus << ", " << m;
      EXPECT_LT(foot.solution.force_residual, 1e-9) << modulus << ", " << m;
      EXPECT_LT(foot.solution.moment_residual, 1e-9) << modulus << ", " << m;
      EXPECT_LT(foot.solution.equilibrium_residual, 1e-8) << modulus << ", " << m;
      EXPECT_GE(foot.solution.forces.minCoeff(), -1e-6 * foot.solution.forces.maxCoeff())
        << modulus << ", " << m;
    }
}

TEST(ContactDriver, HardInterfaceSatisfiesComplementarity)
{
  FootCase foot(GlassProfile(), coarse, linear_elements());
  const ContactSurface &surface = foot.body->contact_surface();
  const auto table = HardInterface().make(surface, 70e9 / foot.body->contact_cell_size());
  const ContactSolution solution = solve_contact(*foot.body, *table, load_at(1.3), 0.03);
  const Eigen::VectorXd gap = surface.node_gap + solution.normal_displacement;
  const double scale = solution.normal_displacement.cwiseAbs().maxCoeff();
  EXPECT_GE(solution.forces.minCoeff(), 0);
  EXPECT_GE(gap.minCoeff(), -1e-9 * scale);
  EXPECT_LT(solution.forces.cwiseProduct(gap).cwiseAbs().maxCoeff(), 1e-9 * weight * scale);
}
