// The results of `converge` from a refinement made by hand, whose numbers are all different; harmonics but
// b_2 are zero by symmetry.
#include "fem/pipeline/report/convergence_results.h"
#include "tests/fem/pipeline/report/hand_made_studies.h"

#include <gtest/gtest.h>

namespace stemware::pipeline
{
namespace
{

using namespace test;

Results made_convergence()
{
  Study study;
  study.name = "glass";
  return tabulate(study, RefinementByHand().result);
}

TEST(ConvergenceByHand, Console)
{
  const Results results = made_convergence();
  EXPECT_EQ(console_text(results), R"(
Terminal spin 1.0401 ± 0.0011 rad/s (discretisation only); it converges with order 1.45 in the
meridional mesh, Richardson value 1.0601 rad/s.

Error band of the terminal spin, axis by axis
                                                 band
  what is refined  the study has              (rad/s)  order   unknowns     finest
  meridional mesh  halvings of every cell: 1  1.5e-03   1.45  about 560  about 560
  all together                                1.1e-03      -          -          -

Error bands of the main quantities; the report has all of them
  quantity        value  Richardson value     band  unit
  terminal spin  1.0401            1.0601  1.1e-03  rad/s
  time constant  1.0701            1.0901  1.1e-03  s
  b_2/a_0        1.0101            1.0301  1.1e-03  –

)");
}

TEST(ConvergenceByHand, DataFiles)
{
  const Results results = made_convergence();
  EXPECT_EQ(file_lines(results, "converge_meridional_mesh.csv"),
            R"(halvings of every cell (1): 0 | 1
a2 (1): 1.1001234567 | 1.1101234567
a3 (1): 1.1601234567 | 1.1701234567
b3 (1): 1.2101234567 | 1.2201234567
a4 (1): 1.2701234567 | 1.2801234567
b4 (1): 1.3201234567 | 1.3301234567
b_2/a_0 (1): 1.3801234567 | 1.3901234567
terminal spin (rad/s): 1.4301234567 | 1.4401234567
time constant (s): 1.4901234567 | 1.5001234567
unknowns of the largest linear system, estimated (1): 561 | 561
)");
  EXPECT_EQ(file_lines(results, "error_bands.csv"),
            R"(a2 (1): 0 | 0 | 0
a3 (1): 0 | 0 | 0
b3 (1): 0 | 0 | 0
a4 (1): 0 | 0 | 0
b4 (1): 0 | 0 | 0
b_2/a_0 (1): 1.0101234567 | 0.0010201234567 | 1.0301234567
terminal spin (rad/s): 1.0401234567 | 0.0010501234567 | 1.0601234567
time constant (s): 1.0701234567 | 0.0010801234567 | 1.0901234567
)");
}

TEST(ConvergenceByHand, Report)
{
  const Results results = made_convergence();
  EXPECT_EQ(results.report.title, R"(Refinement study of glass)");
  EXPECT_EQ(report_lines(results, "Error bands"), R"(The study as it is; harmonics not listed are zero
quantity: b2/a0 | terminal spin | time constant
value: 1.0101 | 1.0401 | 1.0701
band: 1.1e-03 | 1.1e-03 | 1.1e-03
Richardson value: 1.0301 | 1.0601 | 1.0901
unit: – | rad/s | s
)");
  EXPECT_EQ(report_lines(results, "What the discretisation leaves open", true),
            R"(Error band of the terminal spin, axis by axis
what is refined | the study has | band (rad/s) | observed order | unknowns | on the finest level
meridional mesh | halvings of every cell: 1 | 1.5e-03 | 1.45 | about 560 | about 560
all together |  | 1.1e-03 | – | – | –
)");
  EXPECT_EQ(report_lines(results, "All levels"),
            R"(Values on each level of the meridional mesh; * the study&#39;s own
quantity: b2/a0 | terminal spin | time constant
0: 1.38012346 | 1.43012346 | 1.49012346
1 *: 1.39012346 | 1.44012346 | 1.50012346
observed order: – | 1.45 | –
band: 1.5e-03 | 1.5e-03 | 1.6e-03
)");
  EXPECT_EQ(plot_data(results, "converge_meridional_mesh"), R"(# terminal spin
# 1: size of the cells over that without halvings, h / h_0 (1)
# 2: relative error (1)
# 3: half-width of the error band (1)
                       1     0.020546207830810768    0.0010068487359436037
                     0.5     0.013697471887207177     0.001013697471887207


# time constant
# 1: size of the cells over that without halvings, h / h_0 (1)
# 2: relative error (1)
# 3: half-width of the error band (1)
                       1     0.013243950295100412    0.0010066219751475502
                     0.5     0.006621975147550206    0.0010132439502951002


# b_2/a_0
# 1: size of the cells over that without halvings, h / h_0 (1)
# 2: relative error (1)
# 3: half-width of the error band (1)
                       1     0.014284454634549668    0.0010071422273172747
                     0.5     0.007142227317274834    0.0010142844546345497


# a3
# 1: size of the cells over that without halvings, h / h_0 (1)
# 2: relative error (1)
# 3: half-width of the error band (1)
                       1     0.016947379434289332    0.0010084736897171447
                     0.5     0.008473689717144666    0.0010169473794342894


# a4
# 1: size of the cells over that without halvings, h / h_0 (1)
# 2: relative error (1)
# 3: half-width of the error band (1)
                       1     0.015502392345580564    0.0010077511961727903
                     0.5     0.007751196172790282    0.0010155023923455804


# order 1.5
# 1: size of the cells over that without halvings, h / h_0 (1)
# 2: relative error (1)
                     0.5     0.005478988754882871
                       1     0.014970319421215168
                       1     0.005478988754882871
                     0.5     0.005478988754882871
)");
}

TEST(ConvergenceByHand, Summary)
{
  const Results results = made_convergence();
  EXPECT_EQ(results.findings.summary["refinement"]["meridional_mesh"]["figures"]["omega_terminal"].dump(1),
            R"({
 "values": [
  1.4301234567,
  1.4401234567
 ],
 "order": 1.4501234567,
 "limit": 1.4601234567,
 "bands": [
  0.0014701234567000001,
  0.0014801234567
 ]
})");
  EXPECT_EQ(results.findings.summary["error_bands"]["omega_terminal"].dump(1), R"({
 "value": 1.0401234567,
 "band": 0.0010501234567,
 "unit": "rad/s",
 "richardson": 1.0601234567
})");
  EXPECT_EQ(results.findings.key_figures.dump(1), R"({
 "omega_terminal": 1.0401234567,
 "omega_terminal_band": 0.0010501234567
})");
}

} // namespace
} // namespace stemware::pipeline
