#include "ring_model/load/constants.h"
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

#include <cmath>

namespace stemware::test
{
namespace
{

nlohmann::json glass_run(const ScratchFolder &scratch, const std::vector<std::string> &settings)
{
  return solved(scratch,
                with_settings({ "run", "--quick", scratch.write("study.prm", plain_study()) },
                              { "Motion/End time=0.02", "Motion/Euler step=0.01" }),
                settings);
}

} // namespace

TEST(RevolutionRun, SolvesSeveralContactsOnlyIfTheLoadDependsOnTheSpin)
{
  const ScratchFolder scratch;
  const auto one_way = glass_run(scratch, { "Motion/Closure=paper" });
  const auto two_way = glass_run(scratch, { "Motion/Closure=paper", "Load/Coupling=two-way" });
  EXPECT_TRUE(two_way["coupling"].is_null());
  EXPECT_EQ(two_way["ring"], one_way["ring"]);
  ASSERT_EQ(two_way["truncation"].size(), one_way["truncation"].size());
  for (std::size_t i = 0; i < one_way["truncation"].size(); ++i)
  {
    const auto &one = one_way["truncation"][i]["omega_terminal"],
               &two = two_way["truncation"][i]["omega_terminal"];
    ASSERT_EQ(one.is_null(), two.is_null()); // --quick solves only the first and the last row
    EXPECT_TRUE(one.is_null() || std::abs(two.get<double>() - one.get<double>()) < 1e-10);
  }
  const auto turning =
    glass_run(scratch, { "Motion/Closure=paper", "Load/Coupling=two-way", "Contact/Friction coupling=elastic",
                         "Contact/Harmonics=4", "Contact/Azimuth lines=32" });
  EXPECT_GE(turning["coupling"]["contact_solutions"].get<int>(),
            turning["coupling"]["balanced_spins"].get<int>());
  EXPECT_GT(turning["coupling"]["balanced_spins"].get<int>(), 10);
}

TEST(RevolutionRun, PressureIntegratesToLineLoadsThatIntegrateToTheForceAndMoment)
{
  const ScratchFolder scratch;
  const auto summary = glass_run(scratch, { "Load/Moment ratio=1.5" });
  const auto lines = read_columns(scratch / "results/load_lines.csv");
  const std::size_t n_lines = lines[0].size();
  ASSERT_EQ(n_lines, 128u);
  double force = 0, moment = 0, loaded = 0;
  for (std::size_t i = 0; i < n_lines; ++i)
  {
    force += lines[1][i] * 2 * ring::pi / static_cast<double>(n_lines);
    moment += lines[1][i] * std::sin(lines[0][i]) * 2 * ring::pi / static_cast<double>(n_lines);
    loaded += lines[1][i] > 0 ? 1 : 0;
    // The maximum of the load is at -pi/2; the rim has lifted off at pi/2.
    if (std::abs(lines[0][i] - ring::pi / 2) < 0.2)
    {
      EXPECT_EQ(lines[1][i], 0) << lines[0][i];
    }
  }
  EXPECT_NEAR(force, 2.943, 1e-9);
  EXPECT_NEAR(moment / ring::pi, summary["load"]["b"][1].get<double>(), 1e-9);
  // The edge of the contact is between two azimuth lines.
  EXPECT_NEAR(loaded / static_cast<double>(n_lines), summary["load"]["contact_fraction"].get<double>(),
              1. / static_cast<double>(n_lines));
  EXPECT_EQ(summary["load"]["contact_fraction"], summary["load"]["azimuth_fraction"]);

  // The pressure on the grid of azimuths and radii integrates to the load of each line.
  const auto print = read_columns(scratch / "results/footprint.csv");
  const std::size_t n_radii = print[0].size() / n_lines;
  ASSERT_EQ(n_radii * n_lines, print[0].size());
  for (std::size_t i = 0; i < n_lines; ++i)
  {
    double density = 0;
    for (std::size_t k = i * n_radii; k + 1 < (i + 1) * n_radii; ++k)
    {
      EXPECT_NEAR(print[1][k], lines[0][i], 1e-6);
      density +=
        (print[2][k] * print[0][k] + print[2][k + 1] * print[0][k + 1]) / 2 * (print[0][k + 1] - print[0][k]);
    }
    EXPECT_NEAR(density, lines[1][i], 0.02 * summary["load"]["a"][0].get<double>()) << lines[0][i];
  }
}

} // namespace stemware::test
