#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <thread>

namespace stemware::test
{
namespace
{

namespace fs = std::filesystem;

std::vector<std::string> run_with(const std::vector<std::string> &further)
{
  std::vector<std::string> command = { STEMWARE_PROGRAM, "run", "study.prm", "--output", "results" };
  command.insert(command.end(), further.begin(), further.end());
  return command;
}

void write_study(const ScratchFolder &scratch)
{
  scratch.write("study.prm", "subsection Load\n  set Source = first harmonic\nend\n");
}

TEST(Interruption, SignalsLeaveOlderResultsUnchanged)
{
  const ScratchFolder scratch;
  write_study(scratch);
  ASSERT_EQ(RunningProgram(run_with({}), scratch.path()).end().exit_code, 0);
  const auto before = all_files(scratch / "results");
  // The program would inherit SIG_IGN, which nohup sets for SIGHUP and a shell's background job for SIGINT.
  const auto hang_up = std::signal(SIGHUP, SIG_DFL), interrupt = std::signal(SIGINT, SIG_DFL);
  for (const int signal : { SIGINT, SIGTERM, SIGHUP })
  {
    // The factorisation of the condensed solver takes so long that the signal arrives before the run ends.
    RunningProgram program(run_with({ "--set", "Load/Source=contact", "--set", "Contact/Body=solid", "--set",
                                      "Table/Substrate=rigid", "--set", "Contact/Linear solver=condensed" }),
                           scratch.path());
    ASSERT_TRUE(program.wait_for_output("unknowns"));
    program.send(signal);
    EXPECT_EQ(program.end().exit_code, 128 + signal);
  }
  std::signal(SIGHUP, hang_up);
  std::signal(SIGINT, interrupt);
  EXPECT_EQ(all_files(scratch / "results"), before);
  EXPECT_EQ(names_in(scratch.path()), (std::vector<std::string>{ "results", "study.prm" }));
}

TEST(Interruption, AKilledRunLeavesEitherOldOrNewResults)
{
  const ScratchFolder scratch, reference;
  write_study(scratch);
  write_study(reference);
  const std::vector<std::string> heavier = { "--set", "Motion/Mass=0.4" };
  ASSERT_EQ(RunningProgram(run_with({}), reference.path()).end().exit_code, 0);
  const auto old = all_files(reference / "results");
  const auto begun = std::chrono::steady_clock::now();
  ASSERT_EQ(RunningProgram(run_with(heavier), reference.path()).end().exit_code, 0);
  const auto duration = std::chrono::steady_clock::now() - begun;
  const auto fresh = all_files(reference / "results");
  ASSERT_NE(old, fresh);
  ASSERT_EQ(RunningProgram(run_with({}), scratch.path()).end().exit_code, 0);
  unsigned int n_killed = 0;
  for (int moment = 1; moment <= 10; ++moment)
  {
    RunningProgram program(run_with(heavier), scratch.path());
    std::this_thread::sleep_for(duration * moment / 10);
    program.send(moment % 2 == 0 ? SIGKILL : SIGTERM);
    n_killed += program.end().exit_code != 0;
    const auto found = all_files(scratch / "results");
    EXPECT_TRUE(found == old || found == fresh) << moment;
  }
  EXPECT_GE(n_killed, 1u);
  EXPECT_EQ(RunningProgram(run_with(heavier), scratch.path()).end().exit_code, 0);
  EXPECT_EQ(all_files(scratch / "results"), fresh);
}

TEST(Interruption, TwoSimultaneousRunsLeaveACompleteFolder)
{
  const ScratchFolder scratch, other;
  for (const ScratchFolder *folder : { &scratch, &other })
    write_study(*folder);
  RunningProgram one({ STEMWARE_PROGRAM, "run", "study.prm", "--output", "results" }, scratch.path());
  RunningProgram two({ STEMWARE_PROGRAM, "run", "study.prm", "--output", scratch / "results" }, other.path());
  EXPECT_EQ(one.end().exit_code, 0);
  EXPECT_EQ(two.end().exit_code, 0);
  EXPECT_EQ(names_in(scratch.path()), (std::vector<std::string>{ "results", "study.prm" }));
  EXPECT_EQ(read_summary(scratch / "results")["files"].get<std::vector<std::string>>(),
            names_in(scratch / "results"));
}

TEST(Interruption, AFailedWriteLeavesOlderResultsUnchanged)
{
  const ScratchFolder scratch;
  write_study(scratch);
  ASSERT_EQ(RunningProgram(run_with({}), scratch.path()).end().exit_code, 0);
  const auto before = all_files(scratch / "results");
  const Ended ended =
    RunningProgram(
      { "/bin/sh", "-c", "ulimit -f 8; exec " STEMWARE_PROGRAM " run study.prm --output results" },
      scratch.path())
      .end();
  EXPECT_EQ(ended.exit_code, 3) << ended.err;
  EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
  EXPECT_EQ(all_files(scratch / "results"), before);
  EXPECT_EQ(names_in(scratch.path()), (std::vector<std::string>{ "results", "study.prm" }));
}

TEST(Interruption, AHangUpSignalIgnoredAtTheStartStaysIgnored)
{
  const ScratchFolder scratch;
  scratch.write("study.prm", coarse_study());
  const auto before = std::signal(SIGHUP, SIG_IGN); // as set by nohup
  RunningProgram program(run_with({}), scratch.path());
  std::signal(SIGHUP, before);
  ASSERT_TRUE(program.wait_for_output("unknowns"));
  program.send(SIGHUP);
  EXPECT_EQ(program.end().exit_code, 0);
}

} // namespace
} // namespace stemware::test
