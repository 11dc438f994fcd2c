// The program without its modules, as where they were not built.
#include "tests/fem/pipeline/matchers.h"
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace stemware
{
namespace
{

using namespace test;
namespace fs = std::filesystem;

/// A copy of the program in a folder with the module of the finite elements, or alone.
class PartOfProgram
{
public:
  explicit PartOfProgram(bool with_fem)
  {
    fs::create_directory(scratch / "program");
    fs::copy(STEMWARE_PROGRAM, scratch / "program/stemware");
    if (with_fem)
      fs::copy(STEMWARE_FEM_MODULE, scratch / "program");
  }

  Ended run(std::vector<std::string> arguments) const
  {
    arguments.insert(arguments.begin(), scratch / "program/stemware");
    return RunningProgram(arguments, scratch.path()).end();
  }

  const ScratchFolder scratch;
};

TEST(WithoutSolidModule, ABodyOfRevolutionIsWhatItIs)
{
  const PartOfProgram program(true);
  const std::string study = program.scratch.write("study.prm", plain_study());
  ASSERT_EQ(program.run({ "run", study, "--quick", "--quiet", "--output", "without" }).exit_code, 0);
  ASSERT_EQ(stemware(program.scratch, { "run", study, "--quick", "--quiet", "--output", "with" }).exit_code,
            0);
  EXPECT_EQ(read_summary(program.scratch / "without")["ring"],
            read_summary(program.scratch / "with")["ring"]);
}

TEST(WithoutSolidModule, ASolidFootIsRefusedByEachVerbThatWouldSolveIt)
{
  const PartOfProgram program(true);
  const std::string study = program.scratch.write("study.prm", coarse_study());
  for (const std::vector<std::string> &verb : { std::vector<std::string>{ "run" },
                                                { "converge" },
                                                { "truncate" },
                                                { "sweep", "--vary", "Motion/Orbit speed=0.3:0.35:2" } })
  {
    std::vector<std::string> arguments = verb;
    arguments.insert(arguments.end(), { study, "--output", "results" });
    const Ended ended = program.run(arguments);
    EXPECT_EQ(ended.exit_code, 1) << verb.front();
    EXPECT_THAT(ended.err, testing::HasSubstr("libstemware_solid_module.so"))
      << verb.front() << ": " << ended.err;
    EXPECT_FALSE(fs::exists(program.scratch / "results")) << verb.front();
  }
}

TEST(WithoutSolidModule, AMeshOfASolidFootCanStillBeLookedAt)
{
  const PartOfProgram program(true);
  const std::string study = program.scratch.write("study.prm", coarse_study());
  EXPECT_EQ(program.run({ "mesh", study, "--write", "foot.msh" }).exit_code, 0);
  EXPECT_TRUE(fs::exists(program.scratch / "foot.msh"));
}

TEST(WithoutModules, WhatHasNoBodyNeedsNone)
{
  const PartOfProgram program(false);
  for (const std::vector<std::string> &arguments :
       { std::vector<std::string>{ "--version" },
         { "help", "run" },
         { "defaults" },
         { "new", "own.prm" },
         { "run", "--set", "Load/Source=first harmonic", "--output", "results" } })
  {
    const Ended ended = program.run(arguments);
    EXPECT_EQ(ended.exit_code, 0) << arguments.front() << ": " << ended.err;
  }
}

TEST(WithoutModules, AFootIsRefusedInOneSentence)
{
  const PartOfProgram program(false);
  const Ended ended = program.run({ "run", "--output", "results" });
  EXPECT_EQ(ended.exit_code, 1);
  EXPECT_THAT(ended.err, testing::HasSubstr("libstemware_fem_module.so"));
  EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
  EXPECT_FALSE(fs::exists(program.scratch / "results"));
}

} // namespace
} // namespace stemware
