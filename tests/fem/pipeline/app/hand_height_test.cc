// The cookbook's sweep of the hand's height on through the centre of mass, where the spin changes its sign: a
// first harmonic alone jumps there (it pulls on the table), all harmonics pass zero.
#include "tests/fem/pipeline/csv_table.h"
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <sstream>

namespace stemware::test
{
namespace
{

/// The largest number in front of a per cent sign.
double largest_percentage(const std::string &text)
{
  static const std::regex percentage("([-+0-9.e]*[0-9])(?: |\u00a0|&nbsp;)%");
  double largest = 0;
  for (std::sregex_iterator found(text.begin(), text.end(), percentage), end; found != end; ++found)
    largest = std::max(largest, std::abs(std::stod((*found)[1])));
  return largest;
}

/// The longest line that a block of a plot's data draws up or down: between two finite values in a row. The
/// number of finite values goes to @p n_finite.
double longest_line(const std::vector<double> &y, std::size_t &n_finite)
{
  double longest = 0;
  for (std::size_t i = 0; i < y.size(); ++i)
  {
    n_finite += std::isfinite(y[i]);
    if (i > 0 && std::isfinite(y[i]) && std::isfinite(y[i - 1]))
      longest = std::max(longest, std::abs(y[i] - y[i - 1]));
  }
  return longest;
}

/// The second column of a block of data, the first block being 0.
std::vector<double> block_of(const std::string &data, std::size_t wanted)
{
  std::istringstream lines(data);
  std::vector<double> values;
  std::size_t block = 0;
  for (std::string line; std::getline(lines, line);)
  {
    if (line.empty() && std::getline(lines, line) && line.empty())
      ++block;
    if (line.empty() || line.front() == '#' || block != wanted)
      continue;
    std::istringstream words(line);
    std::string x, y;
    words >> x >> y;
    values.push_back(std::stod(y));
  }
  return values;
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

  // Nowhere a number above 10^6 %, and none at all in the answer: the spin changes its sign.
  EXPECT_LT(largest_percentage(read_text(scratch / "results/report.html")), 1e6);
  EXPECT_EQ(largest_percentage(ended.out), 0) << ended.out;
  for (std::size_t i = 0; i < table.n_rows(); ++i)
  {
    const std::string column = "harmonic effect (%)";
    EXPECT_TRUE(table.text(i, column).empty() || std::abs(table.number(i, column)) < 1e6);
    EXPECT_EQ(table.text(i, "closure effect (%)"), "");
  }

  // All harmonics are one line to where the foot tips; the others are broken on both sides of zero, where
  // they differ by 5 rad/s and more.
  const std::string spins = read_text(scratch / "results/figures/terminal_spin.dat");
  std::size_t n_solved = 0, n_falls = 0;
  for (std::size_t i = 0; i < table.n_rows(); ++i)
  {
    n_solved += table.text(i, "status") == "ok";
    n_falls += table.text(i, "status") == "tips";
    EXPECT_EQ(table.text(i, "terminal spin (rad/s)").empty(), table.text(i, "status") != "ok") << i;
    EXPECT_EQ(table.text(i, "spin at which it falls over (rad/s)").empty(), table.text(i, "status") != "tips")
      << i;
  }
  EXPECT_EQ(n_solved, 38u);
  EXPECT_EQ(n_falls, 1u); // the next two do not stand at rest
  // Just before it tips the glass has a second balance, from which it falls: spins that belong to that one,
  // or to a jump between the two, are no smooth continuation (0.7 and more instead of 0.12).
  const auto spin = [&](std::size_t i) { return table.number(i, "terminal spin (rad/s)"); };
  EXPECT_LT(std::abs(spin(37) - 3 * spin(36) + 3 * spin(35) - spin(34)), 0.3);
  for (const std::size_t block : { 0, 1, 2 })
  {
    const std::vector<double> y = block_of(spins, block);
    EXPECT_EQ(y.size(), block == 0 ? 41u : 43u);
    std::size_t n_finite = 0;
    EXPECT_LT(longest_line(y, n_finite), 2.6) << block;
    EXPECT_EQ(n_finite, block < 2 ? n_solved : n_solved + n_falls); // a formal load never falls
  }
  std::size_t n_marked = 0;
  longest_line(block_of(spins, 3), n_marked);
  EXPECT_EQ(n_marked, n_falls);
  std::size_t n_finite = 0;
  const std::string effects = read_text(scratch / "results/figures/absolute_harmonic_effect.dat");
  EXPECT_LT(longest_line(block_of(effects, 0), n_finite), 2);
  EXPECT_EQ(n_finite, n_solved);
  EXPECT_FALSE(std::filesystem::exists(scratch / "results/figures/harmonic_effect.svg"));
}

} // namespace
} // namespace stemware::test
