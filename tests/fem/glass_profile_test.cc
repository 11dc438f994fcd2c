#include "fem/elastic_material.h"
#include "fem/glass_profile.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

using namespace stemware::fem;

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
