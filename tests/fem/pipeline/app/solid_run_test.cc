#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

namespace stemware::test
{
namespace
{

const std::vector<std::string> flat_land = {
  "Motion/Friction coefficient=0.3", "Motion/End time=0.2",           "Glass/Shape=step",
  "Glass/Land width=0.002",          "Glass/Crown radius=0",          "Table/Interface=Winkler",
  "Table/Substrate=rigid",           "Table/Foundation modulus=1e10", "Contact/Harmonics=16",
  "Contact/Azimuth lines=64",        "Contact/Radial cells=2",        "Contact/Foot layers=1"
};

double truncated_spin(const std::string &setting)
{
  const ScratchFolder scratch;
  return solved(scratch, with_settings({ "truncate" }, flat_land),
                { "Contact/Load harmonics=8", "Contact/Azimuthal cells=24", setting })["truncation"]
    .back()["omega_terminal"];
}

TEST(SolidRun, FirstHarmonicSpinAgreesWithARingIfTheContactIsACircleOfNodes)
{
  // A thick foot of linear elements on a hard table is in contact only at the nodes on the contact radius.
  // Without tilt, the spin of the first harmonic equals the closed form for a ring (second budget row).
  const std::vector<std::string> thick_foot = { "Motion/Mass=0.566464",
                                                "Motion/Centre of mass height=0.0531084",
                                                "Motion/Force offset=-0.05",
                                                "Motion/Orbit radius=0.0797628",
                                                "Motion/Orbit speed=0.0522861",
                                                "Motion/Orbit sense=clockwise",
                                                "Motion/Friction coefficient=0.0294098",
                                                "Motion/Tilt=neglected",
                                                "Glass/Contact radius=0.0448206",
                                                "Glass/Foot radius=0.0482618",
                                                "Glass/Foot thickness=0.00854572",
                                                "Glass/Land width=0.00558439",
                                                "Glass/Land height=0.00192998",
                                                "Glass/Crown radius=0.00536798",
                                                "Glass/Stem radius=0.0055316",
                                                "Glass/Stem height=0.00478865",
                                                "Glass/Young modulus=3.63862 GPa",
                                                "Glass/Poisson ratio=0.245367",
                                                "Glass/Underside rise=0.00136932",
                                                "Glass/Edge thickness=0.00151386",
                                                "Glass/Fillet radius=0",
                                                "Table/Interface=hard",
                                                "Table/Substrate=rigid",
                                                "Contact/Friction coupling=none",
                                                "Contact/Body=solid",
                                                "Contact/Azimuthal cells=24",
                                                "Contact/Radial cells=2",
                                                "Contact/Foot layers=1",
                                                "Contact/Degree=1" };
  const auto budget = solved(ScratchFolder(), { "run" }, thick_foot)["budget"];
  ASSERT_EQ(budget[1]["step"], "2");
  const double ring = budget[1]["omega_terminal"];
  EXPECT_GT(std::abs(ring), 1e-3);
  EXPECT_NEAR(budget[2]["omega_terminal"].get<double>(), ring, 1e-7 * ring);
}

TEST(SolidRun, TerminalSpinAgreesWithTheBodyOfRevolutionIncludingFrictionCoupling)
{
  const double expected = truncated_spin("Contact/Body=revolution");
  EXPECT_NEAR(truncated_spin("Contact/Body=solid") / expected, 1, 1e-4);
  const double without = truncated_spin("Contact/Friction coupling=none");
  EXPECT_GT(std::abs(without / expected - 1), 1e-3);
}

/// Settings of a coarse solid foot with an accuracy goal. The error estimate takes one second.
const std::vector<std::string> coarse_with_goal = { "Contact/Body=solid",
                                                    "Contact/Degree=1",
                                                    "Contact/Azimuthal cells=12",
                                                    "Contact/Load harmonics=4",
                                                    "Contact/Goal=torque",
                                                    "Contact/Goal tolerance=1",
                                                    "Contact/Friction coupling=none",
                                                    "Load/Coupling=one-way",
                                                    "Motion/Tilt=neglected" };

Ended run_with_goal(const ScratchFolder &scratch, const std::vector<std::string> &verb,
                    std::vector<std::string> launcher = {})
{
  launcher.push_back(STEMWARE_PROGRAM);
  launcher.insert(launcher.end(), verb.begin(), verb.end());
  launcher.insert(launcher.end(), { "--quiet", "--output", "results" });
  return RunningProgram(with_settings(with_settings(launcher, flat_land), coarse_with_goal), scratch.path())
    .end();
}

TEST(SolidRun, TruncateAndSweepAcceptAGoal)
{
  for (const std::vector<std::string> &verb :
       { std::vector<std::string>{ "truncate" }, { "sweep", "--vary", "Motion/Mass=0.31" } })
  {
    const ScratchFolder scratch;
    const Ended ended = run_with_goal(scratch, verb);
    EXPECT_EQ(ended.exit_code, 0) << verb.front() << ": " << ended.err;
    EXPECT_TRUE(std::filesystem::exists(scratch / "results/summary.json")) << verb.front();
  }
}

TEST(SolidRun, ReportsTheSameMeshErrorOfTheGoalOnTwoRanks)
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
