#include "tests/fem/pipeline/csv_table.h"
#include "tests/fem/pipeline/matchers.h"
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

namespace stemware::test
{
namespace
{

TEST(ConvergeRun, WritesConvergenceOrdersAndErrorBands)
{
  const ScratchFolder scratch;
  const std::string study = scratch.write("study.prm", "subsection Load\n  set Moment ratio = 0.6\nend\n");
  const Ended ended = stemware(scratch, { "converge", study, "--set", "Contact/Degree=1" });
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  const std::filesystem::path results = scratch / "results" / "study-converge";
  const nlohmann::json summary = read_summary(results);
  EXPECT_EQ(summary["verb"], "converge");

  const auto &mesh = summary["refinement"]["meridional_mesh"];
  EXPECT_EQ(mesh["levels"], nlohmann::json::parse("[0, 1, 2]"));
  EXPECT_EQ(mesh["own_level"], 0);
  const auto &spin = mesh["figures"]["omega_terminal"];
  const std::vector<double> values = spin["values"];

  const double order = std::log2((values[1] - values[0]) / (values[2] - values[1]));
  EXPECT_NEAR(spin["order"].get<double>(), order, 1e-9);
  EXPECT_NEAR(spin["limit"].get<double>(), values[2] + (values[2] - values[1]) / (std::exp2(order) - 1),
              1e-9);
  // The order of convergence is above 0.5 (re-entrant corners) and at most about 2 (smooth section).
  EXPECT_GT(order, 0.5);
  EXPECT_LT(order, 2.05);

  const auto &bands = summary["error_bands"];
  EXPECT_EQ(bands["omega_terminal"]["value"].get<double>(), values[0]);
  EXPECT_GE(bands["omega_terminal"]["band"].get<double>(), std::abs(values[0] - values[2]));
  for (const char *key : { "a2", "b8", "tau_at_rest", "tau_at_spin_1", "tau_at_spin_2", "time_constant",
                           "contact_fraction", "least_load", "ring_radius" })
    EXPECT_TRUE(bands.contains(key)) << key;
  EXPECT_TRUE(std::filesystem::exists(results / "report.html"));
  const CsvTable table(read_text(results / "converge.csv"));
  for (std::size_t row = 0; row < 3; ++row)
  {
    EXPECT_EQ(table.text(row, "axis"), "meridional_mesh");
    EXPECT_EQ(table.number(row, "size (1)"), static_cast<double>(row));
    EXPECT_EQ(table.number(row, "terminal spin (rad/s)"), values[row]);
  }
  EXPECT_THAT(ended.out, testing::HasSubstr("Terminal spin "));
  EXPECT_THAT(ended.out, testing::HasSubstr(" ± "));
}

TEST(ConvergeRun, RefinesASolidBody)
{
  const ScratchFolder scratch;
  const Ended ended = stemware(scratch, { "converge", scratch.write("study.prm", coarse_study()), "--levels",
                                          "2", "--quiet", "--json", "--set", "Load/Moment ratio=0.6" });
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  const nlohmann::json line = nlohmann::json::parse(ended.out);
  EXPECT_EQ(line["verb"], "converge");
  EXPECT_GT(line["omega_terminal_band"].get<double>(), 0);
  const nlohmann::json summary = read_summary(scratch / line["results"].get<std::string>());
  for (const char *axis : { "azimuthal_cells", "radial_cells", "foot_layers", "degree" })
    EXPECT_TRUE(summary["refinement"].contains(axis)) << axis;
}

} // namespace
} // namespace stemware::test
