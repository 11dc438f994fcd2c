// Ctrl-C and kill: nothing is left behind, older results stay, the exit code says so.
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

namespace stemware::test
{
namespace
{

/// A study that takes seconds, nearly all of them within one factorisation.
const std::vector<std::string> long_run = {
  STEMWARE_PROGRAM, "run", "long.prm", "--set", "Contact/Body=solid", "--set", "Contact/Linear solver=direct"
};

class Interruption : public testing::TestWithParam<int>
{
};

TEST_P(Interruption, DuringTheFactorisationLeavesNothing)
{
  const ScratchFolder scratch;
  scratch.write("long.prm", "# defaults\n");
  RunningProgram program(long_run, scratch.path());
  ASSERT_TRUE(program.wait_for_output("unknowns"));
  EXPECT_EQ(names_in(scratch / "results").size(), 1u);
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  program.send(GetParam());
  const Ended ended = program.end();
  EXPECT_EQ(ended.exit_code, 130) << ended.err;
  EXPECT_NE(ended.err.find("interrupted after "), std::string::npos) << ended.err;
  EXPECT_NE(ended.err.find("; mesh and stiffness done; no results were written."), std::string::npos)
    << ended.err;
  EXPECT_EQ(ended.out.find("Results"), std::string::npos) << ended.out;
  EXPECT_EQ(names_in(scratch.path()), std::vector<std::string>{ "long.prm" });
}

INSTANTIATE_TEST_SUITE_P(Signals, Interruption, testing::Values(SIGINT, SIGTERM, SIGHUP),
                         [](const auto &info) { return std::string("SIG") + sigabbrev_np(info.param); });

TEST(Interruption, OlderResultsStay)
{
  const ScratchFolder scratch;
  scratch.write("long.prm", "# defaults\n");
  ASSERT_EQ(stemware(scratch, { "run", "long.prm", "--set", "Load/Source=first harmonic" }).exit_code, 0);
  const auto before = all_files(scratch / "results");
  RunningProgram program(long_run, scratch.path());
  ASSERT_TRUE(program.wait_for_output("unknowns"));
  program.send(SIGINT);
  EXPECT_EQ(program.end().exit_code, 130);
  EXPECT_EQ(all_files(scratch / "results"), before);
  EXPECT_EQ(names_in(scratch / "results"), std::vector<std::string>{ "long" });
}

TEST(Interruption, SignalsIgnoredFromTheStartStayIgnored)
{
  const ScratchFolder scratch;
  scratch.write("long.prm", "# defaults\n");
  // As nohup does.
  const auto before = std::signal(SIGHUP, SIG_IGN);
  RunningProgram program(
    { STEMWARE_PROGRAM, "run", "long.prm", "--set", "Contact/Body=solid", "--set", "Contact/Degree=1" },
    scratch.path());
  std::signal(SIGHUP, before);
  ASSERT_TRUE(program.wait_for_output("unknowns"));
  program.send(SIGHUP);
  const Ended ended = program.end();
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_EQ(names_in(scratch / "results"), std::vector<std::string>{ "long" });
}

TEST(Interruption, AFileLargerThanAllowedIsOneThatCannotBeWritten)
{
  const ScratchFolder scratch;
  scratch.write("default.prm", "# defaults\n");
  const std::string command = std::string("ulimit -f 8; exec ") + STEMWARE_PROGRAM + " run default.prm";
  const Ended ended = RunningProgram({ "/bin/sh", "-c", command }, scratch.path()).end();
  EXPECT_EQ(ended.exit_code, 3) << ended.err;
  EXPECT_EQ(names_in(scratch.path()), std::vector<std::string>{ "default.prm" });
}

TEST(Interruption, FromTheFirstLineOfTheProgramOnItIsSaid)
{
  // Parsing, a study that is read from a pipe that never ends, the start of MPI.
  const ScratchFolder scratch;
  scratch.write("coarse.prm", coarse_study());
  ASSERT_EQ(::mkfifo((scratch / "pipe").c_str(), 0600), 0);
  RunningProgram reading({ "/bin/sh", "-c", "exec " STEMWARE_PROGRAM " run - <> pipe" }, scratch.path());
  // The signal comes while the program reads: it has taken the line, and no end follows.
  const int pipe = ::open((scratch / "pipe").c_str(), O_RDWR);
  ASSERT_GE(pipe, 0);
  const std::string line = "# nothing\n";
  ASSERT_EQ(::write(pipe, line.data(), line.size()), static_cast<ssize_t>(line.size()));
  int n_left = 1;
  for (unsigned int i = 0; i < 6000 && n_left > 0 && ::ioctl(pipe, FIONREAD, &n_left) == 0; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_EQ(n_left, 0);
  reading.send(SIGTERM);
  const Ended ended = reading.end();
  EXPECT_EQ(ended.exit_code, 130);
  EXPECT_NE(ended.err.find("interrupted; no results were written."), std::string::npos) << ended.err;
  ::close(pipe);
}

TEST(Interruption, AtAnyMomentThereIsAWholeFolderOrNone)
{
  // Signals spread over a run of about half a second, through claiming, writing and publishing.
  for (unsigned int delay = 5; delay < 600; delay += 35)
  {
    const ScratchFolder scratch;
    scratch.write("coarse.prm", coarse_study());
    RunningProgram program({ STEMWARE_PROGRAM, "run", "coarse.prm" }, scratch.path());
    std::this_thread::sleep_for(std::chrono::milliseconds(delay));
    program.send(SIGINT);
    const Ended ended = program.end();
    if (!std::filesystem::exists(scratch / "results"))
    {
      EXPECT_EQ(ended.exit_code, 130) << delay;
    }
    else
    {
      EXPECT_EQ(names_in(scratch / "results"), std::vector<std::string>{ "coarse" }) << delay;
      EXPECT_EQ(read_summary(scratch / "results/coarse")["files"].get<std::vector<std::string>>(),
                names_in(scratch / "results/coarse"))
        << delay;
    }
  }
}

} // namespace
} // namespace stemware::test
