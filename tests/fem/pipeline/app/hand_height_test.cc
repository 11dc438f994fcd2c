// If the height of the hand is varied across the centre of mass, the spin changes its sign. With the first
// harmonic only, the load becomes tensile and the spin jumps. With all harmonics, the spin is continuous.
#include "tests/fem/pipeline/browser.h"
#include "tests/fem/pipeline/csv_table.h"
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace stemware::test
{
namespace
{

/// Returns the largest difference between adjacent values of the curve @p name; values on both sides of a gap
/// are not adjacent. Adds the number of values to @p n_values.
double largest_step(const nlohmann::json &rows, const std::string &name, std::size_t &n_values)
{
  double largest = 0;
  std::optional<double> before;
  for (const auto &row : rows)
    if (row[0] == name)
    {
      const std::string text = row.at(2);
      const auto value = text == "NaN" ? std::nullopt : std::optional(std::stod(text));
      n_values += value.has_value();
      if (value && before)
        largest = std::max(largest, std::abs(*value - *before));
      before = value;
    }
  return largest;
}

TEST(HandHeight, CurvesHaveGapsAtSpinJumpsAndTippingCasesHaveNoSpin)
{
  const ScratchFolder scratch;
  const Ended ended =
    stemware(scratch, { "sweep", std::string(STEMWARE_COOKBOOKS) + "/hand_height.prm", "--vary",
                        "Motion/Force offset=-0.08:0.02:41", "--output", "results" });
  ASSERT_EQ(ended.exit_code, 0) << ended.err;

  const CsvTable table(sorted_by_case(read_text(scratch / "results/sweep.csv")));
  ASSERT_EQ(table.n_rows(), 41u);

  // The curves of the first harmonic have a gap at zero spin, where they jump by at least 5 rad/s.
  const nlohmann::json picture = reports_in_browser(
    scratch, { "results/report.html" })["results/report.html"]["figures"]["omega_terminal"];
  std::size_t n_solved = 0, n_falls = 0;
  for (std::size_t i = 0; i < table.n_rows(); ++i)
  {
    n_solved += table.text(i, "status") == "ok";
    n_falls += !table.text(i, "omega_fall (rad/s)").empty();
    EXPECT_EQ(table.text(i, "omega_terminal (rad/s)").empty(), table.text(i, "status") != "ok") << i;
    EXPECT_TRUE(table.text(i, "status") == "ok" || table.text(i, "status") == "tips") << i;
  }
  EXPECT_EQ(n_solved, 38u);
  EXPECT_EQ(n_falls, 1u); // two more cases tip at rest
  // Just before tipping, a second balance exists. With the spin of the second balance, the third difference
  // of the spins would be at least 0.7 rad/s instead of 0.12 rad/s.
  const auto spin = [&](std::size_t i) { return table.number(i, "omega_terminal (rad/s)"); };
  EXPECT_LT(std::abs(spin(37) - 3 * spin(36) + 3 * spin(35) - spin(34)), 0.3);
  for (const char *curve : { "all harmonics", "first harmonic only", "first harmonic on a ring" })
  {
    std::size_t n_values = 0;
    EXPECT_LT(largest_step(picture, curve, n_values), 2.6) << curve;
    // The first harmonic on a ring may be tensile, so the glass does not tip.
    EXPECT_EQ(n_values, n_solved + (curve == std::string("first harmonic on a ring") ? n_falls : 0)) << curve;
  }
}

} // namespace
} // namespace stemware::test
