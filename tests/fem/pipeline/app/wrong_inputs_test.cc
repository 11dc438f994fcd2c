// Sixty wrong inputs: each ends in one sentence of at most three lines of 100 characters, with an exit code
// that is not 0, before any work, and leaves nothing behind. bad_input_test.cc says which sentence belongs to
// which trouble.
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

#include <chrono>
#include <optional>
#include <sstream>

namespace stemware::test
{
namespace
{

/// A command as it is typed to a shell, in a folder that prepare() has filled; $S is the program.
const std::vector<const char *> wrong_inputs = {
  // No verb, no such verb, options.
  "$S",
  "$S rnu",
  "$S $(head -c 5000 /dev/zero | tr '\\0' x)",
  "$S run --bogus",
  "$S run --set",
  "$S run good.prm good.prm",
  "$S help swep",
  "$S defaults Glas",
  "$S defaults Glass Table",
  "$S truncate --at fast",
  "$S truncate --at $(head -c 5000 /dev/zero | tr '\\0' 1)x",
  // Files that are no study.
  "$S run nothing.prm",
  "$S run ''",
  "$S run .",
  "$S run folder.prm",
  "$S run empty.prm",
  "$S run binary.prm",
  "$S run good.txt",
  "$S run huge.prm",
  "$S run $(head -c 4000 /dev/zero | tr '\\0' y).prm",
  "$S run /dev/zero",
  "$S run twice.prm",
  "$S run twice.json",
  "$S run broken.json",
  "$S run list.json",
  "$S run carriage.prm",
  "$S run word.prm",
  // Standard input.
  "$S run - < /dev/null",
  "$S run - < /dev/zero",
  "$S run - < folder.prm",
  "$S run - <&-",
  "yes | $S run -",
  // Values.
  "$S run --set Mass=1",
  "$S run --set Motion/Mess=1",
  "$S run --set 'Motion/Mass=30 mm'",
  "$S run --set 'Motion/Mass=300 gramm'",
  "$S run --set Motion/Mass=0,3",
  "$S run --set Motion/Mass=nan",
  "$S run --set Motion/Mass=inf",
  "$S run --set Motion/Mass=1e999",
  "$S run --set Motion/Mass=-1",
  "$S run --set Motion/Mass=",
  "$S run --set \"Motion/Mass=$(head -c 100000 /dev/zero | tr '\\0' 7)\"",
  "$S run --set \"Motion/$(head -c 100000 /dev/zero | tr '\\0' M)=1\"",
  "$S run --set 'Motion/Closure=maybe'",
  "$S run --set 'Glass/Rim waviness=1: 2 um'",
  "$S run --set 'Load/Moment ratio=2'",
  "$S run --set 'Table/Kind=mat'",
  // Sizes.
  "$S run --set 'Glass/Foot radius=34'",
  "$S run --set 'Contact/Refinements=6'",
  "$S run --set 'Contact/Harmonics=1000'",
  "$S run --set 'Contact/Azimuth lines=100000'",
  "$S run --set 'Contact/Harmonics=-1'",
  "$S run --set 'Motion/End time=1e7'",
  "$S run --set 'Motion/Euler step=1 ns'",
  "$S run --set Contact/Body=solid --set 'Contact/Azimuthal cells=2000' --set 'Contact/Foot layers=100'",
  // Load and mesh files.
  "$S run --set Load/Source=file",
  "$S run --set Load/Source=file --set Load/File=folder.prm",
  "$S run --set Load/Source=file --set Load/File=binary.prm",
  "$S run --set Load/Source=file --set Load/File=long.dat",
  "$S run --set Load/Source=file --set Load/File=nan.dat",
  "$S run --set Load/Source=file --set Load/File=/dev/zero",
  "$S run --set 'Motion/Orbit speed file=/dev/zero'",
  "$S run --set 'Motion/Orbit speed file=folder.prm'",
  "$S run --set 'Motion/Orbit speed file=binary.prm'",
  "mkfifo pipe; $S run --set Glass/Shape=profile --set 'Glass/Profile file=pipe'; e=$?; rm pipe; exit $e",
  "$S run --set Glass/Shape=profile --set 'Glass/Profile file=/dev/zero'",
  "$S run --set Glass/Shape=profile --set 'Glass/Profile file=folder.prm'",
  "$S run --set Contact/Body=solid --set 'Contact/Mesh file=binary.prm'",
  "$S mesh --check nothing.msh",
  "$S mesh --check /dev/zero",
  "$S mesh --check foot.msh --set Glass/Shape=step",
  "$S mesh good.prm --write foot.stl",
  // Sweeps.
  "$S sweep",
  "$S sweep --vary Motion/Mass",
  "$S sweep --vary Motion/Mass=1:2",
  "$S sweep --vary 'Motion/Mass=200 g:400:3'",
  "$S sweep --vary 'Motion/Mass=1:2:1e5'",
  "$S sweep --vary 'Motion/Mass=1:2:2000' --vary 'Motion/Gravity=1:2:2000'",
  "$S sweep --vary Motion/Mass=1,2 --threads 0",
  "$S sweep --vary Motion/Mass=1,2 --rows 2:3",
  "$S sweep --cases nothing.csv",
  "$S sweep --cases binary.prm",
  "$S sweep --vary Motion/Mass=0.1-0.5",
  // Places.
  "$S run good.prm --output /proc/results",
  "$S run good.prm --output good.txt",
  "$S run good.prm --output .",
  "$S new good.prm",
  "$S new study",
  "$S new /proc/study.prm",
  "$S new other.prm --table water",
  "$S run good.prm --json --quiet >&-",
};

void prepare(const ScratchFolder &scratch)
{
  const std::string nothing(4, '\0');
  scratch.write("good.prm", "subsection Load\n  set Source = first harmonic\nend\n");
  scratch.write("good.txt", "# text\n");
  scratch.write("empty.prm", "");
  scratch.write("binary.prm", "\x7f"
                              "ELF" +
                                nothing);
  scratch.write("huge.prm", std::string(3000000, '#'));
  scratch.write("twice.prm", "subsection Motion\n  set Mass = 1\n  set Mass = 2\nend\n");
  scratch.write("twice.json", R"({"Motion": {"Mass": 1, "Mass": 2}})");
  scratch.write("broken.json", "{\"Motion\": ");
  scratch.write("list.json", "[1, 2]");
  scratch.write("carriage.prm", "subsection Motion\r  set Mass = 1\rend\r" + std::string(2000, 'x'));
  scratch.write("word.prm", std::string(900000, 'x') + "\n");
  std::string rows = "# ring radius: 0.03 (m)\n0 1 0\n1 0.5 0\n";
  for (unsigned int n = 2; n < 200000; ++n)
    rows += std::to_string(n) + " 0 0\n";
  scratch.write("long.dat", rows);
  scratch.write("nan.dat", "# ring radius: 0.03 (m)\n0 1 0\n1 nan 0\n");
  std::filesystem::create_directory(scratch / "folder.prm");
}

/// What the shell makes of the command's words, where all that it does is to start the program.
std::optional<std::vector<std::string>> arguments_of(const std::string &command, const ScratchFolder &scratch)
{
  if (command.rfind("$S ", 0) != 0 || command.find_first_of("<>|;") != std::string::npos)
    return std::nullopt;
  const std::string words =
    RunningProgram({ "/bin/sh", "-c", "S='printf %s\\n'; " + command }, scratch.path()).end().out;
  std::vector<std::string> arguments;
  std::istringstream lines(words);
  for (std::string line; std::getline(lines, line);)
    arguments.push_back(line);
  return arguments;
}

Ended run_by_shell(const std::string &command, const ScratchFolder &scratch)
{
  if (const auto arguments = arguments_of(command, scratch))
    return stemware(scratch, *arguments);
  return RunningProgram({ "/bin/sh", "-c", "S=" STEMWARE_PROGRAM "; " + command }, scratch.path()).end();
}

TEST(WrongInputs, EachEndsInOneSentenceBeforeTheWork)
{
  const ScratchFolder scratch;
  prepare(scratch);
  const auto before = names_in(scratch.path());
  ASSERT_GE(wrong_inputs.size(), 60u);
  for (const char *command : wrong_inputs)
  {
    SCOPED_TRACE(command);
    const auto start = std::chrono::steady_clock::now();
    const Ended ended = run_by_shell(command, scratch);
    // A quarter of a second alone; the machine may be busy with other tests.
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
    EXPECT_GE(ended.exit_code, 1);
    EXPECT_LE(ended.exit_code, 3);
    EXPECT_EQ(ended.err.rfind("stemware: ", 0), 0u) << ended.err.substr(0, 400);
    EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err.substr(0, 400);
    EXPECT_LE(ended.err.size(), 300u) << ended.err.substr(0, 400);
    for (const char *work : { "Foot ", "unknowns", " rows", "cases" })
      EXPECT_EQ(ended.out.find(work), std::string::npos) << ended.out;
    EXPECT_EQ(names_in(scratch.path()), before);
  }
}

} // namespace
} // namespace stemware::test
