// A glass that leans under its own weight, loads gathered on rings, and how many Newton steps a neighbour
// takes.
#include "fem/contact/hard_interface.h"
#include "fem/meridian/meshed_revolution_foot.h"
#include "tests/fem/revolution/revolution_case.h"

#include <gtest/gtest.h>

using namespace stemware::revolution_tests;

namespace
{

RevolutionSetup on_table(std::shared_ptr<const InterfaceLaw> interface,
                         std::optional<Substrate> substrate = {})
{
  RevolutionSetup setup;
  setup.table = { std::move(interface), std::move(substrate) };
  return setup;
}

/// Mat, hardwood and a rigid table.
std::vector<RevolutionSetup> three_tables()
{
  return { on_table(std::make_shared<WinklerInterface>()),
           on_table(std::make_shared<HardInterface>(), Substrate()),
           on_table(std::make_shared<HardInterface>()) };
}

const std::vector<double> five_rings = { 0.0298, 0.0299, 0.03, 0.0301, 0.0302 };

} // namespace

// Reference: closed form. A rigid annulus on a Winkler mat resists a tilt by kappa = pi k (r2^4 - r1^4) / 4
// as long as all of it carries.
TEST(Tilt, AmplifiesTheMomentOfARigidAnnulus)
{
  for (const double modulus : { 1e9, 1e10 })
    for (const double height : { 0., 0.08, 0.3 })
    {
      RevolutionSetup setup = on_table(std::make_shared<WinklerInterface>(modulus));
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
      const double kappa = M_PI * modulus * (std::pow(outer, 4) - std::pow(inner, 4)) / 4;
      const double amplified = 1 / (1 - weight * height / kappa);
      EXPECT_NEAR(load.moment().x() / demand.moment_x / amplified, 1, 1e-9) << modulus << ", " << height;
      EXPECT_NEAR(load.moment().y() / demand.moment_y / amplified, 1, 1e-9) << modulus << ", " << height;
    }
}

// Reference: contacts under plain moments, which know nothing of the weight. A rim whose contact shrinks
// leans by theta(M); a glass that leans is in balance where M - N z_CM theta(M) is the moment prescribed: at
// two moments up to the largest, at none beyond.
TEST(Tilt, IsThatOfTheFirstOfTwoBalances)
{
  struct Case
  {
    double height, between, second; // z_CM [m], and moment ratios between the two balances, at the second
  };
  RevolutionSetup setup = on_table(std::make_shared<WinklerInterface>(1e7));
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
    leaning.solve(under_moment(second)); // Newton's method starts at the second balance
    EXPECT_NEAR(-leaning.solve(demand).load.moment().y() / scale, below, 1e-7) << height;
  }
}

/// Reference: the demand itself, from the motions that come with the solution; with lift-off too.
TEST(Tilt, IsTheWeightTimesTheLean)
{
  for (const RevolutionSetup &setup : three_tables())
  {
    MeshedRevolutionFoot foot(setup.resolved_for(weight));
    ContactDemand demand = load_at(1.3, 0.7);
    demand.tilt_moment = weight * 0.08;
    const ContactState state = foot.solve(demand);
    const Eigen::Vector3d &motion = state.solution.motion;
    const double scale = weight * 0.03;
    EXPECT_NEAR(state.load.moment().x() / scale, (demand.moment_x - demand.tilt_moment * motion(2)) / scale,
                1e-9);
    EXPECT_NEAR(state.load.moment().y() / scale, (demand.moment_y + demand.tilt_moment * motion(1)) / scale,
                1e-9);
    EXPECT_GT(std::abs(demand.tilt_moment * motion(2)), 1e-7 * scale);
    // Along the moment, not against it.
    EXPECT_GT(std::hypot(state.load.moment().x(), state.load.moment().y()),
              std::hypot(demand.moment_x, demand.moment_y));
  }
}

// Reference: the forces on the contact nodes, azimuth line by azimuth line.
TEST(Rings, CarryTheMomentsOfAState)
{
  for (const RevolutionSetup &setup : three_tables())
  {
    MeshedRevolutionFoot foot(setup.resolved_for(weight));
    ContactDemand demand = load_at(1.2, 0.4);
    demand.ring_radii = five_rings;
    const ContactState state = foot.solve(demand);
    const std::vector<PointForce> points = foot.point_forces(state);
    for (const unsigned int n_rings : { 2u, 3u, 5u })
    {
      const ContactLoad load =
        foot.project_onto_rings(state, { five_rings.begin(), five_rings.begin() + n_rings }, 8);
      ASSERT_EQ(load.rings().size(), n_rings);
      for (unsigned int k = 0; k < n_rings; ++k) // moments of (r - R) / w
        for (const unsigned int n : { 0u, 1u, 2u, 7u })
        {
          const auto power = [&](double radius) { return std::pow((radius - 0.03) / 2e-4, k); };
          double even = 0, odd = 0;
          for (const PointForce &point : points)
          {
            const double theta = std::atan2(point.y, point.x);
            const double part = point.force * power(std::hypot(point.x, point.y)) / (n > 0 ? M_PI : 2 * M_PI);
            even += part * std::cos(n * theta);
            odd += part * std::sin(n * theta);
          }
          for (unsigned int j = 0; j < n_rings; ++j)
          {
            even -= power(five_rings[j]) * load.rings()[j].a[n];
            odd -= power(five_rings[j]) * load.rings()[j].b[n];
          }
          EXPECT_NEAR(even / weight, 0, 1e-9) << n_rings << " rings, moment " << k << ", harmonic " << n;
          EXPECT_NEAR(odd / weight, 0, 1e-9) << n_rings << " rings, moment " << k << ", harmonic " << n;
        }
      // Force and moment of the rings are those of the demand.
      double force = 0, moment_x = 0, moment_y = 0;
      for (unsigned int j = 0; j < n_rings; ++j)
      {
        force += 2 * M_PI * load.rings()[j].a[0];
        moment_x += M_PI * load.rings()[j].radius * load.rings()[j].b[1];
        moment_y -= M_PI * load.rings()[j].radius * load.rings()[j].a[1];
      }
      EXPECT_NEAR(force / weight, 1, 1e-10);
      EXPECT_NEAR(moment_x / demand.moment_x, 1, 1e-9);
      EXPECT_NEAR(moment_y / demand.moment_y, 1, 1e-9);
    }
  }
}

// Own regression: counts of steps, which no clock disturbs. Hard tables where the whole rim carries; a mat
// under lift-off too.
TEST(RevolutionFoot, NeighboursTakeFewNewtonSteps)
{
  for (RevolutionSetup setup : three_tables())
  {
    setup.friction_coefficient = 0.3;
    MeshedRevolutionFoot foot(setup.resolved_for(weight));
    const bool is_hard = setup.table.interface->is_hard();
    for (const double m : is_hard ? std::vector<double>{ 0.4 } : std::vector<double>{ 0.4, 1.3, 1.7 })
    {
      const ContactState first = foot.solve(load_at(m, 0.2), { -9, {} });
      const ContactState near = foot.solve(load_at(1.02 * m, 0.22), { -9.2, {} }, { &first });
      EXPECT_LE(near.solution.n_iterations, is_hard ? 6u : 4u) << "m = " << m << ", hard: " << is_hard;
    }
  }
}
