#include "tests/fem/pipeline/matchers.h"
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

namespace stemware::test
{
TEST(StudyOptions, QuietPrintsNothing)
{
  const ScratchFolder scratch;
  const Ended ended = stemware(scratch, { "run", "--set", "Load/Source=first harmonic", "--quiet" });
  EXPECT_EQ(ended.exit_code, 0);
  EXPECT_EQ(ended.out, "");
  EXPECT_EQ(ended.err, "");
  EXPECT_EQ(read_summary(scratch / "results/default")["verb"], "run");
}

TEST(StudyOptions, JsonPrintsOneLineWithTheNumbersOfTheSummary)
{
  const ScratchFolder scratch;
  const Ended ended =
    stemware(scratch, { "run", "--set", "Load/Source=first harmonic", "--json", "--output", "there" });
  EXPECT_EQ(ended.exit_code, 0);
  const auto line = nlohmann::json::parse(ended.out);
  EXPECT_EQ(std::count(ended.out.begin(), ended.out.end(), '\n'), 1);
  EXPECT_EQ(line["verb"], "run");
  EXPECT_EQ(line["results"], "there");
  EXPECT_EQ(line["summary"], "there/summary.json");
  const auto summary = read_summary(scratch / "there");
  EXPECT_EQ(line["omega_terminal"], summary["ring"]["omega_terminal"]);
  EXPECT_EQ(line["tau_at_rest"], summary["ring"]["tau_at_rest"]);
  EXPECT_THAT(ended.err, testing::HasSubstr("Results   there"));
}

TEST(StudyOptions, ConsoleTextIsAtMost100ColumnsWide)
{
  const ScratchFolder scratch;
  const Ended ended = stemware(
    scratch, { "run", scratch.write("study.prm", coarse_study()), "--set", "Load/Moment ratio=1.3" });
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_EQ(bad_lines(ended.out + ended.err), "");
  const std::string study = scratch.write("default.prm", plain_study());
  for (const std::vector<std::string> &verb :
       { std::vector<std::string>{ "truncate", study }, { "converge", study, "--levels", "2" } })
  {
    const Ended other =
      stemware(scratch, with_settings(verb, { "Contact/Azimuth lines=64", "Contact/Harmonics=6" }));
    EXPECT_EQ(other.exit_code, 0) << other.err;
    EXPECT_EQ(bad_lines(other.out + other.err), "");
  }
}

} // namespace stemware::test
