// The load of a rigid narrow ring has a closed form: modified Bessel functions for a rough interface, a
// function of the contact angle for a mat.
#include "fem/contact/rigid_foot.h"
#include "fem/contact/rough_interface.h"
#include "fem/contact/sliding_traction.h"
#include "tests/fem/revolution/revolution_case.h"
#include "tests/ulps.h"

#include <boost/math/special_functions/bessel.hpp>
#include <gtest/gtest.h>

using namespace stemware::revolution_tests;

namespace
{

GlassProfile thin_ring(double crown_radius)
{
  GlassProfile profile;
  profile.land_width = 1e-4;
  profile.crown_radius = crown_radius;
  return profile;
}

struct RigidRing
{
  RigidRing(const GlassProfile &profile, unsigned int n_lines)
      : compliance(foot_compliance(profile, equal_cells(), MeridianOptions{ 2, 1 }))
      , revolution(profile, compliance, n_lines)
      , foot(revolution.body.contact_surface())
  {
  }

  ContactLoad solve(TableLaw &law, double m)
  {
    return extract_load(law, solve_contact(foot, law, load_at(m), 0.03), 8);
  }

  ContactCompliance compliance;
  RevolutionCase revolution;
  RigidFoot foot;
};

/// Returns x in [low, high] with @p value(x) = @p target for an increasing function, by bisection.
template <typename Function>
double invert(const Function &value, double target, double low, double high)
{
  for (unsigned int i = 0; i < 200; ++i)
  {
    const double middle = (low + high) / 2;
    (value(middle) < target ? low : high) = middle;
  }
  return (low + high) / 2;
}

} // namespace

TEST(RoughInterface, GivesBesselHarmonicsUnderARigidRing)
{
  // The load is proportional to exp(x cos theta), so a_n / a_0 = 2 I_n(x) / I_0(x).
  RigidRing ring(thin_ring(0), 256);
  for (const RoughInterface &interface : { RoughInterface(1e9, 1e-6), RoughInterface(1e12, 1e-7) })
    for (const double m : { 0.2, 0.8, 1.5 })
    {
      const auto law = make_law(interface, ring.revolution.body.contact_surface());
      const ContactLoad load = ring.solve(*law, m);
      const auto ratio = [](unsigned int n, double x)
      { return 2 * boost::math::cyl_bessel_i(n, x) / boost::math::cyl_bessel_i(0, x); };
      const double x = invert([&](double y) { return ratio(1, y); }, load.a(1) / load.a(0), 0, 50);
      EXPECT_NEAR(load.a(1) / load.a(0), m, 1e-4); // the closed form neglects the width of 0.1 mm
      for (unsigned int n = 2; n <= 8; ++n)
        EXPECT_NEAR(load.a(n) / load.a(0), ratio(n, x), 1e-5) << "m = " << m << ", n = " << n;
      EXPECT_EQ(load.contact_fraction, 1);
    }
}

TEST(RoughInterface, RefusesInvalidParameters)
{
  RigidRing ring(thin_ring(0), 16);
  const ContactSurface &surface = ring.revolution.body.contact_surface();
  EXPECT_THROW(make_law(RoughInterface(1e9, 0), surface), std::invalid_argument);
  EXPECT_THROW(make_law(RoughInterface(-1, 1e-6), surface), std::invalid_argument);
}

TEST(RigidLimit, AgreesWithTheClosedFormOfACrownedRingOnAMat)
{
  // Under a rigid torus, the line load is proportional to the 3/2 power of the penetration. Lift-off starts
  // at m = 6/5 with a_2/a_0 = 6/35; all other a_n come from quadrature.
  GlassProfile profile = thin_ring(0.003);
  profile.land_width = 1e-3;
  RigidRing ring(profile, 1024);
  const auto mat = make_law(WinklerInterface(1e12), ring.revolution.body.contact_surface());
  struct Row
  {
    double m;
    double a[7];
  };
  const Row rows[] = {
    { 0.5, { .0216141997, -6.288813e-4, 4.133006e-5, -3.628702e-6, 3.721098e-7, -4.208181e-8, 5.091904e-9 } },
    { 1.2, { 6. / 35, -.0190476190, .0051948052, -.0019980020, 9.324009e-4, -4.936240e-4, 2.857823e-4 } },
    { 1.5, { .5444909918, -.0098744992, -.0455699149, .0227367064, .0041320348, -.0114899894, .0042190700 } },
    { 1.8, { 1.2888588420, .6808576241, .1945825053, -.0566029311, -.0965376371, -.0338964182, .0247620488 } }
  };
  for (const Row &row : rows)
  {
    const ContactLoad load = ring.solve(*mat, row.m);
    for (unsigned int n = 2; n <= 8; ++n)
      EXPECT_NEAR(load.a(n) / load.a(0), row.a[n - 2], 1e-4) << "m = " << row.m << ", n = " << n;
  }
}

TEST(SlidingTraction, OpposesTheSlipInRotatedAxes)
{
  const double mu = 0.3, spin = -40., radius = 0.03;
  for (const double rotation : { 0., 0.7, -2. })
    for (const double azimuth : { 0.1, 1.9, -2.4 })
    {
      const double theta = azimuth + rotation, c = std::cos(theta), s = std::sin(theta);
      const Eigen::Vector2d velocity(1 - spin * radius * s, spin * radius * c), radial(c, s), around(-s, c);
      const Eigen::Vector2d traction = SlidingTraction{ mu, spin, rotation }.direction(radius, azimuth);
      EXPECT_NEAR(traction(0), -mu * velocity.dot(radial) / velocity.norm(), stemware::ulps(15, mu))
        << rotation;
      EXPECT_NEAR(traction(1), -mu * velocity.dot(around) / velocity.norm(), stemware::ulps(15, mu))
        << rotation;
    }
}

TEST(SlidingTraction, AllowsZeroButNotNegativeFriction)
{
  const SlidingTraction smooth{ 0, -40. };
  EXPECT_NO_THROW(smooth.validate());
  EXPECT_EQ(smooth.direction(0.03, 0.4).norm(), 0);
  EXPECT_THROW((SlidingTraction{ -0.1, -40. }).validate(), std::invalid_argument);
}

// Reference: midpoint rule of the pressure under a crown of height x^2 / (2 rho).
TEST(InterfaceHalfWidth, PressureWithinTheHalfWidthIntegratesToTheLineLoad)
{
  const double line_load = 5e3, crown_radius = 2e-3;
  const WinklerInterface mat(3e11);
  const double half_width = mat.half_width(line_load, crown_radius);
  double sum = 0;
  const int n = 10000;
  for (int i = 0; i < n; ++i)
  {
    const double x = half_width * (2 * (i + 0.5) / n - 1);
    sum += mat.pressure((half_width * half_width - x * x) / (2 * crown_radius)) * 2 * half_width / n;
  }
  EXPECT_NEAR(sum / line_load, 1, 1e-7);
}

TEST(InterfaceHalfWidth, IsTwoAndAHalfStandardDeviationsOfTheGaussianPressureOnARoughTable)
{
  const double crown_radius = 2e-3;
  const RoughInterface rough(1e9, 1e-6);
  const double x = rough.half_width(5e3, crown_radius) / 2.5, lowest = -3e-6;
  EXPECT_NEAR(rough.pressure(lowest - x * x / (2 * crown_radius)) / rough.pressure(lowest), std::exp(-0.5),
              1e-12);
}
