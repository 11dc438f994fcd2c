// The curves and plots of `run` from a study made by hand, whose numbers are all different.
#include "fem/pipeline/report/run_results.h"
#include "tests/fem/pipeline/report/hand_made_studies.h"

#include <gtest/gtest.h>

namespace stemware::pipeline
{
namespace
{

using namespace test;

TEST(RunByHand, CurvesOverSpinTimeAndPhase)
{
  const Results results = made_run();
  EXPECT_EQ(file_lines(results, "torque.csv"),
            R"(omega (rad/s): -2.1401234567 | 2.1501234567
slip ratio omega R / v (1): 2.1601234567 | 2.1701234567
tau_z, all harmonics (N m): 2.1801234567 | 2.2101234567
T_x (N): 2.1901234567 | 2.2201234567
T_y (N): 2.2001234567 | 2.2301234567
lean torque of the normal forces, all harmonics (N m): 0.015 | 0.025
torque of the fingers (N m): 0.035 | -0.045
tau_z, lean torque and torque of the fingers together (N m): 2.2301234567000003 | 2.1901234567
tau_z, harmonics up to 1 (N m): 2.2401234567 | 2.2501234567
)");
  EXPECT_EQ(file_lines(results, "spin_up.csv"),
            R"(time (s): 0 | 2.2601234567
omega, adaptive (rad/s): 0 | 2.2701234567
omega, forward Euler (rad/s): 0 | 2.2801234567
omega, first harmonic alone, adaptive (rad/s): 0 | 2.2901234567
yaw angle, adaptive (rad): 0 | 2.3001234567
)");
  EXPECT_EQ(file_lines(results, "phases.csv"),
            R"(mark of the glass (rad): 2.3901234567
mark of the table (rad): 2.4001234567
tau_z at rest (N m): 2.4101234567
tau_z at the mean spin in the long run (N m): 2.4201234567
)");
}

TEST(RunByHand, SpinUpPlotDrawsTheCurvesThatItNames)
{
  const Results results = made_run();
  EXPECT_EQ(data_lines(plot_data(results, "spin_up")), R"(# Spin-up from rest
time (s): 0 | 2.2601234567
omega, all harmonics (rad/s): 0 | 2.2701234567
omega, first harmonic (rad/s): 0 | 2.2901234567
omega, the paper's model (rad/s): 0 | 2.3101234567
)");
  const std::string script = plot_script(results, "spin_up");
  EXPECT_NE(script.find("curve[3] = ['all harmonics', 'first harmonic', 'the paper''s model']"),
            std::string::npos)
    << script;
  EXPECT_NE(script.find("terminal = -1.8901234567\n"), std::string::npos) << script;
}

TEST(RunByHand, LoadOverTheAzimuth)
{
  const RunByHand by_hand;
  const Results results = made_run();
  const Table table = std::get<Table>(results.files.at(2).content);
  ASSERT_EQ(results.files.at(2).name, "load.csv");
  for (const auto &[c, title] :
       { std::pair(0u, "theta (rad)"), std::pair(1u, "lambda, all harmonics (N/rad)"),
         std::pair(2u, "lambda, first harmonic (N/rad)") })
    EXPECT_EQ(with_unit(table.columns[c].quantity.name, table.columns[c].quantity.unit), title);
  ASSERT_EQ(table.n_rows(), 721u);
  const ring::RingStack &load = by_hand.report.load.rings;
  for (std::size_t i = 0; i < table.n_rows(); ++i)
  {
    const double theta = 2 * std::acos(-1.) * static_cast<double>(i) / 720;
    EXPECT_NEAR(table.columns[0].cells[i].get<double>(), theta, 1e-14);
    EXPECT_NEAR(table.columns[1].cells[i].get<double>(), load(theta), 1e-13);
    EXPECT_NEAR(table.columns[2].cells[i].get<double>(), load.truncated(1)(theta), 1e-13);
  }
}

TEST(RunByHand, LiftedLoadsAreDrawnAsTheyWereSolved)
{
  RunByHand by_hand;
  const auto drawn_angles = [&]
  {
    const std::string data = plot_data(tabulate(by_hand.study, by_hand.report, by_hand.spin, {}), "load");
    return std::count(data.begin(), data.end(), '\n');
  };
  const auto with_lift_off = drawn_angles();
  by_hand.report.load.contact_fraction = 1;
  EXPECT_GT(drawn_angles(), with_lift_off + 350); // 361 places of the series instead of two
}

} // namespace
} // namespace stemware::pipeline
