#include "fem/revolution/meshed_revolution_foot.h"
#include "ring_model/load/constants.h"
#include "tests/fem/revolution/revolution_case.h"

#include <gtest/gtest.h>

using stemware::ring::pi;
using namespace stemware::revolution_tests;

// Closed form: on a Winkler mat of the modulus k, a rigid annulus in full contact has the tilt stiffness
// kappa = pi k (r2^4 - r1^4) / 4. The tilt moment N z_CM multiplies the moment by 1 / (1 - N z_CM / kappa).
TEST(Tilt, MomentAmplificationOfARigidAnnulusAgreesWithTheClosedForm)
{
  for (const double modulus : { 1e9, 1e10 })
    for (const double height : { 0., 0.08, 0.3 })
    {
      RevolutionSetup setup;
      setup.table.interface = std::make_shared<WinklerInterface>(modulus);
      setup.profile = flat_profile();
      setup.foot_is_rigid = true;
      setup.meridian.n_harmonics = 2;
      setup.n_lines = 32;
      MeshedRevolutionFoot foot(setup.resolved_for(weight));
      ContactDemand demand = load_at(0.5, 0.7);
      demand.tilt_moment = weight * height;
      const ContactLoad load = foot.solve(demand).load;
      ASSERT_EQ(load.contact_fraction, 1);
      const double inner = setup.profile.land_inner_radius(), outer = setup.profile.land_outer_radius();
      const double kappa = pi * modulus * (std::pow(outer, 4) - std::pow(inner, 4)) / 4;
      const double amplified = 1 / (1 - weight * height / kappa);
      EXPECT_NEAR(load.moment().x() / demand.moment_x / amplified, 1, 1e-9) << modulus << ", " << height;
      EXPECT_NEAR(load.moment().y() / demand.moment_y / amplified, 1, 1e-9) << modulus << ", " << height;
    }
}

// Reference: lean theta(M) under the moment M, computed without tilt moment. A leaning glass is in balance if
// M - N z_CM theta(M) equals the prescribed moment. Below the maximum of M - N z_CM theta(M), two moments M
// satisfy this equation.
TEST(Tilt, ReturnsTheFirstOfTwoBalances)
{
  struct Case
  {
    // z_CM [m], a moment ratio between the two balances, and the moment ratio of the second balance.
    double height, between, second;
  };
  RevolutionSetup setup;
  setup.table.interface = std::make_shared<WinklerInterface>(1e7);
  setup = setup.resolved_for(weight);
  MeshedRevolutionFoot plain(setup);
  const double scale = weight * setup.profile.contact_radius / 2;
  const auto under_moment = [&](double m) { return ContactDemand(weight, 0, -m * scale); };
  for (const auto &[height, between, second] : { Case{ 0.05, 1.6, 1.9 }, Case{ 0.5, 1.2, 1.4 } })
  {
    const double tilt_moment = weight * height;
    const auto prescribed_at = [&, &tilt = tilt_moment](double m)
    { return m - tilt * std::abs(plain.solve(under_moment(m)).solution.motion(1)) / scale; };
    const double prescribed = prescribed_at(second);
    double below = prescribed, above = between;
    ASSERT_LT(prescribed_at(below), prescribed);
    ASSERT_GT(prescribed_at(above), prescribed);
    while (above - below > 1e-8)
    {
      const double middle = (below + above) / 2;
      (prescribed_at(middle) < prescribed ? below : above) = middle;
    }
    ContactDemand demand = under_moment(prescribed);
    demand.tilt_moment = tilt_moment;
    MeshedRevolutionFoot leaning(setup);
    leaning.solve(under_moment(second)); // the next solve starts at the second balance
    EXPECT_NEAR(-leaning.solve(demand).load.moment().y() / scale, below, 1e-7) << height;
  }
}
