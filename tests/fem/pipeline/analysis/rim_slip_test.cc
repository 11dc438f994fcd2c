#include "ring_model/spin/curves.h"

#include <gtest/gtest.h>

#include <cmath>

namespace stemware::pipeline
{
namespace
{

/// Load 1 + 1.5 sin(theta), negative (tensile) around theta = 270 degrees.
const ring::RingStack load({ 1, 0 }, { 0, 1.5 }, 0.03);

TEST(RimSlip, FrictionOpposesTheMotionWithoutSpin)
{
  ring::Motion motion;
  const std::vector<ring::RimSlip> places = ring::rim_slip(motion, 0.03, load, 0);
  ASSERT_EQ(places.size(), 24u);
  for (const ring::RimSlip &place : places)
  {
    EXPECT_EQ(place.slip_x, 1);
    EXPECT_EQ(place.slip_y, 0);
    EXPECT_NEAR(place.friction_x, -std::max(0., 1 + 1.5 * std::sin(place.azimuth)), 1e-12);
    EXPECT_EQ(place.friction_y, 0);
  }
  EXPECT_EQ(places[18].friction_x, 0); // theta = 270 degrees
}

TEST(RimSlip, VanishesOnTheLeftAndIsDiagonalInFrontAtSlipRatioOne)
{
  ring::Motion motion;
  const double radius = 0.03, omega = motion.orbit_speed / radius; // slip ratio 1
  const std::vector<ring::RimSlip> places = ring::rim_slip(motion, radius, load, omega);
  EXPECT_NEAR(places[6].slip_x, 0, 1e-12); // theta = 90 degrees
  EXPECT_NEAR(places[0].slip_x, 1, 1e-12);
  EXPECT_NEAR(places[0].slip_y, 1, 1e-12);
  EXPECT_NEAR(places[0].friction_y, -std::sqrt(0.5), 1e-12);
}

} // namespace
} // namespace stemware::pipeline
