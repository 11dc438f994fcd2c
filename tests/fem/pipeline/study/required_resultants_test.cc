#include "fem/pipeline/base/failures.h"
#include "fem/pipeline/study/study.h"
#include "ring_model/failures.h"
#include "tests/fem/pipeline/matchers.h"
#include "tests/fem/pipeline/refusal.h"
#include "tests/ulps.h"

#include <gtest/gtest.h>

#include <cmath>

namespace stemware::pipeline
{
namespace
{

TEST(RequiredResultants, PaperClosureGivesOnlyTheMomentAboutTheXAxis)
{
  Study study;
  study.motion.closure = ring::Closure::paper;
  const fem::Resultants load = study.required_resultants();
  EXPECT_DOUBLE_EQ(load.normal_force, 2.943);
  EXPECT_DOUBLE_EQ(load.moment_x, -0.05 * 0.3 * 0.35 * 0.35 / 0.15);
  EXPECT_EQ(load.moment_y, 0);
  EXPECT_NEAR(moment_ratio(load, 0.03), 0.277494620002, 1e-12);
}

TEST(RequiredResultants, FullClosureAddsTheMomentOfTheFriction)
{
  const Study study;
  const fem::Resultants load = study.required_resultants();
  EXPECT_DOUBLE_EQ(load.moment_x, -0.01225);
  // M_Ny = -z_F mu N for the hand at z_F = 3 cm above the table.
  EXPECT_NEAR(load.moment_y, -0.03 * 0.3 * 2.943, ulps(4, load.moment_y));
}

TEST(RequiredResultants, ReproduceTheGivenMomentRatioAndDirection)
{
  for (const double direction : { -3., -1.5, 0., 0.7, 2. })
  {
    Study study;
    study.load.moment_ratio = 1.3;
    study.load.moment_direction = direction;
    const fem::Resultants load = study.required_resultants();
    EXPECT_NEAR(moment_ratio(load, 0.03), 1.3, 1e-14);
    // The centre of pressure lies at (-M_Ny, M_Nx) / N, because (M_Nx, M_Ny) = (sum y f, -sum x f).
    EXPECT_NEAR(std::atan2(load.moment_x, -load.moment_y), direction, 1e-14);
  }
}

TEST(RequiredResultants, MomentJustAboveTheTippingLimitIsPrintedWithEnoughDigits)
{
  Study study;
  study.motion.closure = ring::Closure::paper;
  study.motion.orbit.force_offset *= 2 * (1 + 1e-9) / moment_ratio(study.required_resultants(), 0.03);
  try
  {
    study.required_resultants();
    ADD_FAILURE() << "not refused";
  }
  catch (const ring::Tipping &falls)
  {
    EXPECT_THAT(falls.what(), testing::HasSubstr("0.0882900001 N m"));
  }
}

} // namespace
} // namespace stemware::pipeline
