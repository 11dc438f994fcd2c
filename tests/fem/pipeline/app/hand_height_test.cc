// The cookbook's sweep of the hand's height on through the centre of mass, where the spin changes its sign: a
// first harmonic alone jumps there (it pulls on the table), all harmonics pass zero.
#include "tests/fem/pipeline/csv_table.h"
#include "tests/fem/pipeline/page_document.h"
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace stemware::test
{
namespace
{

/// The longest line that a curve of the page draws up or down: between two values in a row. The number of
/// values goes to @p n_values.
double longest_line(const nlohmann::json &y, std::size_t &n_values)
{
  double longest = 0;
  for (std::size_t i = 0; i < y.size(); ++i)
  {
    n_values += y[i].is_number();
    if (i > 0 && y[i].is_number() && y[i - 1].is_number())
      longest = std::max(longest, std::abs(y[i].get<double>() - y[i - 1].get<double>()));
  }
  return longest;
}

TEST(HandHeight, ThroughZeroHasNoHugePercentageAndNoFalseLine)
{
  const ScratchFolder scratch;
  const Ended ended =
    stemware(scratch, { "sweep", std::string(STEMWARE_COOKBOOKS) + "/hand_height.prm", "--vary",
                        "Motion/Force offset=-0.08:0.02:41", "--output", "results" });
  ASSERT_EQ(ended.exit_code, 0) << ended.err;

  // Heights are those that one would write down.
  const CsvTable table(read_text(scratch / "results/sweep.csv"));
  ASSERT_EQ(table.n_rows(), 41u);
  const std::string height = "Motion/Force offset (m)";
  for (std::size_t i = 0; i < table.n_rows(); ++i)
    EXPECT_EQ(table.number(i, height), (static_cast<double>(i) * 25 - 800) / 1e4);
  EXPECT_EQ(table.text(32, height), "0");

  // Relative effects of spins that pass through zero stay moderate: those of two senses have none.
  for (std::size_t i = 0; i < table.n_rows(); ++i)
  {
    const std::string column = "harmonic_effect_relative";
    EXPECT_TRUE(table.text(i, column).empty() || std::abs(table.number(i, column)) < 1e4);
  }

  // All harmonics are one line to where the foot tips; the others are broken on both sides of zero, where
  // they differ by 5 rad/s and more.
  const nlohmann::json picture = page_document(scratch / "results")["tables"]["pictures"][0];
  ASSERT_EQ(picture["id"], "omega_terminal");
  std::size_t n_solved = 0, n_falls = 0;
  for (std::size_t i = 0; i < table.n_rows(); ++i)
  {
    n_solved += table.text(i, "status") == "ok";
    n_falls += table.text(i, "status") == "tips";
    EXPECT_EQ(table.text(i, "omega_terminal (rad/s)").empty(), table.text(i, "status") != "ok") << i;
    EXPECT_EQ(table.text(i, "omega_fall (rad/s)").empty(), table.text(i, "status") != "tips") << i;
  }
  EXPECT_EQ(n_solved, 38u);
  EXPECT_EQ(n_falls, 1u); // the next two do not stand at rest
  // Just before it tips the glass has a second balance, from which it falls: spins that belong to that one,
  // or to a jump between the two, are no smooth continuation (0.7 and more instead of 0.12).
  const auto spin = [&](std::size_t i) { return table.number(i, "omega_terminal (rad/s)"); };
  EXPECT_LT(std::abs(spin(37) - 3 * spin(36) + 3 * spin(35) - spin(34)), 0.3);
  ASSERT_EQ(picture["curves"].size(), 3u);
  for (const std::size_t curve : { 0, 1, 2 })
  {
    std::size_t n_values = 0;
    EXPECT_LT(longest_line(picture["curves"][curve]["y"], n_values), 2.6) << curve;
    EXPECT_EQ(n_values, curve < 2 ? n_solved : n_solved + n_falls); // a formal load never falls
  }
}

} // namespace
} // namespace stemware::test
