#include "tests/fem/pipeline/csv_table.h"
#include "tests/fem/pipeline/matchers.h"
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <sstream>
#include <thread>

namespace stemware::test
{
namespace
{

std::string quick_study()
{
  return plain_study(
    "subsection Contact\n  set Body = revolution\n  set Harmonics = 6\n  set Azimuth lines = 64\nend\n");
}

const std::string rigid_study = "subsection Load\n  set Source = first harmonic\nend\n";

std::vector<std::string> sweep(const std::vector<std::string> &further, const std::string &folder = "results")
{
  std::vector<std::string> arguments = { "sweep", "study.prm", "--output", folder };
  arguments.insert(arguments.end(), further.begin(), further.end());
  return arguments;
}

std::string rows_in(const ScratchFolder &scratch, const std::string &folder = "results")
{
  return read_text(scratch / folder / "sweep.csv");
}

CsvTable table_in(const ScratchFolder &scratch)
{
  return CsvTable(sorted_by_case(rows_in(scratch)));
}

/// Returns the sorted lines of sweep.csv. The program writes rows in the order in which cases finish.
std::vector<std::string> sorted_lines(const std::string &text)
{
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);)
    lines.push_back(line);
  std::sort(lines.begin(), lines.end());
  return lines;
}

std::vector<std::string> unbroken(const std::string &study, const std::vector<std::string> &further)
{
  const ScratchFolder scratch;
  scratch.write("study.prm", study);
  const Ended ended = stemware(scratch, sweep(further));
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  return sorted_lines(rows_in(scratch));
}

const std::vector<std::string> forty_cases = { "--vary", "Load/Moment ratio=0.2:1.7:8", "--vary",
                                               "Table/Foundation modulus=1e9:1e11:5:log" };

void expect_refused(const Ended &ended, int exit_code, const std::string &words)
{
  EXPECT_EQ(ended.exit_code, exit_code) << ended.err;
  EXPECT_THAT(ended.err, testing::HasSubstr(words));
  EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
}

} // namespace

TEST(Sweep, AgreesWithSeparateRuns)
{
  const ScratchFolder scratch;
  scratch.write("study.prm", quick_study());
  ASSERT_EQ(stemware(scratch, sweep(forty_cases)).exit_code, 0);
  const CsvTable table = table_in(scratch);
  ASSERT_EQ(table.n_rows(), 40u);
  for (const std::size_t row : { 0u, 17u, 39u })
  {
    const std::string ratio = table.text(row, "Load/Moment ratio"),
                      modulus = table.text(row, "Table/Foundation modulus (Pa/m)");
    const Ended ended =
      stemware(scratch, { "run", "study.prm", "--output", "one", "--quick", "--set",
                          "Load/Moment ratio=" + ratio, "--set", "Table/Foundation modulus=" + modulus });
    ASSERT_EQ(ended.exit_code, 0) << ended.err;
    const nlohmann::json one = read_summary(scratch / "one");
    const double mean = one["load"]["a"][0];
    EXPECT_EQ(table.number(row, "omega_terminal (rad/s)"), one["ring"]["omega_terminal"]);
    // `run` starts the search for the spin of the first harmonic at the spin of all harmonics, `sweep` at
    // rest; the results agree to the tolerance of the search.
    EXPECT_NEAR(table.number(row, "harmonic_effect (rad/s)"), one["harmonic_effect"]["absolute"], 1e-8);
    EXPECT_EQ(table.number(row, "tau_at_rest (N m)"), one["ring"]["tau_at_rest"]);
    EXPECT_EQ(table.number(row, "moment_ratio"), one["load"]["moment_ratio"]);
    EXPECT_EQ(table.number(row, "contact_fraction"), one["load"]["contact_fraction"]);
    EXPECT_EQ(table.number(row, "least_load (N/rad)"), one["load"]["least_load"]);
    EXPECT_EQ(table.number(row, "mean_load (N/rad)"), mean);
    EXPECT_EQ(table.number(row, "a2"), one["load"]["a"][2].get<double>() / mean);
    EXPECT_EQ(table.number(row, "b3"), one["load"]["b"][3].get<double>() / mean);
    EXPECT_EQ(table.text(row, "contact_outcome"), one["contact"]["outcome"]);
    EXPECT_EQ(table.text(row, "status"), "ok");
  }
}

TEST(Sweep, DoesNotDependOnTheNumberOfThreads)
{
  std::vector<std::string> one = forty_cases, three = forty_cases;
  one.insert(one.end(), { "--threads", "1" });
  three.insert(three.end(), { "--threads", "3" });
  EXPECT_EQ(unbroken(quick_study(), one), unbroken(quick_study(), three));
}

TEST(Sweep, ResumesAfterTwoKills)
{
  const std::vector<std::string> many = { "--vary", "Load/Moment ratio=0.1:1.8:300" };
  const ScratchFolder scratch;
  scratch.write("study.prm", quick_study());
  const auto n_lines = [](const std::string &rows)
  { return static_cast<std::size_t>(std::count(rows.begin(), rows.end(), '\n')); };
  const std::vector<std::string> expected = unbroken(quick_study(), many);
  const std::size_t n_head = expected.size() - 300;
  std::string before;
  for (const std::size_t n : { 20u, 60u })
  {
    std::vector<std::string> command = sweep(many);
    command.insert(command.begin(), STEMWARE_PROGRAM);
    RunningProgram program(command, scratch.path());
    while (n_lines(rows_in(scratch)) < n_head + n)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    program.send(SIGKILL);
    EXPECT_EQ(program.end().exit_code, 128 + SIGKILL);
    const std::string rows = rows_in(scratch);
    ASSERT_GE(n_lines(rows), n_head + n);
    ASSERT_LT(n_lines(rows), n_head + 300);
    EXPECT_EQ(rows.compare(0, before.rfind('\n') + 1, before, 0, before.rfind('\n') + 1), 0);
    std::ofstream(scratch / "results/sweep.csv", std::ios::app) << "299,1.79"; // an incomplete row
    before = rows;
  }
  const Ended ended = stemware(scratch, sweep(many));
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_THAT(ended.out, testing::HasSubstr(std::to_string(n_lines(before) - n_head) + " of them are in"));
  EXPECT_EQ(sorted_lines(rows_in(scratch)), expected);
  EXPECT_EQ(stemware(scratch, sweep(many)).exit_code, 0);
  EXPECT_EQ(sorted_lines(rows_in(scratch)), expected);
}

TEST(Sweep, ResumesAfterAKillBeforeTheFirstRow)
{
  const ScratchFolder scratch;
  scratch.write("study.prm", rigid_study);
  const auto arguments = sweep({ "--vary", "Motion/Mass=0.3,0.31" });
  ASSERT_EQ(stemware(scratch, arguments).exit_code, 0);
  const std::string whole = rows_in(scratch);
  scratch.write("results/sweep.csv", whole.substr(0, 700)); // the file ends within its header lines
  ASSERT_EQ(stemware(scratch, arguments).exit_code, 0);
  EXPECT_EQ(sorted_lines(rows_in(scratch)), sorted_lines(whole));
}

TEST(Sweep, ExtendsItsOwnTableAndRefusesOtherTablesAndFolders)
{
  const ScratchFolder scratch;
  scratch.write("study.prm", rigid_study);
  const std::vector<std::string> two = { "--vary", "Motion/Mass=0.3,0.31" };
  const auto refused = [&](std::vector<std::string> arguments, const std::string &words)
  { expect_refused(stemware(scratch, sweep(arguments)), 3, words); };
  ASSERT_EQ(stemware(scratch, sweep(two)).exit_code, 0);
  const std::string rows = rows_in(scratch);
  std::vector<std::string> other = two;
  other.insert(other.end(), { "--set", "Motion/Gravity=9.8" });
  refused(other, "Gravity");
  refused({ "--vary", "Motion/Gravity=9.8,9.81" }, "case,Motion/Gravity");
  refused({ "--vary", "Motion/Mass=0.3,0.32" }, "\"2,0.31,");
  refused({ "--vary", "Motion/Mass=0.3" }, "\"2,0.31,");
  EXPECT_EQ(rows_in(scratch), rows);
  const std::string older = "# stemware 0.1 (unknown)" + rows.substr(rows.find('\n'));
  scratch.write("results/sweep.csv", older);
  refused(two, "line 1: ");
  EXPECT_EQ(rows_in(scratch), older);
  scratch.write("results/sweep.csv", rows);
  EXPECT_EQ(stemware(scratch, sweep({ "--vary", "Motion/Mass=0.3,0.31,0.32" })).exit_code, 0);
  EXPECT_EQ(table_in(scratch).n_rows(), 3u);
  scratch.write("results/note.txt", "precious");
  refused({ "--vary", "Motion/Mass=0.3,0.31,0.32" }, "holds note.txt, which Stemware did not write");
  EXPECT_EQ(read_text(scratch / "results/note.txt"), "precious");
  std::filesystem::remove(scratch / "results/note.txt");
  std::filesystem::remove(scratch / "results/sweep.csv");
  refused(two, "but no sweep.csv");
  scratch.write("file", "");
  expect_refused(stemware(scratch, sweep(two, "file")), 3, "is not a folder");
}

TEST(Sweep, RefusesToResumeWithAChangedInputFile)
{
  const ScratchFolder scratch;
  const std::string load = "# ring radius: 0.03 (m)\n0 0.46 0\n1 0 ";
  for (const char *name : { "a.dat", "b.dat" })
    scratch.write(name, load + "-0.1\n");
  scratch.write("study.prm", "subsection Load\n  set Source = file\n  set File = a.dat\nend\n");
  const auto arguments = sweep({ "--vary", "Load/File=a.dat,b.dat" });
  ASSERT_EQ(stemware(scratch, arguments).exit_code, 0);
  scratch.write("b.dat", load + "-0.2\n");
  expect_refused(stemware(scratch, arguments), 3, "reads ../b.dat");
}

TEST(Sweep, FailedCasesAreReportedInTheirRowsAndASweepWithoutSuccessFails)
{
  const ScratchFolder scratch;
  scratch.write("study.prm", quick_study());
  const std::vector<std::string> cases = { "--vary", "Load/Moment ratio=0.5,1", "--vary",
                                           "Contact/Load harmonics=900,8" };
  const Ended ended = stemware(scratch, sweep(cases));
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  const CsvTable table = table_in(scratch);
  for (const std::size_t row : { 1u, 3u })
    EXPECT_EQ(table.text(row, "status"), "ok");
  for (const std::size_t row : { 0u, 2u })
  {
    EXPECT_EQ(table.text(row, "status"), "failed");
    EXPECT_EQ(table.text(row, "omega_terminal (rad/s)"), "");
    EXPECT_THAT(table.text(row, "message"),
                testing::HasSubstr("Contact/Load harmonics = 900 needs more than 1800"));
  }
  EXPECT_EQ(read_summary(scratch / "results")["sweep"]["failed"], 2);
  EXPECT_THAT(stemware(scratch, sweep(cases)).out, testing::HasSubstr("4 of them are in"));
  expect_refused(
    stemware(scratch, sweep({ "--vary", "Contact/Load harmonics=900:903:4", "--quiet" }, "failed")), 2,
    "All 4 cases failed");
  EXPECT_NE(rows_in(scratch, "failed"), "");
}

TEST(Sweep, ACaseThatTipsAtRestHasTheStatusTipsAndNoSpin)
{
  const ScratchFolder scratch;
  scratch.write("study.prm", quick_study());
  const Ended ended =
    stemware(scratch, sweep({ "--vary", "Motion/Centre of mass height=0.14,0.06", "--set",
                              "Motion/Force offset=-0.05", "--set", "Motion/Tilt=included", "--set",
                              "Table/Foundation modulus=1e8", "--set", "Load/Coupling=two-way" }));
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  const CsvTable table = table_in(scratch);
  EXPECT_EQ(table.text(0, "status"), "tips");
  EXPECT_NE(table.text(0, "contact_outcome"), "");
  EXPECT_EQ(table.text(0, "omega_terminal (rad/s)"), "");
  EXPECT_NE(table.text(0, "message"), "");
  EXPECT_EQ(table.text(1, "status"), "ok");
}

TEST(Sweep, SolidBodyAndBodyOfRevolutionHaveNearlyTheSameSpinInOneTable)
{
  const ScratchFolder scratch;
  scratch.write("study.prm", coarse_study());
  const Ended ended = stemware(scratch, sweep({ "--vary", "Contact/Body=solid,revolution", "--set",
                                                "Contact/Linear solver=multigrid", "--quiet" }));
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  const CsvTable table = table_in(scratch);
  const double solid = table.number(0, "omega_terminal (rad/s)"),
               revolution = table.number(1, "omega_terminal (rad/s)");
  EXPECT_NEAR(solid, revolution, 0.01);
  EXPECT_NE(solid, revolution);
}

TEST(Sweep, RefusesSeveralRanksAndSuggestsPython)
{
  const ScratchFolder scratch;
  scratch.write("study.prm", rigid_study);
  std::vector<std::string> command = { STEMWARE_MPIRUN, "-n", "2", STEMWARE_PROGRAM };
  const auto arguments = sweep({ "--vary", "Motion/Mass=0.3,0.31" });
  command.insert(command.end(), arguments.begin(), arguments.end());
  const Ended ended = RunningProgram(command, scratch.path()).end();
  EXPECT_EQ(ended.exit_code, 1);
  EXPECT_THAT(ended.err, testing::HasSubstr("stemware.solve()"));
  EXPECT_FALSE(std::filesystem::exists(scratch / "results"));
}

TEST(Sweep, QuietJsonPrintsOneLine)
{
  const ScratchFolder scratch;
  scratch.write("study.prm", rigid_study);
  const Ended ended =
    stemware(scratch, sweep({ "--vary", "Motion/Force offset=-0.05,-0.04", "--quiet", "--json" }));
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_EQ(ended.err, "");
  const auto line = nlohmann::json::parse(ended.out);
  EXPECT_EQ(line["verb"], "sweep");
  EXPECT_EQ(line["cases"], 2);
  EXPECT_EQ(line["omega_terminal"].size(), 2u);
}

TEST(Sweep, RefusesBadRequestsWithoutWritingFiles)
{
  const ScratchFolder scratch;
  scratch.write("study.prm", rigid_study);
  for (const auto &[arguments, words] : std::vector<std::pair<std::vector<std::string>, std::string>>{
         { {}, "has no cases" },
         { { "--vary", "Load/Moment ratio=0:1" }, "is not a range" },
         { { "--cases", "cases.csv" }, "--cases cases.csv does not exist" },
         { { "--vary", "Motion/Mass=1,2", "--cases", "cases.csv" }, "do not go together" },
         { { "--vary", "Motion/Mass=1,2", "--set", "Motion/Gravity=-1" },
           "Motion/Gravity = -1 is not allowed" } })
  {
    expect_refused(stemware(scratch, sweep(arguments)), 1, words);
    EXPECT_EQ(names_in(scratch.path()), std::vector<std::string>{ "study.prm" });
  }
}

} // namespace stemware::test
