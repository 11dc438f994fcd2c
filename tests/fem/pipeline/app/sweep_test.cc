// The verb `sweep` as the real program: the same digits as single runs, however the cases are shared out, and
// after being killed.
#include "tests/fem/pipeline/csv_table.h"
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <set>
#include <sstream>
#include <thread>

namespace stemware::test
{
namespace
{

/// A body of revolution that is solved in a few milliseconds.
std::string quick_study()
{
  return plain_study(
    "subsection Contact\n  set Body = revolution\n  set Harmonics = 6\n  set Azimuth lines = 64\nend\n");
}

/// `stemware sweep study.prm` with further arguments; the results are in the folder `results`.
std::vector<std::string> sweep(const std::vector<std::string> &further)
{
  std::vector<std::string> arguments = { "sweep", "study.prm", "--output", "results" };
  arguments.insert(arguments.end(), further.begin(), further.end());
  return arguments;
}

std::vector<std::string> with_program(std::vector<std::string> arguments,
                                      std::vector<std::string> command = {})
{
  command.push_back(STEMWARE_PROGRAM);
  command.insert(command.end(), arguments.begin(), arguments.end());
  return command;
}

CsvTable table_of(const ScratchFolder &scratch, const std::string &results = "results")
{
  return CsvTable(read_text(scratch / results / "sweep.csv"));
}

/// sweep.csv of a sweep in a folder of its own.
std::string unbroken(const std::vector<std::string> &further)
{
  const ScratchFolder scratch;
  scratch.write("study.prm", quick_study());
  const Ended ended = stemware(scratch, sweep(further));
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  return read_text(scratch / "results/sweep.csv");
}

const std::vector<std::string> forty_cases = { "--vary", "Load/Moment ratio=0.2:1.7:8", "--vary",
                                               "Table/Foundation modulus=1e9:1e11:5:log" };

} // namespace

TEST(Sweep, HasTheDigitsOfSeparateRuns)
{
  const ScratchFolder scratch;
  scratch.write("study.prm", quick_study());
  ASSERT_EQ(stemware(scratch, sweep(forty_cases)).exit_code, 0);
  const CsvTable table = table_of(scratch);
  ASSERT_EQ(table.n_rows(), 40u);
  for (const std::size_t row : { 0u, 17u, 39u })
  {
    std::vector<std::string> arguments = { "run", "study.prm", "--output", "one" };
    for (const std::string entry : { "Load/Moment ratio", "Table/Foundation modulus" })
      arguments.insert(
        arguments.end(),
        { "--set", entry + "=" + table.text(row, entry + (entry[0] == 'L' ? " (1)" : " (Pa/m)")) });
    const Ended ended = stemware(scratch, arguments);
    ASSERT_EQ(ended.exit_code, 0) << ended.err;
    const nlohmann::json one = read_summary(scratch / "one");
    EXPECT_EQ(table.number(row, "terminal spin (rad/s)"), one["ring"]["omega_terminal"]);
    // `run` starts the search for this one from the spin of all harmonics, `sweep` from nothing.
    EXPECT_NEAR(table.number(row, "terminal spin of the first harmonic alone (rad/s)"),
                one["truncation"][0]["omega_terminal"], 1e-8);
    EXPECT_NEAR(table.number(row, "absolute harmonic effect (rad/s)"), one["harmonic_effect"]["absolute"],
                1e-8);
    EXPECT_EQ(table.number(row, "torque at rest (N m)"), one["ring"]["tau_at_rest"]);
    EXPECT_EQ(table.number(row, "moment ratio (1)"), one["load"]["moment_ratio"]);
    EXPECT_EQ(table.number(row, "contact fraction (1)"), one["load"]["contact_fraction"]);
    EXPECT_EQ(table.number(row, "least load at rest (N/rad)"), one["load"]["minimum"]);
    EXPECT_EQ(table.number(row, "ring radius (m)"), one["load"]["ring_radius"]);
    EXPECT_EQ(table.number(row, "a_0 (N/rad)"), one["load"]["a"][0]);
    EXPECT_EQ(table.number(row, "a_2/a_0 (1)"),
              one["load"]["a"][2].get<double>() / one["load"]["a"][0].get<double>());
    EXPECT_EQ(table.number(row, "b_3/a_0 (1)"),
              one["load"]["b"][3].get<double>() / one["load"]["a"][0].get<double>());
    EXPECT_EQ(table.number(row, "contact iterations (1)"), one["contact"]["iterations"]);
    EXPECT_EQ(table.text(row, "contact outcome"), one["contact"]["outcome"]);
    EXPECT_EQ(table.text(row, "status"), "ok");
  }
}

TEST(Sweep, WorkersAndRanksDoNotChangeADigit)
{
  const std::string expected = unbroken(forty_cases);
  std::vector<std::string> one_job = forty_cases;
  one_job.insert(one_job.end(), { "--jobs", "1" });
  EXPECT_EQ(unbroken(one_job), expected);

  const ScratchFolder scratch;
  scratch.write("study.prm", quick_study());
  std::vector<std::string> three_jobs = forty_cases;
  three_jobs.insert(three_jobs.end(), { "--jobs", "3" });
  RunningProgram ranks(with_program(sweep(three_jobs), { STEMWARE_MPIRUN, "-n", "2" }), scratch.path());
  const Ended ended = ranks.end();
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_EQ(read_text(scratch / "results/sweep.csv"), expected);
  EXPECT_EQ(names_in(scratch.path()), (std::vector<std::string>{ "results", "study.prm" }));
}

namespace
{

/// Enough cases that a sweep can be killed on the way.
const std::vector<std::string> many_cases = { "--vary", "Load/Moment ratio=0.1:1.8:300" };

std::filesystem::path log_in(const ScratchFolder &scratch)
{
  return scratch / ".results.sweep" / "cases-0.jsonl";
}

std::size_t n_logged(const ScratchFolder &scratch)
{
  const std::string log = read_text(log_in(scratch));
  return static_cast<std::size_t>(std::count(log.begin(), log.end(), '\n'));
}

/// Starts the sweep, and stops it once this many cases are logged. Returns what it has left.
Ended stop_after(const ScratchFolder &scratch, std::size_t n_cases, int signal)
{
  RunningProgram program(with_program(sweep(many_cases)), scratch.path());
  for (unsigned int i = 0; i < 12000 && n_logged(scratch) < n_cases; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  program.send(signal);
  return program.end();
}

} // namespace

TEST(Sweep, KilledTwiceItEndsWithTheTableOfAnUnbrokenRun)
{
  const ScratchFolder scratch;
  scratch.write("study.prm", quick_study());
  EXPECT_EQ(stop_after(scratch, 20, SIGKILL).exit_code, 128 + SIGKILL);
  ASSERT_GE(n_logged(scratch), 20u);
  ASSERT_LT(n_logged(scratch), 300u);
  EXPECT_FALSE(std::filesystem::exists(scratch / "results"));
  const std::string first_log = read_text(log_in(scratch));

  EXPECT_EQ(stop_after(scratch, n_logged(scratch) + 20, SIGKILL).exit_code, 128 + SIGKILL);
  const std::string second_log = read_text(log_in(scratch));
  const std::string whole_lines = first_log.substr(0, first_log.rfind('\n') + 1);
  EXPECT_EQ(second_log.compare(0, whole_lines.size(), whole_lines), 0);
  // Every case stands there once: none was computed again.
  std::set<std::size_t> numbers;
  std::istringstream lines(second_log.substr(0, second_log.rfind('\n') + 1));
  std::size_t n_lines = 0;
  for (std::string line; std::getline(lines, line); ++n_lines)
    numbers.insert(nlohmann::json::parse(line)["case"].get<std::size_t>());
  EXPECT_EQ(numbers.size(), n_lines);
  ASSERT_LT(n_lines, 300u);

  const Ended ended = stemware(scratch, sweep(many_cases));
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_NE(ended.out.find(std::to_string(n_lines) + " of them are kept"), std::string::npos) << ended.out;
  EXPECT_EQ(read_text(scratch / "results/sweep.csv"), unbroken(many_cases));
  EXPECT_EQ(names_in(scratch.path()), (std::vector<std::string>{ "results", "study.prm" }));
}

TEST(Sweep, InterruptedItsCasesAreKept)
{
  const ScratchFolder scratch;
  scratch.write("study.prm", quick_study());
  const Ended ended = stop_after(scratch, 10, SIGINT);
  EXPECT_EQ(ended.exit_code, 130);
  EXPECT_EQ(names_in(scratch.path()), (std::vector<std::string>{ ".results.sweep", "study.prm" }));

  // Another sweep does not take these cases for its own, nor throw them away unasked.
  const std::vector<std::string> other = { "--vary", "Load/Moment ratio=0.1:1.8:3" };
  const Ended refused = stemware(scratch, sweep(other));
  EXPECT_EQ(refused.exit_code, 3);
  EXPECT_NE(refused.err.find("finished cases of another sweep"), std::string::npos) << refused.err;
  EXPECT_GE(n_logged(scratch), 10u);
  std::vector<std::string> restarted = other;
  restarted.push_back("--restart");
  EXPECT_EQ(stemware(scratch, sweep(restarted)).exit_code, 0);
  EXPECT_EQ(table_of(scratch).n_rows(), 3u);
  EXPECT_EQ(names_in(scratch.path()), (std::vector<std::string>{ "results", "study.prm" }));
}

TEST(Sweep, TwoIntoOnePlaceAreOneTooMany)
{
  const ScratchFolder scratch, elsewhere;
  scratch.write("study.prm", quick_study());
  RunningProgram first(with_program(sweep(many_cases)), scratch.path());
  for (unsigned int i = 0; i < 12000 && n_logged(scratch) == 0; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  first.send(SIGSTOP); // so that it does not end before the second one starts
  const Ended second = stemware(elsewhere, { "sweep", scratch / "study.prm", "--output", scratch / "results",
                                             "--vary", "Load/Moment ratio=0.1:1.8:300" });
  EXPECT_EQ(second.exit_code, 3);
  EXPECT_NE(second.err.find("Another sweep is computing into"), std::string::npos) << second.err;
  first.send(SIGKILL);
  first.end();
}

TEST(Sweep, DoesNotFollowALinkToItsCases)
{
  const ScratchFolder scratch;
  scratch.write("study.prm", quick_study());
  for (const char *folder : { "victim", "work" })
    std::filesystem::create_directory(scratch / folder);
  scratch.write("victim/keep.txt", "precious");
  std::filesystem::create_directory(scratch / "victim/folder");
  std::filesystem::create_directory_symlink("../victim", scratch / "work/.x.sweep");
  for (const char *further : { "--quiet", "--restart" })
  {
    const Ended ended = stemware(
      scratch, { "sweep", "study.prm", "--vary", "Motion/Mass=0.2:0.4:2", "--output", "work/x", further });
    EXPECT_EQ(ended.exit_code, 3);
    EXPECT_NE(ended.err.find("is not a folder of its own"), std::string::npos) << ended.err;
  }
  EXPECT_EQ(names_in(scratch / "victim"), (std::vector<std::string>{ "folder", "keep.txt" }));
  EXPECT_EQ(read_text(scratch / "victim/keep.txt"), "precious");
  EXPECT_EQ(names_in(scratch / "work"), std::vector<std::string>{ ".x.sweep" });
}

TEST(Sweep, ABadCaseIsListedAndDoesNotStopTheOthers)
{
  const ScratchFolder scratch;
  scratch.write("study.prm", quick_study());
  const Ended ended = stemware(
    scratch, sweep({ "--vary", "Load/Moment ratio=0.5,1", "--vary", "Contact/Load harmonics=900,8" }));
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_NE(ended.out.find("2 of 4 cases failed"), std::string::npos) << ended.out;
  const CsvTable table = table_of(scratch);
  EXPECT_EQ(table.text(1, "status"), "ok");
  EXPECT_EQ(table.text(3, "status"), "ok");
  for (const std::size_t row : { 0u, 2u })
  {
    EXPECT_EQ(table.text(row, "status"), "failed");
    EXPECT_EQ(table.text(row, "terminal spin (rad/s)"), "");
    EXPECT_NE(table.text(row, "message").find("Contact/Load harmonics = 900 needs more than 1800"),
              std::string::npos);
  }
  const auto summary = read_summary(scratch / "results");
  EXPECT_EQ(summary["sweep"]["failed"], 2);
  EXPECT_EQ(summary["quantities"]["terminal spin"]["values"], 2);
}

TEST(Sweep, FailsWhenEveryCaseDoes)
{
  const ScratchFolder scratch;
  scratch.write("study.prm", quick_study());
  const Ended ended = stemware(scratch, sweep({ "--vary", "Contact/Load harmonics=900:903:4" }));
  EXPECT_EQ(ended.exit_code, 2);
  EXPECT_NE(
    ended.err.find("All 4 cases failed, the first one because: Contact/Load harmonics = 900 needs more than"),
    std::string::npos)
    << ended.err;
  EXPECT_EQ(table_of(scratch).n_rows(), 4u);
}

TEST(Sweep, ContactFailuresCarryTheirOutcome)
{
  // On a mat as soft as jelly the glass leans until it falls.
  const ScratchFolder scratch;
  scratch.write("study.prm", quick_study());
  const Ended ended = stemware(
    scratch, sweep({ "--vary", "Motion/Centre of mass height=0.14,0.06", "--set", "Motion/Tilt=included",
                     "--set", "Table/Foundation modulus=1e8", "--set", "Load/Coupling=two-way" }));
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  const CsvTable table = table_of(scratch);
  EXPECT_EQ(table.text(0, "status"), "failed");
  EXPECT_NE(table.text(0, "contact outcome"), "");
  EXPECT_EQ(table.text(0, "message").find("No contact solution: " + table.text(0, "contact outcome") + ": "),
            0u)
    << table.text(0, "message");
  EXPECT_EQ(table.text(1, "status"), "ok");
}

TEST(Sweep, SolidBodiesAndOthersInOneTable)
{
  const auto spins = [](const std::vector<std::string> &launcher)
  {
    const ScratchFolder scratch;
    scratch.write("study.prm", coarse_study());
    const auto arguments = sweep(
      { "--vary", "Contact/Body=solid,revolution", "--set", "Contact/Linear solver=multigrid", "--quiet" });
    const Ended ended = RunningProgram(with_program(arguments, launcher), scratch.path()).end();
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    const CsvTable table = table_of(scratch);
    return std::vector<double>{ table.number(0, "terminal spin (rad/s)"),
                                table.number(1, "terminal spin (rad/s)") };
  };
  const auto alone = spins({}), together = spins({ STEMWARE_MPIRUN, "-n", "2" });
  EXPECT_NEAR(alone[0], alone[1], 0.01); // two bodies, one glass, on coarse meshes
  EXPECT_NE(alone[0], alone[1]);
  EXPECT_NEAR(together[0], alone[0], 1e-8);
  EXPECT_EQ(together[1], alone[1]);
}

TEST(Sweep, SamplesFollowTheirClosedForm)
{
  // The paper's closure: tau_z(0) = mu dz m v^2 / rho, so mu and dz with independent spreads of relative size
  // s = 0.1 have a product with the relative variance 2 s^2 + s^4, of which each owes the share s^2 to one of
  // them alone. The terminal spin depends on dz but not on mu.
  constexpr unsigned int n_samples = 3000;
  constexpr double s2 = 0.01, relative_variance = 2 * s2 + s2 * s2;
  const std::vector<std::string> random = { "--random",  "Motion/Friction coefficient=0.3+-10%",
                                            "--random",  "Motion/Force offset=-0.05+-0.005",
                                            "--samples", "3000" };
  const ScratchFolder scratch;
  scratch.write("study.prm", "subsection Load\n  set Source = first harmonic\nend\n"
                             "subsection Motion\n  set Closure = paper\nend\n");
  const Ended ended = stemware(scratch, sweep(random));
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  const auto summary = read_summary(scratch / "results");
  const auto &torque = summary["quantities"]["torque at rest"];
  const double mean = 0.3 * -0.05 * 0.3 * 0.35 * 0.35 / 0.15,
               deviation = std::abs(mean) * std::sqrt(relative_variance);
  const double error = 1 / std::sqrt(n_samples);
  EXPECT_NEAR(torque["band"]["mean"], mean, 4 * deviation * error);
  EXPECT_NEAR(torque["band"]["standard_deviation"], deviation, 4 * deviation * error / std::sqrt(2.));
  const auto &of_torque = torque["sensitivity"]["entries"];
  for (const auto &[entry, sign] :
       { std::pair("Motion/Friction coefficient", -1), std::pair("Motion/Force offset", 1) })
  {
    EXPECT_NEAR(of_torque[entry]["first_order"], s2 / relative_variance, 4 * error) << entry;
    EXPECT_NEAR(of_torque[entry]["regression"], sign * std::sqrt(s2 / relative_variance), 4 * error) << entry;
  }
  EXPECT_NEAR(torque["sensitivity"]["r_squared"], 2 * s2 / relative_variance, 4 * error);
  const auto &of_spin = summary["quantities"]["terminal spin"]["sensitivity"]["entries"];
  EXPECT_NEAR(of_spin["Motion/Force offset"]["first_order"], 1, 0.01);
  EXPECT_NEAR(of_spin["Motion/Friction coefficient"]["first_order"], 0, 4 * error);
  EXPECT_NEAR(of_spin["Motion/Friction coefficient"]["regression"], 0, 1e-3);
  EXPECT_EQ(CsvTable(read_text(scratch / "results/statistics.csv")).text(0, "quantity"), "normal force");
}

TEST(Sweep, SamplesAreTheSameForTheSameSeed)
{
  const auto table = [](const std::string &seed)
  {
    const ScratchFolder scratch;
    scratch.write("study.prm", "subsection Load\n  set Source = first harmonic\nend\n");
    EXPECT_EQ(
      stemware(scratch, sweep({ "--random", "Motion/Mass=0.3+-5%", "--samples", "20", "--seed", seed }))
        .exit_code,
      0);
    return read_text(scratch / "results/sweep.csv");
  };
  EXPECT_EQ(table("5"), table("5"));
  EXPECT_NE(table("5"), table("6"));
}

TEST(Sweep, ProgramsReadOneLineAndPeopleNothing)
{
  const ScratchFolder scratch;
  scratch.write("study.prm", "subsection Load\n  set Source = first harmonic\nend\n");
  const Ended ended =
    stemware(scratch, sweep({ "--vary", "Motion/Force offset=-0.05,-0.04", "--quiet", "--json" }));
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_EQ(ended.err, "");
  EXPECT_EQ(std::count(ended.out.begin(), ended.out.end(), '\n'), 1);
  const auto line = nlohmann::json::parse(ended.out);
  EXPECT_EQ(line["verb"], "sweep");
  EXPECT_EQ(line["cases"], 2);
  EXPECT_EQ(line["omega_terminal"].size(), 2u);
}

TEST(Sweep, RequestsThatCannotBeMetAreRefusedInOneSentence)
{
  const ScratchFolder scratch;
  scratch.write("study.prm", quick_study());
  for (const auto &[arguments, expected] : std::vector<std::pair<std::vector<std::string>, std::string>>{
         { {}, "nothing to vary" },
         { { "--vary", "Load/Moment ratio=0:1" }, "is not a range" },
         { { "--vary", "Load/Momentratio=0:1:3" }, "did you mean Load/Moment ratio?" },
         { { "--random", "Motion/Mass=heavy" }, "names no spread" },
         { { "--vary", "Motion/Mass=1,2", "--jobs", "0" }, "--jobs" },
         { { "--vary", "Motion/Mass=1,2", "--set", "Motion/Gravity=-1" },
           "Motion/Gravity = -1 is not allowed" } })
  {
    const Ended ended = stemware(scratch, sweep(arguments));
    EXPECT_EQ(ended.exit_code, 1);
    EXPECT_NE(ended.err.find(expected), std::string::npos) << ended.err;
    EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
    EXPECT_EQ(names_in(scratch.path()), std::vector<std::string>{ "study.prm" });
  }
}

} // namespace stemware::test
