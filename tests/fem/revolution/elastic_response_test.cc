// Reference: compliance matrices assembled column by column from the displacements under unit forces.
#include "fem/contact/rough_interface.h"
#include "ring_model/load/constants.h"
#include "tests/fem/revolution/revolution_case.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

using stemware::ring::pi;
using namespace stemware::revolution_tests;

namespace
{

constexpr unsigned int few_lines = 20;
constexpr unsigned int few_harmonics = 6;

/// Returns u_z on the lines under a unit force on circle @p i of line @p j [m/N]: the sum over the harmonics
/// of a point force, 1 / (2 pi) + sum cos n(theta - theta_j) / pi. Harmonics above few_harmonics move line @p
/// j only. An azimuthal force contributes -sin n(theta - theta_j) / pi times its compliance.
Eigen::MatrixXd response_to_unit_force(const ElasticResponse &response, Eigen::Index i, Eigen::Index j,
                                       const SlidingTraction &traction)
{
  const ContactCompliance &circles = response.compliance();
  const auto azimuth = [&](Eigen::Index line) { return 2 * pi * static_cast<double>(line) / few_lines; };
  const Eigen::Vector2d slide = traction.direction(circles.radii(i), azimuth(j));
  Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(response.n_radii(), few_lines);
  for (Eigen::Index line = 0; line < few_lines; ++line)
  {
    double left =
      line == j ? few_lines / (2 * pi) : 0; // rest of the point force: harmonics above few_harmonics
    for (unsigned int n = 0; n <= few_harmonics; ++n)
    {
      const double angle = n * (azimuth(line) - azimuth(j));
      const double even = std::cos(angle) / (n == 0 ? 2 * pi : pi);
      const HarmonicCompliance &harmonic = circles.harmonics[n];
      expected.col(line) += even * (harmonic.normal.col(i) + slide(0) * harmonic.radial.col(i)) -
                            std::sin(angle) / pi * slide(1) * harmonic.azimuthal.col(i);
      left -= even;
    }
    expected.col(line) += left * (circles.tail.normal.col(i) + slide(0) * circles.tail.radial.col(i));
  }
  return expected;
}

Eigen::MatrixXd dense_compliance(const ElasticResponse &response)
{
  const Eigen::Index n_nodes = response.n_radii() * response.n_lines();
  Eigen::MatrixXd compliance(n_nodes, n_nodes);
  Eigen::MatrixXd unit = Eigen::MatrixXd::Zero(response.n_radii(), response.n_lines());
  for (Eigen::Index node = 0; node < n_nodes; ++node)
  {
    unit(node) = 1;
    compliance.col(node) = response.displacement(unit).reshaped();
    unit(node) = 0;
  }
  return compliance;
}

/// Newton's method with dense matrices for forces f and table motions q: f = law(C f + Q q) and L'f + H q =
/// t, with the compliance C, the motion modes Q and the conditions (L, H, t).
class DenseContact
{
public:
  DenseContact(const BodyOfRevolution &body, const TableLaw &law, const LinearConditions &conditions)
      : surface(body.contact_surface())
      , law(law)
      , conditions(conditions)
      , compliance(dense_compliance(body.elastic_response()))
      , modes(surface.motion_modes())
      , forces(Eigen::VectorXd::Zero(surface.n_nodes()))
  {
  }

  /// Solves (1 + T C) df + T Q dq = law(C f + Q q) - f and L' df + H dq = t - L'f - H q, with the tangent T.
  void step()
  {
    ContactForces contact;
    law.evaluate(compliance * forces + modes * motion, contact);
    const Eigen::MatrixXd tangent(contact.tangent);
    const Eigen::Index n = forces.size();
    Eigen::MatrixXd matrix(n + 3, n + 3);
    matrix.topLeftCorner(n, n) = tangent * compliance;
    matrix.diagonal().head(n).array() += 1;
    matrix.topRightCorner(n, 3) = tangent * modes;
    matrix.bottomLeftCorner(3, n) = conditions.weights().transpose();
    matrix.bottomRightCorner(3, 3) = conditions.motion_weights();
    Eigen::VectorXd rhs(n + 3);
    rhs << contact.forces - forces, -conditions.residual(forces, motion);
    const Eigen::VectorXd found = matrix.partialPivLu().solve(rhs);
    increment = found.head(n);
    motion_increment = found.tail<3>();
  }

  void converge()
  {
    for (unsigned int i = 0; i < 40; ++i)
    {
      step();
      forces += increment;
      motion += motion_increment;
      if (increment.norm() < 1e-13 * forces.norm())
        return;
    }
    ADD_FAILURE() << "the dense Newton method did not converge";
  }

  const ContactSurface &surface;
  const TableLaw &law;
  const LinearConditions &conditions;
  const Eigen::MatrixXd compliance;
  const Eigen::MatrixX3d modes;
  Eigen::VectorXd forces;
  Eigen::Vector3d motion = Eigen::Vector3d::Zero();
  Eigen::VectorXd increment;
  Eigen::Vector3d motion_increment;
};

/// Foot with few enough contact nodes for dense matrices. Parameter: friction coefficient.
class SmallFoot : public testing::TestWithParam<double>
{
protected:
  SmallFoot()
      : foot(profile, foot_compliance(profile, graded_cells(), { 2, few_harmonics }), few_lines)
  {
    foot.body.set_sliding(traction);
  }

  LinearConditions conditions() const
  {
    const ContactSurface &surface = foot.body.contact_surface();
    const Resultants load = load_at(0.9, 0.4);
    Eigen::MatrixX3d weights = surface.motion_modes();
    weights.col(1).array() -= 0.02 * GetParam();
    weights.col(2) += 0.1 * GetParam() * surface.node_position.col(0);
    const Eigen::Matrix3d leaning = Eigen::Vector3d(0, 0.2, 0.2).asDiagonal();
    return { surface, weights, { load.normal_force, -load.moment_y, load.moment_x }, leaning };
  }

  const GlassProfile profile;
  const SlidingTraction traction{ GetParam(), -9. };
  RevolutionCase foot;
};

INSTANTIATE_TEST_SUITE_P(Friction, SmallFoot, testing::Values(0., 0.4),
                         [](const auto &info) { return info.param > 0 ? "Coupled" : "None"; });

} // namespace

TEST_P(SmallFoot, ResponseIsTheSumOverTheHarmonicsOfAPointForce)
{
  const ElasticResponse &response = foot.body.elastic_response();
  ASSERT_EQ(response.has_sliding(), GetParam() > 0);
  for (const Eigen::Index line : { 0, 3, 13 })
    for (const Eigen::Index circle :
         { Eigen::Index(0), Eigen::Index(5), foot.body.elastic_response().n_radii() - 1 + 0L })
    {
      Eigen::MatrixXd unit = Eigen::MatrixXd::Zero(response.n_radii(), few_lines);
      unit(circle, line) = 1;
      const Eigen::MatrixXd expected = response_to_unit_force(response, circle, line, traction);
      EXPECT_LT((response.displacement(unit) - expected).norm(), 1e-12 * expected.norm())
        << "circle " << circle << ", line " << line;
    }
}

TEST_P(SmallFoot, ConvergesToTheDenseSolution)
{
  const std::shared_ptr<const InterfaceLaw> interfaces[] = { std::make_shared<WinklerInterface>(1e10),
                                                             std::make_shared<WinklerInterface>(1e13),
                                                             std::make_shared<RoughInterface>() };
  for (const auto &interface : interfaces)
  {
    const auto law = make_law(*interface, foot.body.contact_surface());
    const LinearConditions wanted = conditions();
    const ContactSolution solution = solve_contact(foot.body, *law, wanted, profile.contact_radius);
    DenseContact dense(foot.body, *law, wanted);
    dense.forces = 1.01 * solution.forces;
    dense.motion = solution.motion;
    dense.converge();
    EXPECT_LT((solution.forces - dense.forces).norm(), 1e-9 * dense.forces.norm());
    EXPECT_LT((solution.motion - dense.motion).norm(), 1e-9 * dense.motion.norm());
  }
}

TEST(BodyOfRevolution, RefusesTooFewLinesTooHighDegreesMismatchedSumsAndNegativeFriction)
{
  const ContactCompliance compliance = foot_compliance(GlassProfile(), graded_cells());
  EXPECT_THROW(RevolutionCase(GlassProfile(), compliance, 32), std::invalid_argument);
  MeridianOptions options;
  options.degree = 5;
  EXPECT_THROW(foot_compliance(GlassProfile(), graded_cells(), options), std::invalid_argument);
  ContactCompliance sum = compliance;
  EXPECT_THROW(sum += foot_compliance(GlassProfile(), graded_cells(1)), std::invalid_argument);
  SlidingTraction traction;
  traction.friction_coefficient = -0.1;
  RevolutionCase foot(GlassProfile(), compliance);
  EXPECT_THROW(foot.body.set_sliding(traction), std::invalid_argument);
}
