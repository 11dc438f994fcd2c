// The program as it is built where deal.II has no MPI, p4est and Trilinos.
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

namespace stemware
{
namespace
{

using namespace test;

Ended without_solid(const ScratchFolder &scratch, std::vector<std::string> arguments)
{
  arguments.insert(arguments.begin(), STEMWARE_PROGRAM_WITHOUT_SOLID);
  return RunningProgram(arguments, scratch.path()).end();
}

TEST(WithoutSolid, ABodyOfRevolutionIsWhatItIs)
{
  const ScratchFolder scratch;
  const std::string study = scratch.write("study.prm", plain_study());
  ASSERT_EQ(without_solid(scratch, { "run", study, "--quick", "--quiet", "--output", "without" }).exit_code,
            0);
  ASSERT_EQ(stemware(scratch, { "run", study, "--quick", "--quiet", "--output", "with" }).exit_code, 0);
  EXPECT_EQ(read_summary(scratch / "without")["ring"], read_summary(scratch / "with")["ring"]);
}

TEST(WithoutSolid, ASolidFootIsRefusedByEachVerbThatWouldSolveIt)
{
  const ScratchFolder scratch;
  const std::string study = scratch.write("study.prm", coarse_study());
  for (const std::string verb : { "run", "converge", "truncate", "compare" })
  {
    const Ended ended = without_solid(scratch, { verb, study, "--output", "results" });
    EXPECT_EQ(ended.exit_code, 1) << verb;
    EXPECT_NE(ended.err.find("Contact/Body = solid needs a Stemware with MPI, p4est and Trilinos"),
              std::string::npos)
      << verb << ": " << ended.err;
    EXPECT_EQ(names_in(scratch.path()), std::vector<std::string>{ "study.prm" }) << verb;
  }
  const Ended sweep = without_solid(
    scratch, { "sweep", study, "--vary", "Motion/Orbit speed=0.3:0.35:2", "--output", "results" });
  EXPECT_EQ(sweep.exit_code, 1);
  EXPECT_NE(sweep.err.find("Contact/Body = solid needs"), std::string::npos) << sweep.err;
}

TEST(WithoutSolid, AMeshOfASolidFootCanStillBeLookedAt)
{
  const ScratchFolder scratch;
  const std::string study = scratch.write("study.prm", coarse_study());
  EXPECT_EQ(without_solid(scratch, { "mesh", study, "--write", "foot.msh" }).exit_code, 0);
  EXPECT_TRUE(std::filesystem::exists(scratch / "foot.msh"));
}

} // namespace
} // namespace stemware
