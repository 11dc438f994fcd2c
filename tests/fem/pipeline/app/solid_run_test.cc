// Studies with a solid foot in balance with its friction. Oracle: the body of revolution, whose friction is a
// column of compliances.
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

namespace stemware::test
{
namespace
{

/// A flat land of 2 mm on a mat; full moment balance, tilt and friction in the foot are the defaults.
const char *flat_land = R"(
subsection Motion
  set Friction coefficient = 0.3
  set End time = 0.2
end
subsection Glass
  set Shape = step
  set Land width = 0.002
  set Crown radius = 0
end
subsection Table
  set Interface = Winkler
  set Substrate = rigid
  set Foundation modulus = 1e10
end
subsection Contact
  set Harmonics = 16
  set Azimuth lines = 64
  set Load harmonics = 8
  set Azimuthal cells = 24
  set Radial cells = 2
  set Foot layers = 1
end
)";

/// The terminal spin with all harmonics, by the verb that asks for no more than that.
double truncated_spin(const ScratchFolder &scratch, const std::vector<std::string> &settings)
{
  std::vector<std::string> arguments = { "truncate", scratch.write("flat.prm", flat_land), "--output",
                                         "results" };
  for (const std::string &setting : settings)
    arguments.insert(arguments.end(), { "--set", setting });
  const Ended ended = stemware(scratch, arguments);
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  return read_summary(scratch / "results")["truncation"].back()["omega_terminal"].get<double>();
}

TEST(SolidRun, OnOneCircleOfNodesTheBalanceIsThatOfARing)
{
  // A thick foot of linear elements on a hard table touches with the nodes at the contact radius alone.
  // Without tilt the balance is then that of a first harmonic on the ring, a closed form: the second row of
  // the budget.
  const ScratchFolder scratch;
  const std::string study = scratch.write("thick.prm", R"(
subsection Motion
  set Mass = 0.566464
  set Centre of mass height = 0.0531084
  set Force offset = -0.0794324
  set Orbit radius = 0.0797628
  set Orbit speed = 0.0522861
  set Orbit sense = clockwise
  set Friction coefficient = 0.0294098
  set Tilt = neglected
end
subsection Glass
  set Contact radius = 0.0448206
  set Foot radius = 0.0482618
  set Foot thickness = 0.00854572
  set Land width = 0.00558439
  set Land height = 0.00192998
  set Crown radius = 0.00536798
  set Stem radius = 0.0055316
  set Stem height = 0.00478865
  set Young modulus = 3.63862 GPa
  set Poisson ratio = 0.245367
  set Underside rise = 0.00136932
  set Edge thickness = 0.00151386
  set Fillet radius = 0
end
subsection Table
  set Interface = hard
end
subsection Contact
  set Friction coupling = none
  set Body = solid
  set Azimuthal cells = 24
  set Radial cells = 2
  set Foot layers = 1
  set Degree = 1
end
)");
  const Ended ended = stemware(scratch, { "run", study, "--output", "results" });
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  const auto budget = read_summary(scratch / "results")["budget"];
  ASSERT_EQ(budget[1]["step"], "2");
  const double ring = budget[1]["omega_terminal"];
  EXPECT_NEAR(ring, 0.0144540, 1e-7);
  EXPECT_NEAR(budget[2]["omega_terminal"].get<double>(), ring, 1e-7 * ring); // n <= 1 of the contact
}

TEST(SolidRun, TerminalSpinIsThatOfTheBodyOfRevolution)
{
  const ScratchFolder scratch;
  const auto spin = [&](const std::string &setting)
  { return truncated_spin(scratch, { "Contact/Body=" + setting }); };
  const double expected = spin("revolution");
  EXPECT_NEAR(spin("solid") / expected, 1, 1e-4);
  // What friction in the foot does.
  const double without = truncated_spin(scratch, { "Contact/Friction coupling=none" });
  EXPECT_GT(std::abs(without / expected - 1), 1e-3);
}

/// Settings of a solid foot that is so coarse that an estimate of its error takes a second.
const std::vector<std::string> coarse_with_goal = { "Contact/Body=solid",
                                                    "Contact/Degree=1",
                                                    "Contact/Azimuthal cells=12",
                                                    "Contact/Load harmonics=4",
                                                    "Contact/Goal=torque",
                                                    "Contact/Goal tolerance=1",
                                                    "Contact/Friction coupling=none",
                                                    "Load/Coupling=one-way",
                                                    "Motion/Tilt=neglected" };

/// Runs @p verb on such a foot, behind @p launcher.
Ended run_with_goal(const ScratchFolder &scratch, const std::vector<std::string> &verb,
                    std::vector<std::string> launcher = {})
{
  launcher.push_back(STEMWARE_PROGRAM);
  launcher.insert(launcher.end(), verb.begin(), verb.end());
  launcher.insert(launcher.end(), { scratch.write("flat.prm", flat_land), "--quiet", "--output", "results" });
  for (const std::string &setting : coarse_with_goal)
    launcher.insert(launcher.end(), { "--set", setting });
  return RunningProgram(launcher, scratch.path()).end();
}

TEST(SolidRun, EveryVerbTakesAGoal)
{
  for (const std::vector<std::string> &verb :
       { std::vector<std::string>{ "truncate" }, { "sweep", "--vary", "Motion/Mass=0.3:0.31:2" } })
  {
    const ScratchFolder scratch;
    const Ended ended = run_with_goal(scratch, verb);
    EXPECT_EQ(ended.exit_code, 0) << verb.front() << ": " << ended.err;
    EXPECT_TRUE(std::filesystem::exists(scratch / "results/summary.json")) << verb.front();
  }
}

TEST(SolidRun, SaysWhatItsMeshLeavesOfTheGoal)
{
  const auto summary_on = [](const std::vector<std::string> &launcher)
  {
    const ScratchFolder scratch;
    const Ended ended = run_with_goal(scratch, { "run" }, launcher);
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    return read_summary(scratch / "results");
  };
  const auto one = summary_on({}), two = summary_on({ STEMWARE_MPIRUN, "-n", "2" });
  const auto &alone = one["goal"], &together = two["goal"];
  EXPECT_EQ(alone["name"], "torque");
  EXPECT_EQ(alone["meshes"], 1);
  EXPECT_EQ(alone["tolerance"], 1);
  EXPECT_LT(std::abs(alone["estimated_error"].get<double>()), std::abs(alone["value"].get<double>()));
  EXPECT_EQ(together["cells"], alone["cells"]);
  EXPECT_EQ(together["unknowns"], alone["unknowns"]);
  EXPECT_NEAR(together["value"].get<double>() / alone["value"].get<double>(), 1, 1e-8);
  EXPECT_NEAR(together["estimated_error"].get<double>() / alone["estimated_error"].get<double>(), 1, 1e-3);
  const auto band_of = [](const nlohmann::json &summary)
  { return summary["error_bands"]["omega_terminal"]["band"].get<double>(); };
  EXPECT_GT(band_of(one), 0);
  EXPECT_NEAR(band_of(two) / band_of(one), 1, 1e-4);
}

} // namespace
} // namespace stemware::test
