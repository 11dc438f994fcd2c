// The paper's ansatz through the whole program, against figures that were computed with 22 and more digits.
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

#include <cmath>

namespace stemware::test
{
namespace
{

const std::string first_harmonic = "Load/Source=first harmonic";

TEST(FirstHarmonicRun, LiftOffIsJudgedByTheFullMoment)
{
  const ScratchFolder scratch;
  const nlohmann::json full = solved(scratch, { "run" }, { first_harmonic }),
                       hand = solved(scratch, { "run" }, { first_harmonic, "Motion/Closure=hand" });
  EXPECT_NEAR(full["ring"]["omega_terminal"].get<double>(), -3.67874799852576, 1e-10);
  EXPECT_NEAR(hand["ring"]["omega_terminal"].get<double>(), -5.03205140582681, 1e-10);
  EXPECT_TRUE(full["ring"]["no_lift_off"].get<bool>());
  EXPECT_FALSE(hand["ring"]["no_lift_off"].get<bool>());
  EXPECT_NEAR(hand["load"]["moment_ratio"].get<double>(), 1.037787677770, 1e-12);
  EXPECT_LT(hand["load"]["minimum"].get<double>(), 0);
  EXPECT_LT(hand["load"]["contact_fraction"].get<double>(), 1);
}

TEST(FirstHarmonicRun, SpinUpPassesThroughTheReference)
{
  const ScratchFolder scratch;
  solved(scratch, { "run" },
         { first_harmonic, "Motion/Closure=paper", "Motion/Yaw inertia=1.35e-4", "Motion/End time=0.2" });
  const auto columns = read_columns(scratch / "results/spin_up.csv");
  EXPECT_DOUBLE_EQ(columns[0][100], 0.1);
  EXPECT_NEAR(columns[1][100], -1.8314764495450, 1e-9);
  EXPECT_NEAR(columns[1][200], -2.5963912211184, 1e-9);
  // Forward Euler in steps of 1 ms is close, but not that close.
  EXPECT_NEAR(columns[2][100], columns[1][100], 2e-2);
  EXPECT_GT(std::abs(columns[2][100] - columns[1][100]), 1e-4);
}

} // namespace
} // namespace stemware::test
