#include "fem/geometry/elastic_material.h"
#include "tests/fem/geometry/profile_oracle.h"
#include "tests/ulps.h"

#include <boost/algorithm/string/predicate.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

using stemware::ulps;
using namespace stemware::fem;
using stemware::fem_tests::foot_profile;

namespace
{

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

TEST(GlassProfile, UndersideIsParabolicAndTangentialToTheLand)
{
  const GlassProfile profile = foot_profile();
  EXPECT_EQ(profile.underside(0), 0.003);
  EXPECT_NEAR(profile.underside(0.014), 0.003 * 9 / 16,
              ulps(15, profile.underside_rise)); // half-way to the land: (1 - 1/4)^2 of the rise on the axis
  for (const double on_land : { 0.028, 0.030, 0.032 })
    EXPECT_EQ(profile.underside(on_land), 0);
  EXPECT_NEAR(profile.underside(0.033), 0.00025, ulps(15, profile.underside_rise));
  EXPECT_NEAR(profile.underside(0.034), 0.001, ulps(15, profile.underside_rise));
  // A kink at the border of the land would make the height linear in the distance.
  for (const double distance : { 1e-4, 1e-5, 1e-6 })
  {
    EXPECT_LT(profile.underside(0.028 - distance), 16 * distance * distance);
    EXPECT_LT(profile.underside(0.032 + distance), 251 * distance * distance);
  }
}

TEST(GlassProfile, TopTapersLinearlyToTheEdge)
{
  const GlassProfile profile = foot_profile();
  const double at_edge = profile.topside(profile.foot_radius);
  EXPECT_NEAR(at_edge - profile.underside(profile.foot_radius), profile.edge_thickness,
              ulps(15, profile.underside_rise));
  EXPECT_NEAR(profile.foot_top() - profile.underside(profile.stem_radius), profile.foot_thickness,
              ulps(15, profile.underside_rise));
  for (const double radius : { 0.010, 0.020, 0.030 })
    EXPECT_NEAR((profile.topside(radius) - at_edge) / (profile.foot_radius - radius),
                (profile.foot_top() - at_edge) / (profile.foot_radius - profile.stem_radius), 1e-13);
  EXPECT_EQ(profile.topside(0.004), profile.height());
}

TEST(GlassProfile, FilletIsTangentialToStemAndTop)
{
  for (const double rise : { 0.003, 0. })
    for (const double edge : { 0.0015, 0.009 })
    {
      GlassProfile profile = foot_profile();
      profile.underside_rise = rise;
      profile.edge_thickness = edge;
      const Fillet arc = profile.fillet();
      const auto distance = [&](double radius, double height)
      { return std::hypot(radius - arc.centre_radius, height - arc.centre_height); };
      EXPECT_NEAR(arc.centre_radius - profile.stem_radius, profile.fillet_radius,
                  ulps(9, profile.fillet_radius));
      for (const double share : { 0., 0.3, 0.6, 1. })
      {
        const double radius = profile.stem_radius + share * (arc.end_radius - profile.stem_radius);
        EXPECT_NEAR(distance(radius, profile.topside(radius)), profile.fillet_radius,
                    ulps(40, profile.fillet_radius));
        const double height = arc.middle_height + share * (arc.centre_height - arc.middle_height);
        EXPECT_NEAR(distance(profile.stem_surface(height), height), profile.fillet_radius,
                    ulps(40, profile.fillet_radius));
      }
      // The end of the arc is the point of the straight top that is closest to the centre of the arc.
      for (const double away : { -1e-3, -1e-4, 1e-4, 1e-3 })
      {
        const double slope = (profile.topside(0.030) - profile.topside(0.025)) / 0.005;
        EXPECT_GT(distance(arc.end_radius + away, profile.topside(arc.end_radius) + away * slope),
                  profile.fillet_radius);
      }
      EXPECT_NEAR(profile.topside(arc.middle_radius), arc.middle_height, ulps(40, profile.fillet_radius));
      EXPECT_NEAR(profile.stem_surface(arc.middle_height), arc.middle_radius,
                  ulps(40, profile.fillet_radius));
    }
}

TEST(GlassProfile, RefusesInvalidLengthsAndNamesThem)
{
  struct Case
  {
    double GlassProfile::*length;
    std::vector<double> bad;
    std::string quantity;
    bool of_both_shapes = true;
  };
  for (const Case &given : {
         Case{ &GlassProfile::contact_radius, { -0.03, 0 }, "Contact radius" },
         Case{ &GlassProfile::foot_radius, { -0.03, 0 }, "Foot radius" },
         Case{ &GlassProfile::foot_thickness, { -0.03, 0 }, "Foot thickness" },
         Case{ &GlassProfile::land_width, { -0.03, 0, 0.009 }, "Land width" },
         Case{ &GlassProfile::land_height, { -0.03, 0 }, "Land height" },
         Case{ &GlassProfile::stem_radius, { -0.03, 0, 0.029 }, "Stem radius" },
         Case{ &GlassProfile::stem_height, { -0.03, 0 }, "Stem height" },
         Case{ &GlassProfile::crown_radius, { -0.03 }, "Crown radius" },
         Case{ &GlassProfile::edge_thickness, { -0.03, 0 }, "Edge thickness", false },
         Case{ &GlassProfile::underside_rise, { -0.03 }, "Underside rise", false },
         Case{ &GlassProfile::fillet_radius, { -0.03, 0.03 }, "Fillet radius", false },
       })
    for (const GlassShape shape : { GlassShape::foot, GlassShape::step })
    {
      std::vector<double> values = given.bad;
      values.insert(values.end(), { std::nan(""), std::numeric_limits<double>::infinity() });
      for (const double value : values)
      {
        GlassProfile profile;
        profile.shape = shape;
        profile.*given.length = value;
        const std::string sentence = refusal(profile);
        if (shape == GlassShape::step && !given.of_both_shapes)
          EXPECT_EQ(sentence, ""); // a step does not use this entry
        else
          EXPECT_TRUE(boost::icontains(sentence, given.quantity)) << value << sentence;
      }
    }
  GlassProfile short_stem = foot_profile(); // the stem is lower than the fillet
  short_stem.stem_height = 0.004;
  EXPECT_NE(refusal(short_stem), "");
  GlassProfile pierced = foot_profile(); // the underside rises above the top at the radius of the stem
  pierced.stem_radius = 0.015;
  pierced.underside_rise = 0.02;
  EXPECT_EQ(refusal(pierced).rfind("Underside rise = ", 0), 0u) << refusal(pierced);
  GlassProfile plain = foot_profile();
  plain.crown_radius = plain.underside_rise = plain.fillet_radius = 0;
  EXPECT_EQ(refusal(plain), "");
  EXPECT_EQ(refusal(foot_profile()), "");
}

TEST(ElasticMaterial, RefusesInvalidConstants)
{
  for (const double young_modulus : { 0., -70e9, std::numeric_limits<double>::quiet_NaN() })
    EXPECT_THROW(ElasticMaterial({ young_modulus, 0.22 }).validate(), std::invalid_argument);
  for (const double poisson_ratio : { 0.5, -1., std::numeric_limits<double>::quiet_NaN() })
    EXPECT_THROW(ElasticMaterial({ 70e9, poisson_ratio }).validate(), std::invalid_argument);
}
