// The paper's ansatz through the whole program, against figures that were computed with 22 and more digits.
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

#include <cmath>

namespace stemware::test
{
namespace
{

/// summary.json of a first-harmonic study.
nlohmann::json run_ring(const ScratchFolder &scratch, const std::vector<std::string> &settings)
{
  std::vector<std::string> arguments = { "run",      scratch.write("study.prm", "# defaults\n"),
                                         "--output", "results",
                                         "--set",    "Load/Source=first harmonic" };
  for (const std::string &setting : settings)
    arguments.insert(arguments.end(), { "--set", setting });
  const Ended ended = stemware(scratch, arguments);
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  return read_summary(scratch / "results");
}

void expect_relative(const nlohmann::json &value, double expected, const std::string &what)
{
  EXPECT_NEAR(value.get<double>(), expected, 1e-10 * std::abs(expected)) << what;
}

struct TerminalSpin
{
  std::string closure;
  std::string centre_of_mass_height;
  double omega;
};

std::ostream &operator<<(std::ostream &stream, const TerminalSpin &spin)
{
  return stream << spin.closure << " at " << spin.centre_of_mass_height;
}

class ClosureRun : public testing::TestWithParam<TerminalSpin>
{
};

TEST_P(ClosureRun, ReachesTheTerminalSpinOfTheReference)
{
  const ScratchFolder scratch;
  const auto summary =
    run_ring(scratch, { "Motion/Closure=" + GetParam().closure,
                        "Motion/Centre of mass height=" + GetParam().centre_of_mass_height });
  expect_relative(summary["ring"]["tau_at_rest"], -0.003675, "torque at rest");
  expect_relative(summary["ring"]["tau_closed_form"], -0.003675, "closed form");
  expect_relative(summary["ring"]["omega_terminal"], GetParam().omega, "terminal spin");
  expect_relative(summary["budget"][0]["omega_terminal"], -3.12055870152586, "the paper's model");
  expect_relative(summary["budget"][1]["omega_terminal"], GetParam().omega, "its moment balance");
  EXPECT_EQ(summary["truncation"].size(), 1u);
  EXPECT_TRUE(summary["contact"].is_null());
}

INSTANTIATE_TEST_SUITE_P(FirstHarmonic, ClosureRun,
                         testing::Values(TerminalSpin{ "paper", "0.08", -3.12055870152586 },
                                         TerminalSpin{ "full", "0.08", -3.67874799852576 },
                                         TerminalSpin{ "full", "0.06", -3.17573357712208 },
                                         TerminalSpin{ "hand", "0.08", -5.03205140582681 }),
                         [](const auto &info)
                         { return info.param.closure + "_" + info.param.centre_of_mass_height.substr(2); });

TEST(FirstHarmonicRun, LiftOffIsJudgedByTheFullMoment)
{
  const ScratchFolder scratch;
  EXPECT_TRUE(run_ring(scratch, { "Motion/Closure=full" })["ring"]["no_lift_off"].get<bool>());
  const auto hand = run_ring(scratch, { "Motion/Closure=hand" });
  EXPECT_FALSE(hand["ring"]["no_lift_off"].get<bool>());
  EXPECT_NEAR(hand["load"]["moment_ratio"].get<double>(), 1.037787677770, 1e-12);
  EXPECT_LT(hand["load"]["minimum"].get<double>(), 0);
  EXPECT_LT(hand["load"]["contact_fraction"].get<double>(), 1);
}

TEST(FirstHarmonicRun, SpinUpPassesThroughTheReference)
{
  const ScratchFolder scratch;
  run_ring(scratch, { "Motion/Closure=paper", "Motion/Yaw inertia=1.35e-4", "Motion/End time=0.2" });
  const auto columns = read_columns(scratch / "results/spin_up.csv");
  EXPECT_DOUBLE_EQ(columns[0][100], 0.1);
  EXPECT_NEAR(columns[1][100], -1.8314764495450, 1e-9);
  EXPECT_NEAR(columns[1][200], -2.5963912211184, 1e-9);
  // Forward Euler in steps of 1 ms is close, but not that close.
  EXPECT_NEAR(columns[2][100], columns[1][100], 2e-2);
  EXPECT_GT(std::abs(columns[2][100] - columns[1][100]), 1e-4);
}

TEST(FirstHarmonicRun, StaticStudyHasTheGivenLoad)
{
  const ScratchFolder scratch;
  const auto summary =
    run_ring(scratch, { "Load/Moment ratio=0.5", "Load/Moment direction=-1.5707963267948966" });
  const double a0 = summary["load"]["a"][0];
  EXPECT_NEAR(summary["load"]["b"][1].get<double>(), -0.5 * a0, 1e-15);
  EXPECT_NEAR(summary["load"]["a"][1].get<double>(), 0, 1e-15);
  // Slip ratio 0.44835570083247 at m = 0.5 for a radial first harmonic.
  expect_relative(summary["ring"]["omega_terminal"], -0.44835570083247 * 0.35 / 0.03, "terminal spin");
}

} // namespace
} // namespace stemware::test
