#include "fem/contact/contact_demand.h"
#include "fem/contact/hard_interface.h"
#include "fem/contact/rigid_foot.h"
#include "fem/contact/rough_interface.h"
#include "ring_model/friction_functionals.h"
#include "ring_model/load/constants.h"
#include "tests/fem/revolution/revolution_case.h"
#include "tests/taylor_remainder.h"
#include "tests/ulps.h"

#include <random>

using stemware::ring::pi;
using namespace stemware::revolution_tests;
using stemware::taylor::is_derivative;

namespace
{

struct LeaningRim
{
  LeaningRim()
      : rim(GlassProfile(), foot_compliance(GlassProfile(), equal_cells(), MeridianOptions{ 2, 1 }), 24)
      , surface(rim.body.contact_surface())
      , modes(surface.motion_modes())
      , displacement(modes * Eigen::Vector3d(-4e-6, 2e-4, -1e-4))
  {
    std::mt19937 engine(48);
    std::uniform_real_distribution<double> between(-1, 1);
    direction = Eigen::VectorXd::NullaryExpr(surface.n_nodes(), [&]() { return 1e-6 * between(engine); });
  }

  RevolutionCase rim;
  const ContactSurface &surface;
  const Eigen::MatrixX3d modes;
  const Eigen::VectorXd displacement; ///< normal displacement [m]
  Eigen::VectorXd direction;          ///< random direction of the derivative [m]
};

/// Returns a moment balance with friction and tilt moment. Its linear conditions border Newton's system.
ContactDemand friction_and_tilt()
{
  ContactDemand demand(weight, 0.012, -0.01);
  demand.ring_radii = { 0.0297, 0.03, 0.0303 };
  const auto friction =
    stemware::ring::friction_functionals(stemware::ring::coulomb_law(0.3), demand.ring_radii, 8, -4., 0.35);
  demand.friction_x = -0.05 * friction.side;
  demand.friction_y = 0.05 * friction.drag;
  demand.tilt_moment = 0.24;
  return demand;
}

} // namespace

TEST(Derivatives, PressureStiffnessAndPenetrationAreConsistent)
{
  const auto check = [](const auto &law, double depth)
  {
    const double step = 1e-7;
    const auto [pressure, stiffness] = law.pressure_and_stiffness(depth);
    EXPECT_TRUE(is_derivative([&](double h) { return law.pressure(depth + h); }, stiffness, step)) << depth;
    EXPECT_NEAR(law.pressure(depth) / pressure, 1, stemware::ulps(5, 1));
    EXPECT_NEAR(law.penetration_at(pressure), depth, 1e-14);
    EXPECT_TRUE(is_derivative([&, p = pressure](double h) { return law.penetration_at(p * (1 + h)); },
                              pressure / law.stiffness_at(pressure), 0.05));
  };
  for (const double depth : { 1e-7, 4e-6 })
    check(WinklerInterface(3e9), depth);
  for (const double depth : { -5e-6, -1e-6, 5e-7, 3e-6 })
    check(RoughInterface(1e9, 1e-6), depth);
}

TEST(Derivatives, TangentIsTheDerivativeOfTheForces)
{
  const LeaningRim rim;
  const std::shared_ptr<const InterfaceLaw> interfaces[] = { std::make_shared<WinklerInterface>(1e10),
                                                             std::make_shared<RoughInterface>(1e9, 1e-6),
                                                             std::make_shared<HardInterface>() };
  for (const auto &interface : interfaces)
  {
    const auto law = interface->make(rim.surface, 1e14);
    ContactForces contact;
    law->evaluate(rim.displacement, contact);
    EXPECT_GT(contact.forces.maxCoeff(), 0);
    if (interface->has_edge()) // lift-off: some lines are loaded, others are not
    {
      EXPECT_NE(std::count(contact.active_set.begin(), contact.active_set.end(), true), 0);
      EXPECT_NE(std::count(contact.active_set.begin(), contact.active_set.end(), false), 0);
    }
    const Eigen::VectorXd derivative = -(contact.tangent * rim.direction);
    const auto forces = [&](double h) -> Eigen::VectorXd
    {
      ContactForces there;
      law->evaluate(rim.displacement + h * rim.direction, there);
      return there.forces;
    };
    EXPECT_TRUE(is_derivative(forces, derivative, 0.5)) << interface->is_hard();
    // The check is_derivative() detects an error of 0.1 %.
    EXPECT_FALSE(is_derivative(forces, Eigen::VectorXd(1.001 * derivative), 0.5));
  }
}

TEST(Derivatives, BorderIsTheDerivativeOfTheConditionsAndGivesTheRigidNewtonStep)
{
  const LeaningRim rim;
  const LinearConditions conditions = conditions_of(rim.surface, friction_and_tilt());
  ASSERT_FALSE(conditions.are_resultants());
  const auto law = WinklerInterface(1e10).make(rim.surface, 0);
  const auto forces_at = [&](const Eigen::Vector3d &motion)
  {
    ContactForces contact;
    law->evaluate(rim.displacement + rim.modes * motion, contact);
    return contact;
  };
  const ContactForces start = forces_at(Eigen::Vector3d::Zero());
  const Eigen::Matrix3d stiffness = motion_stiffness(start.tangent, conditions.weights(), rim.modes),
                        product = conditions.weights().transpose() * start.tangent * rim.modes;
  EXPECT_LT((stiffness - product).norm(), 1e-13 * product.norm());
  // For a rigid foot, the derivative of the conditions L'f + H q with respect to the table motions q is -L'TQ
  // + H (tangent T, motion modes Q).
  const Eigen::Matrix3d border = conditions.motion_weights() - product;
  for (unsigned int i = 0; i < 3; ++i)
  {
    const Eigen::Vector3d step = i == 0 ? Eigen::Vector3d(1e-6, 0, 0) : 3e-5 * Eigen::Vector3d::Unit(i);
    const auto residual = [&](double h) -> Eigen::VectorXd
    { return conditions.residual(forces_at(h * step).forces, h * step); };
    EXPECT_TRUE(is_derivative(residual, Eigen::VectorXd(border * step), 0.5)) << i;
  }
  const Eigen::Vector3d rest = Eigen::Vector3d::Zero(), residual = conditions.residual(start.forces, rest);
  const Eigen::Vector3d increment =
    RigidFoot(rim.surface).solve(start.tangent, start.forces, conditions, rest).motion;
  EXPECT_LT((border * increment + residual).norm(), 1e-10 * residual.norm());
}

// Reference: moment balance of rings with friction and tilt moment. The balance is linear in forces and
// motion, so random states suffice.
TEST(Derivatives, ConditionsEqualTheMomentBalance)
{
  const LeaningRim rim;
  const ContactDemand demand = friction_and_tilt();
  const LinearConditions conditions = conditions_of(rim.surface, demand);
  std::mt19937 engine(7);
  std::uniform_real_distribution<double> between(-1, 1);
  for (unsigned int trial = 0; trial < 5; ++trial)
  {
    const Eigen::VectorXd forces = Eigen::VectorXd::NullaryExpr(
      rim.surface.n_nodes(), [&]() { return weight / rim.surface.n_nodes() * (1 + between(engine)); });
    const Eigen::Vector3d motion(1e-6 * between(engine), 1e-4 * between(engine), 1e-4 * between(engine));
    std::vector<stemware::ring::RingStack::Ring> rings;
    for (const double radius : demand.ring_radii)
      rings.push_back({ radius, std::vector<double>(9, 0.), std::vector<double>(9, 0.) });
    Eigen::Vector2d moment = Eigen::Vector2d::Zero();
    for (Eigen::Index i = 0; i < forces.size(); ++i)
    {
      const double x = rim.surface.node_position(i, 0), y = rim.surface.node_position(i, 1);
      const double r = std::hypot(x, y), theta = std::atan2(y, x);
      moment += forces(i) * Eigen::Vector2d(y, -x);
      for (std::size_t j = 0; j < rings.size(); ++j)
      {
        double share = forces(i) / pi;
        for (std::size_t k = 0; k < rings.size(); ++k)
          if (k != j)
            share *= (r - rings[k].radius) / (rings[j].radius - rings[k].radius);
        rings[j].a[0] += share / 2;
        for (unsigned int n = 1; n <= 8; ++n)
        {
          rings[j].a[n] += share * std::cos(n * theta);
          rings[j].b[n] += share * std::sin(n * theta);
        }
      }
    }
    const auto friction = stemware::ring::coulomb_wrench(0.3, stemware::ring::RingStack(rings), -4., 0.35);
    // Balance: moment = (moment_x, moment_y) + 0.05 e_z x T + tilt_moment (-q2, q1), with the arm 0.05 m, the
    // friction force T and the tilts q1, q2 of `motion`. Order of the conditions: normal force, -M_y, M_x.
    const Eigen::Vector2d unbalanced = moment - Eigen::Vector2d(demand.moment_x, demand.moment_y) -
                                       0.05 * Eigen::Vector2d(-friction.force_y, friction.force_x) -
                                       demand.tilt_moment * Eigen::Vector2d(-motion(2), motion(1));
    const Eigen::Vector3d expected(forces.sum() - weight, -unbalanced(1), unbalanced(0));
    EXPECT_LT((conditions.residual(forces, motion) - expected).norm(), 1e-13 * weight) << trial;
  }
}
