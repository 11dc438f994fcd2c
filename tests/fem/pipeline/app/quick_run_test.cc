#include "tests/fem/pipeline/matchers.h"
#include "tests/fem/pipeline/page_document.h"
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace stemware::test
{
namespace
{

/// Results of one study with and without --quick. The two runs iterate from different initial guesses.
struct TwoRuns
{
  TwoRuns()
  {
    const std::vector<std::string> run = { "run", scratch.write("study.prm", plain_study()), "--set",
                                           "Load/Coupling=two-way" };
    full = solved(scratch, run, {}, "full");
    std::vector<std::string> with_option = run;
    with_option.push_back("--quick");
    quick = solved(scratch, with_option, {}, "quick");
  }

  ScratchFolder scratch;
  nlohmann::json quick, full;
};

const TwoRuns &two_runs()
{
  static const TwoRuns runs;
  return runs;
}

/// Expects equal columns in the tables @p name of both runs. @p tolerance is relative to the largest value of
/// each column.
void expect_equal_tables(const TwoRuns &runs, const std::string &name, double tolerance)
{
  const auto quick = read_columns(runs.scratch / "quick" / name),
             full = read_columns(runs.scratch / "full" / name);
  ASSERT_EQ(quick.size(), full.size()) << name;
  for (std::size_t i = 0; i < full.size(); ++i)
  {
    ASSERT_EQ(quick[i].size(), full[i].size()) << name;
    double largest = 0;
    for (const double value : full[i])
      largest = std::max(largest, std::abs(value));
    for (std::size_t j = 0; j < full[i].size(); ++j)
      EXPECT_NEAR(quick[i][j], full[i][j], tolerance * largest)
        << name << ", column " << i + 1 << ", row " << j;
  }
}

TEST(QuickRun, ReproducesTheAnswerAndCurvesOfAFullRun)
{
  const TwoRuns &runs = two_runs();
  for (const char *key : { "/ring/omega_terminal", "/ring/tau_at_rest", "/ring/time_constant",
                           "/harmonic_effect/absolute", "/harmonic_effect/relative", "/load/a/2" })
  {
    const nlohmann::json::json_pointer place(key);
    const double expected = runs.full.at(place);
    EXPECT_NEAR(runs.quick.at(place).get<double>(), expected, 1e-7 * std::abs(expected)) << key;
  }
  expect_equal_tables(runs, "torque.csv", 1e-7);
  expect_equal_tables(runs, "spin_up.csv", 1e-7);
}

TEST(QuickRun, OmitsBudgetAndBandsAndStatesTheOmissionFirst)
{
  const TwoRuns &runs = two_runs();
  for (const char *key : { "budget", "without", "error_bands", "one_ring" })
  {
    ASSERT_TRUE(runs.quick.contains(key)) << key;
    EXPECT_TRUE(runs.quick[key].is_null()) << key;
    EXPECT_FALSE(runs.full[key].is_null()) << key;
  }
  const std::string sentence = "Quick run: ";
  const std::string report = read_text(runs.scratch / "quick/report.html");
  EXPECT_LT(report.find(sentence), report.find("rad/s", report.find("class=\"answer\"")));
  EXPECT_FALSE(page_document(runs.scratch / "quick")["tables"].contains("chain"));
  EXPECT_THAT(read_text(runs.scratch / "full/report.html"), testing::Not(testing::HasSubstr(sentence)));
  const auto names = names_in(runs.scratch / "quick");
  EXPECT_EQ(std::count(names.begin(), names.end(), "budget.csv"), 0);
}

} // namespace
} // namespace stemware::test
