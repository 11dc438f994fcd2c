// `stemware compare`: closures, loads and truncations side by side, against values of
// docs/theory/closures.md.
#include "tests/fem/pipeline/csv_table.h"
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace stemware::test
{
namespace
{

using Json = nlohmann::json;

Json compared(const ScratchFolder &scratch, const std::vector<std::string> &settings)
{
  std::vector<std::string> arguments = { "compare", scratch.write("study.prm", plain_study()), "--output",
                                         "compared" };
  for (const std::string &setting : settings)
    arguments.insert(arguments.end(), { "--set", setting });
  const Ended ended = stemware(scratch, arguments);
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  return read_summary(scratch / "compared")["comparison"];
}

/// The row of so many harmonics; 0: of all.
const Json &row_of(const Json &rows, const std::string &closure, const std::string &load,
                   unsigned int harmonics = 0)
{
  for (const Json &row : rows)
    if (row["closure"] == closure && row["load"] == load &&
        (harmonics == 0 ? row["all_harmonics"] == true : row["harmonics"] == harmonics))
      return row;
  throw std::out_of_range(closure + ", " + load);
}

double spin(const Json &row)
{
  return row["omega_terminal"].get<double>();
}

const char *const flat_ring = "rigid flat rim";
const char *const round_ring = "rigid round rim";

} // namespace

TEST(Compare, RowsOfTheDefaultGlass)
{
  const ScratchFolder scratch;
  const Json rows = compared(scratch, {});
  EXPECT_EQ(rows.size(), 3u * (1 + 4 + 4 + 4 + 4 + 4));
  EXPECT_NEAR(spin(row_of(rows, "paper", "first harmonic")), -3.12055870152586, 1e-10);
  EXPECT_NEAR(spin(row_of(rows, "hand", "first harmonic")), -5.03205140582681, 1e-10);
  EXPECT_NEAR(spin(row_of(rows, "full", "first harmonic")), -3.67874799852576, 1e-10);
  EXPECT_NEAR(spin(row_of(rows, "full", "elastic foot")), -3.6490, 2e-4);
  // m < 1: a linear mat under a rigid ring carries the first harmonic exactly.
  EXPECT_NEAR(spin(row_of(rows, "full", flat_ring)), -3.67874799852576, 1e-9);
  for (const Json &row : rows)
  {
    EXPECT_NEAR(row["tau_at_rest"].get<double>(), -0.003675, 1e-12);
    EXPECT_NEAR(row["difference_to_paper"].get<double>(), spin(row) / -3.12055870152586 - 1, 1e-10);
  }
}

TEST(Compare, RigidRingsThatLiftOff)
{
  const ScratchFolder scratch;
  const Json rows = compared(scratch, { "Motion/Centre of mass height=0.1", "Load/Source=first harmonic" });
  EXPECT_EQ(rows.size(), 3u * (1 + 4 + 4));
  EXPECT_NEAR(spin(row_of(rows, "full", flat_ring)), -5.026328, 1e-6);
  EXPECT_NEAR(spin(row_of(rows, "full", round_ring)), -4.908533, 1e-6);
  EXPECT_EQ(row_of(rows, "full", flat_ring)["state"], "lift-off");
  EXPECT_LT(row_of(rows, "full", flat_ring)["contact_fraction_at_terminal"].get<double>(), 1);
  for (const char *ring : { flat_ring, round_ring })
  {
    const Json &first = row_of(rows, "full", ring, 1);
    EXPECT_NEAR(spin(first), -5.03205140582681, 1e-9);
    EXPECT_EQ(first["state"], "formal");
    EXPECT_NE(spin(row_of(rows, "full", ring, 2)), spin(first));
  }
  EXPECT_EQ(row_of(rows, "full", "first harmonic")["state"], "formal");
  EXPECT_EQ(row_of(rows, "paper", "first harmonic")["state"], "full contact");
}

TEST(Compare, RowsThatDoNotExistSaySo)
{
  const ScratchFolder scratch;
  const Json rows = compared(scratch, { "Motion/Closure=paper", "Motion/Centre of mass height=0.2" });
  EXPECT_EQ(rows.size(), 3u * (1 + 4 + 4 + 4 + 4 + 4));
  for (const char *load : { flat_ring, round_ring, "rigid foot", "elastic foot at rest", "elastic foot" })
  {
    const Json &row = row_of(rows, "full", load);
    EXPECT_TRUE(row["omega_terminal"].is_null()) << load;
    EXPECT_TRUE(row["difference_to_paper"].is_null()) << load;
    EXPECT_EQ(row["state"], "tips") << load << row["message"];
    EXPECT_FALSE(row["message"].get<std::string>().empty()) << load;
  }
  EXPECT_FALSE(row_of(rows, "paper", "elastic foot")["omega_terminal"].is_null());
}

TEST(Compare, RowsOfTheElasticFootAreThoseOfRun)
{
  const ScratchFolder scratch;
  const Json rows = compared(scratch, { "Table/Foundation modulus=1e9" });
  for (const auto &[load, coupling] :
       { std::pair("elastic foot at rest", "one-way"), { "elastic foot", "two-way" } })
    for (const std::string closure : { "paper", "full" })
    {
      const Ended run =
        stemware(scratch, { "run", (scratch / "study.prm").string(), "--output", "run", "--set",
                            "Table/Foundation modulus=1e9", "--set", std::string("Load/Coupling=") + coupling,
                            "--set", "Motion/Closure=" + closure });
      ASSERT_EQ(run.exit_code, 0) << run.err;
      const Json summary = read_summary(scratch / "run");
      EXPECT_NEAR(spin(row_of(rows, closure, load)), summary["ring"]["omega_terminal"].get<double>(), 1e-8)
        << load << ", closure " << closure;
      for (const unsigned int n : { 1u, 2u, 3u })
        EXPECT_NEAR(spin(row_of(rows, closure, load, n)),
                    summary["truncation"][n - 1]["omega_terminal"].get<double>(), 1e-9)
          << n << " harmonics, closure " << closure;
    }
}

TEST(Compare, ProgramsAndPeopleAreToldTheSame)
{
  const ScratchFolder scratch;
  const std::string study = scratch.write("study.prm", plain_study());
  const Ended quiet = stemware(scratch, { "compare", study, "--set", "Load/Source=first harmonic", "--set",
                                          "Motion/Centre of mass height=0.1", "--quiet", "--json" });
  ASSERT_EQ(quiet.exit_code, 0) << quiet.err;
  EXPECT_TRUE(quiet.err.empty()) << quiet.err;
  const Json line = Json::parse(quiet.out);
  EXPECT_NEAR(line["harmonic_effect_relative"].get<double>(), -4.908533 / -5.032051 - 1, 1e-6);
  EXPECT_NEAR(line["omega_terminal"].get<double>(), -4.908533, 1e-6);
  const std::filesystem::path results = scratch / line["results"].get<std::string>();
  const CsvTable csv(read_text(results / "compare.csv"));
  const Json rows = read_summary(results)["comparison"];
  ASSERT_EQ(csv.n_rows(), rows.size());
  EXPECT_NEAR(row_of(rows, "full", "first harmonic")["difference_to_paper"].get<double>(),
              -5.03205140582681 / -3.12055870152586 - 1, 1e-10);
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    EXPECT_EQ(csv.text(i, "load"), rows[i]["load"]);
    EXPECT_EQ(csv.number(i, "terminal omega (rad/s)"), spin(rows[i]));
    EXPECT_EQ(csv.text(i, "state"), rows[i]["state"]);
  }
  const std::string page = read_text(results / "report.html");
  EXPECT_NE(page.find("moment balance: +61.3\u00a0%"), std::string::npos);
  EXPECT_NE(page.find("rad/s, \u22122.45\u00a0%"), std::string::npos);
  EXPECT_NE(page.find("<figure id=\"terminal_spins\""), std::string::npos);

  const Ended talking = stemware(scratch, { "compare", study, "--set", "Load/Source=first harmonic", "--set",
                                            "Motion/Centre of mass height=0.1" });
  EXPECT_NE(talking.out.find("-5.03205 f"), std::string::npos) << talking.out;
  EXPECT_EQ(talking.out.find('\x1b'), std::string::npos);
}

TEST(Compare, RefusesWhatHasNoClosure)
{
  const ScratchFolder scratch;
  const std::string study = scratch.write("study.prm", plain_study());
  const Ended given = stemware(scratch, { "compare", study, "--set", "Load/Moment ratio=1.3" });
  EXPECT_EQ(given.exit_code, 1);
  EXPECT_NE(given.err.find("Load/Moment ratio is given"), std::string::npos) << given.err;
  scratch.write("load.dat", "# ring radius: 0.03 (m)\n0 0.4 0\n1 0.1 0\n");
  const Ended file =
    stemware(scratch, { "compare", study, "--set", "Load/Source=file", "--set", "Load/File=load.dat" });
  EXPECT_EQ(file.exit_code, 1);
  EXPECT_NE(file.err.find("Load/Source = file"), std::string::npos) << file.err;
  const Ended wavy = stemware(
    scratch, { "compare", study, "--set", "Glass/Rim waviness=3: 2e-6", "--set", "Load/Coupling=two-way" });
  EXPECT_EQ(wavy.exit_code, 1);
  EXPECT_NE(wavy.err.find("Glass/Rim waviness makes the load depend on the yaw angle"), std::string::npos)
    << wavy.err;
  const Ended unknown = stemware(scratch, { "compare", study, "--at", "3" });
  EXPECT_EQ(unknown.exit_code, 1);
  EXPECT_NE(unknown.err.find("--at"), std::string::npos) << unknown.err;
  EXPECT_FALSE(std::filesystem::exists(scratch / "results"));
}

} // namespace stemware::test
