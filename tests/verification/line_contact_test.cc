// Hard contact of a rigid crowned ring with a thick elastic disc, with and without lift-off. Reference: line
// contact on a half-space to leading order in width / radius (line_contact.h).
#include "fem/contact/hard_interface.h"
#include "fem/revolution/compliance_cache.h"
#include "fem/revolution/meshed_revolution_foot.h"
#include "ring_model/load/constants.h"
#include "tests/fem/reference_load.h"
#include "tests/verification/line_contact.h"

#include <gtest/gtest.h>

#include <cmath>

using stemware::ring::pi;
using namespace stemware::fem_tests;
using stemware::verification::LineContact;

namespace
{

/// Half-width of the contact at the mean load, divided by the radius of the ring.
constexpr double slenderness = 0.01;
constexpr unsigned int n_harmonics = 16;

/// Solves a rigid ring on a disc of ten times the ring's radius. The crown of the ring gives the Hertz
/// half-width slenderness * radius.
ContactLoad press_ring(double moment_ratio, unsigned int n_lines)
{
  Substrate substrate;
  substrate.disc.radius = substrate.disc.thickness = 0.3;
  const double modulus =
    substrate.material.young_modulus / (1 - std::pow(substrate.material.poisson_ratio, 2));
  RevolutionSetup setup;
  setup.foot_is_rigid = true;
  const double half_width = slenderness * setup.profile.contact_radius;
  const double line_load = weight / (2 * pi * setup.profile.contact_radius);
  setup.profile.crown_radius = half_width * half_width * pi * modulus / (4 * line_load);
  setup.table = { std::make_shared<HardInterface>(), substrate };
  setup.meridian.n_harmonics = n_harmonics;
  setup.n_lines = n_lines;
  setup.fineness = 4; // cells of b / 16; with cells of b / 4, noise of 2e-4 a_0 would disturb a_2 = 0.007 a_0
  static ComplianceCache cache; // shared because all tests use the same bodies
  MeshedRevolutionFoot foot(setup.resolved_for(weight), cache);
  return foot.solve(load_at(moment_ratio)).load;
}

} // namespace

TEST(LineContact, OracleAgreesWithPublishedValues)
{
  // The published values are for L = 15.7555 (here 15.75552). In the weakly nonlinear limit, a_2 = m^2 / (4
  // (L - 19/3)) = 0.0066.
  const LineContact contact(0.5, 33, slenderness);
  EXPECT_NEAR(contact.harmonic(2), 0.006875214728468, 3e-7);
  EXPECT_NEAR(contact.harmonic(3), -4.504165011245e-4, 3e-8);
  EXPECT_NEAR(contact.harmonic(4), 5.06792626489e-5, 6e-9);
}

TEST(LineContact, AgreesWithTheOracleOnACrownedRingInFullContact)
{
  const LineContact expected(0.5, 256, slenderness);
  const ContactLoad load = press_ring(0.5, 65); // 65: an odd number of lines
  EXPECT_EQ(load.contact_fraction, 1);
  // The tolerance of a_2 = 0.0069 is 1 %, the ratio of width and radius. The tolerance of the other harmonics
  // is the noise of contact edges that cross cell borders.
  EXPECT_NEAR(load.a(2) / load.a(0), expected.harmonic(2), 6e-5);
  for (unsigned int n = 3; n <= 6; ++n)
    EXPECT_NEAR(load.a(n) / load.a(0), expected.harmonic(n), 1.5e-5) << "n = " << n;
}

TEST(LineContact, AgreesWithTheOracleOnACrownedRingWithLiftOff)
{
  const LineContact expected(1.3, 512, slenderness);
  const unsigned int n_lines = 128;
  const ContactLoad load = press_ring(1.3, n_lines);
  EXPECT_NEAR(load.contact_fraction, expected.loaded_share(), 1.5 / n_lines);
  // Expected: 0.2099, -0.0924, 0.0279, 0.0084, -0.0189. Tolerance: the ratio of width and radius, times the
  // largest value.
  for (unsigned int n = 2; n <= 6; ++n)
    EXPECT_NEAR(load.a(n) / load.a(0), expected.harmonic(n), n == 2 ? 1.2e-3 : 5e-4) << "n = " << n;
}

/// NAFEMS R0094, contact benchmark 1: a steel cylinder of radius 50 mm on aluminium under 35 kN/mm has a
/// half-width of 6.21 mm and a peak pressure of 3585.37 MPa.
TEST(LineContact, HalfWidthAgreesWithHertz)
{
  RevolutionSetup setup;
  setup.profile.crown_radius = 0.05;
  setup.material = { 210e9, 0.3 };
  setup.table = { std::make_shared<HardInterface>(), Substrate{ {}, { 70e9, 0.3 } } };
  const double line_load = 35e6;
  const double half_width = hertz_half_width(setup, line_load * 2 * pi * setup.profile.contact_radius);
  EXPECT_NEAR(half_width, 6.21e-3, 5e-6);
  EXPECT_NEAR(2 * line_load / (pi * half_width) / 3585.37e6, 1, 1e-5);
}
