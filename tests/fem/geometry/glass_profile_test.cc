#include "fem/elasticity/elastic_material.h"
#include "tests/fem/geometry/profile_oracle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

using namespace stemware::fem;
using stemware::fem_tests::foot_profile;

namespace
{

/// Why @p profile is refused; nothing if it is not.
std::string refusal(const GlassProfile &profile)
{
  try
  {
    profile.validate();
  }
  catch (const std::invalid_argument &error)
  {
    return error.what();
  }
  return {};
}

} // namespace

TEST(GlassProfile, GapIsTheCrownsParabola)
{
  GlassProfile profile;
  profile.contact_radius = 0.03;
  profile.crown_radius = 0.004;
  EXPECT_EQ(profile.gap(0.03), 0);
  EXPECT_NEAR(profile.gap(0.031), 1.25e-4, 1e-18);
  EXPECT_NEAR(profile.gap(0.028), 5e-4, 1e-18);
  profile.crown_radius = 0;
  EXPECT_EQ(profile.gap(0.031), 0);
}

TEST(GlassProfile, RefusesLengthsThatAreNone)
{
  double GlassProfile::*const lengths[] = { &GlassProfile::contact_radius, &GlassProfile::foot_radius,
                                            &GlassProfile::foot_thickness, &GlassProfile::land_width,
                                            &GlassProfile::land_height,    &GlassProfile::stem_radius,
                                            &GlassProfile::stem_height };
  for (const auto length : lengths)
    for (const double bad :
         { -1e-3, 0., std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity() })
    {
      GlassProfile profile;
      profile.*length = bad;
      EXPECT_THROW(profile.validate(), std::invalid_argument) << bad;
    }
  GlassProfile profile;
  profile.crown_radius = -0.003;
  EXPECT_THROW(profile.validate(), std::invalid_argument);
  profile.crown_radius = 0;
  EXPECT_NO_THROW(profile.validate());
}

TEST(GlassProfile, RefusesPartsThatDoNotFit)
{
  GlassProfile wide_stem;
  wide_stem.stem_radius = 0.0285;
  EXPECT_THROW(wide_stem.validate(), std::invalid_argument);
  GlassProfile wide_land;
  wide_land.land_width = 0.009;
  EXPECT_THROW(wide_land.validate(), std::invalid_argument);
}

TEST(GlassProfile, StepHasPlaneSurfaces)
{
  const GlassProfile profile;
  EXPECT_EQ(profile.underside(0), 0.001);
  EXPECT_EQ(profile.underside(0.030), 0);
  EXPECT_EQ(profile.underside(0.033), 0.001);
  EXPECT_EQ(profile.topside(0.004), 0.015);
  EXPECT_EQ(profile.topside(0.006), 0.005);
  EXPECT_EQ(profile.fillet().middle_radius, profile.stem_radius);
  EXPECT_EQ(profile.stem_surface(0.010), 0.005);
}

TEST(GlassProfile, UndersideOfAFootLeavesTheLandTangentially)
{
  const GlassProfile profile = foot_profile();
  EXPECT_EQ(profile.underside(0), 0.003);
  EXPECT_NEAR(profile.underside(0.014), 0.003 * 9 / 16, 1e-17); // half-way to the land: (1 - 1/4)^2
  for (const double on_land : { 0.028, 0.030, 0.032 })
    EXPECT_EQ(profile.underside(on_land), 0);
  EXPECT_NEAR(profile.underside(0.033), 0.00025, 1e-17);
  EXPECT_NEAR(profile.underside(0.034), 0.001, 1e-17);
  // A slope at the border would leave a height of the first order in the distance.
  for (const double distance : { 1e-4, 1e-5, 1e-6 })
  {
    EXPECT_LT(profile.underside(0.028 - distance), 16 * distance * distance);
    EXPECT_LT(profile.underside(0.032 + distance), 251 * distance * distance);
  }
}

TEST(GlassProfile, TopOfAFootTapersToTheEdge)
{
  const GlassProfile profile = foot_profile();
  const double at_edge = profile.topside(profile.foot_radius);
  EXPECT_NEAR(at_edge - profile.underside(profile.foot_radius), profile.edge_thickness, 1e-17);
  EXPECT_NEAR(profile.foot_top() - profile.underside(profile.stem_radius), profile.foot_thickness, 1e-17);
  // Between the fillet and the edge it is the straight line through these two.
  for (const double radius : { 0.010, 0.020, 0.030 })
    EXPECT_NEAR((profile.topside(radius) - at_edge) / (profile.foot_radius - radius),
                (profile.foot_top() - at_edge) / (profile.foot_radius - profile.stem_radius), 1e-13);
  EXPECT_EQ(profile.topside(0.004), profile.height());
}

TEST(GlassProfile, FilletTouchesStemAndTop)
{
  for (const double rise : { 0.003, 0. })
    for (const double edge : { 0.0015, 0.009 }) // a top that falls outwards, and one that rises
    {
      GlassProfile profile = foot_profile();
      profile.underside_rise = rise;
      profile.edge_thickness = edge;
      const Fillet arc = profile.fillet();
      const auto distance = [&](double radius, double height)
      { return std::hypot(radius - arc.centre_radius, height - arc.centre_height); };
      EXPECT_NEAR(arc.centre_radius - profile.stem_radius, profile.fillet_radius, 1e-17);
      for (const double share : { 0., 0.3, 0.6, 1. })
      {
        const double radius = profile.stem_radius + share * (arc.end_radius - profile.stem_radius);
        EXPECT_NEAR(distance(radius, profile.topside(radius)), profile.fillet_radius, 1e-15);
        const double height = arc.middle_height + share * (arc.centre_height - arc.middle_height);
        EXPECT_NEAR(distance(profile.stem_surface(height), height), profile.fillet_radius, 1e-15);
      }
      // No point of the straight top comes nearer to the centre than the arc's end.
      for (const double away : { -1e-3, -1e-4, 1e-4, 1e-3 })
      {
        const double slope = (profile.topside(0.030) - profile.topside(0.025)) / 0.005;
        EXPECT_GT(distance(arc.end_radius + away, profile.topside(arc.end_radius) + away * slope),
                  profile.fillet_radius);
      }
      EXPECT_NEAR(profile.topside(arc.middle_radius), arc.middle_height, 1e-16);
      EXPECT_NEAR(profile.stem_surface(arc.middle_height), arc.middle_radius, 1e-16);
    }
}

TEST(GlassProfile, RefusalsNameTheEntry)
{
  GlassProfile profile;
  profile.contact_radius = -0.03;
  EXPECT_EQ(
    refusal(profile),
    "Glass/Contact radius = -0.03 m is not a length of the glass; give a finite number greater than 0.");
  profile = GlassProfile();
  profile.stem_radius = 0.029;
  EXPECT_EQ(refusal(profile),
            "Glass/Stem radius = 0.029 m does not fit the foot: it must be smaller than the "
            "inner radius of the land, 0.028 m; change one of the two.");
}

TEST(GlassProfile, RefusesAFootThatIsNone)
{
  EXPECT_EQ(refusal(foot_profile()), "");
  struct Case
  {
    double GlassProfile::*length;
    double value;
    std::string expected;
  };
  for (const Case &bad : {
         Case{ &GlassProfile::edge_thickness, 0, "Glass/Edge thickness = 0 m is not a length of the glass" },
         Case{ &GlassProfile::underside_rise, -1e-3, "Glass/Underside rise = -0.001 m is not a length" },
         Case{ &GlassProfile::fillet_radius, -1e-3, "Glass/Fillet radius = -0.001 m is not a length" },
         Case{ &GlassProfile::fillet_radius, 0.03,
               "Glass/Fillet radius = 0.03 m does not fit between stem and land" },
         Case{ &GlassProfile::stem_height, 0.004, "give a smaller fillet or a longer stem" },
       })
  {
    GlassProfile profile = foot_profile();
    profile.*bad.length = bad.value;
    EXPECT_NE(refusal(profile).find(bad.expected), std::string::npos) << refusal(profile);
    profile.*bad.length = std::numeric_limits<double>::quiet_NaN();
    EXPECT_NE(refusal(profile), "") << bad.expected;
  }
  for (double GlassProfile::*const length :
       { &GlassProfile::edge_thickness, &GlassProfile::underside_rise, &GlassProfile::fillet_radius })
  {
    GlassProfile step; // which has none of these
    step.*length = -1;
    EXPECT_EQ(refusal(step), "");
  }
  GlassProfile pierced =
    foot_profile(); // by a dome under a stem so wide that its top is lower at its surface
  pierced.stem_radius = 0.015;
  pierced.underside_rise = 0.02;
  EXPECT_NE(refusal(pierced).find("Glass/Underside rise = 0.02 m leaves no thickness of glass"),
            std::string::npos)
    << refusal(pierced);
  GlassProfile plain = foot_profile();
  plain.underside_rise = 0;
  plain.fillet_radius = 0;
  EXPECT_EQ(refusal(plain), "");
}

TEST(ElasticMaterial, LameConstantsOfGlass)
{
  // E = 70 GPa, nu = 0.22: K = E / (3 (1 - 2 nu)) = lambda + 2/3 mu and E = mu (3 lambda + 2 mu) / (lambda +
  // mu).
  const ElasticMaterial glass;
  const double lambda = glass.lame_lambda();
  const double mu = glass.shear_modulus();
  EXPECT_NEAR((lambda + 2. / 3 * mu) / (70e9 / (3 * (1 - 0.44))), 1, 1e-14);
  EXPECT_NEAR(mu * (3 * lambda + 2 * mu) / (lambda + mu) / 70e9, 1, 1e-14);
}

TEST(ElasticMaterial, RefusesWhatIsNoMaterial)
{
  for (const double young_modulus : { 0., -70e9, std::numeric_limits<double>::quiet_NaN() })
    EXPECT_THROW(ElasticMaterial({ young_modulus, 0.22 }).validate(), std::invalid_argument);
  for (const double poisson_ratio : { 0.5, -1., std::numeric_limits<double>::quiet_NaN() })
    EXPECT_THROW(ElasticMaterial({ 70e9, poisson_ratio }).validate(), std::invalid_argument);
}
