#include "tests/fem/pipeline/matchers.h"
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace stemware::test
{
namespace
{

const std::string ring = "Load/Source=first harmonic";

TEST(FitRun, PutsTheFitIntoSummaryTableAndStudy)
{
  const ScratchFolder scratch;
  scratch.write("run.csv",
                "t (s);omega (rad/s)\n0;0,02\n0,1;-1,4\n0,2;-2,3\n0,3;-2,85\n0,4;-3,1\n0,5;-3,35\n1;-3,6\n");
  const Ended ended =
    stemware(scratch, { "fit", "--data", "run.csv", "--free", "Motion/Friction coefficient", "--free",
                        "Motion/Yaw inertia = 3000 +- 50 g cm^2", "--set", ring, "--quiet", "--json" });
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  const nlohmann::json line = nlohmann::json::parse(ended.out);
  EXPECT_EQ(line["verb"], "fit");
  const nlohmann::json fit = read_summary(scratch / line["results"].get<std::string>())["fit"];
  ASSERT_EQ(fit["entries"].size(), 2u);
  EXPECT_EQ(fit["entries"][0]["value"], line["Motion/Friction coefficient"][0]);
  EXPECT_EQ(fit["runs"][0]["points"], 7);
  // The prior is ten times narrower than what seven points tell.
  EXPECT_NEAR(fit["entries"][1]["spread"].get<double>(), 5e-6, 1e-6);
  const Ended again = stemware(scratch, { "run", line["results"].get<std::string>() + "/parameters.prm",
                                          "--quick", "--quiet", "--output", "again" });
  EXPECT_EQ(again.exit_code, 0) << again.err;
}

// Eight points tell friction and grip together only: their profiles lead to glasses that tip.
TEST(FitRun, ProfilesEndWhereTheGlassTips)
{
  const ScratchFolder scratch;
  scratch.write("run.csv", "t,omega\n0,0\n0.1,-1.44\n0.2,-2.32\n0.3,-2.84\n0.4,-3.15\n0.5,-3.38\n"
                           "0.7,-3.55\n1,-3.63\n");
  const Ended ended = stemware(scratch, { "fit", "--data", "run.csv", "--free", "Motion/Friction coefficient",
                                          "--free", "Motion/Grip torque", "--quiet", "--output", "results" });
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  const nlohmann::json entry = read_summary(scratch / "results")["fit"]["entries"][1];
  EXPECT_GT(entry["spread"].get<double>(), entry["value"].get<double>());
}

TEST(FitRun, RefusesWhatCannotBeFittedInOneSentence)
{
  const ScratchFolder scratch;
  const std::string data = scratch.write("run.csv", "t,omega\n0,0\n1,-1\n2,-2\n3,-3\n4,-3\n"),
                    steady = scratch.write("steady.csv", "t,omega\n0,-3\n1,-3\n2,-3\n3,-3\n4,-3\n"),
                    goal_mesh = scratch.write(
                      "goal.prm", "subsection Contact\n  set Body = solid\n  set Goal = a2\nend\n");
  for (const auto &[arguments, words] : std::vector<std::pair<std::vector<std::string>, std::string>>{
         { { "fit", "--free", "Motion/Mass" }, "--data" },
         { { "fit", "--data", data }, "--free" },
         { { "fit", "--data", data, "--free", "Motion/Closure" }, "no number" },
         { { "fit", "--data", "none.csv", "--free", "Motion/Mass" }, "none.csv" },
         { { "fit", "--data", steady, "--free", "Motion/Mass" }, "all values are equal" },
         { { "fit", "--data", data, "--free", "Motion/Mass = 3" }, "prior" },
         { { "fit", goal_mesh, "--data", data, "--free", "Motion/Mass" }, "Contact/Goal = none" } })
  {
    std::vector<std::string> all = arguments;
    if (all[1] != goal_mesh)
      all.insert(all.begin() + 1, { "--set", ring });
    const Ended ended = stemware(scratch, all);
    EXPECT_EQ(ended.exit_code, 1) << words;
    EXPECT_THAT(ended.err, testing::HasSubstr(words));
  }
}

} // namespace
} // namespace stemware::test
