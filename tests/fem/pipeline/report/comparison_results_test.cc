// The results of `compare` from rows made by hand, whose numbers are all different. Under closure hand the
// elastic foot has no balance.
#include "fem/pipeline/report/comparison_results.h"
#include "tests/fem/pipeline/report/hand_made_studies.h"

#include <gtest/gtest.h>

namespace stemware::pipeline
{
namespace
{

using namespace test;

Results made_comparison()
{
  return tabulate("compare", {}, comparison_by_hand(), add_models);
}

TEST(ComparisonByHand, Console)
{
  const Results results = made_comparison();
  EXPECT_EQ(console_text(results), R"(
With the paper's moment balance a first-harmonic load reaches -1.1301 ± 0.0014 rad/s, formally; with
the friction that this balance leaves out, -3.3501 ± 0.0036 rad/s, formally (moment balance:
+196 %). All harmonics of the elastic foot reach, with the paper's balance, -1.8701 ± 0.0021 rad/s
(harmonics: -0.37 rad/s, +24.7 %), and with the complete balance -4.0901 ± 0.0043 rad/s (harmonics:
-0.37 rad/s, +9.95 %).

From the paper's model to this study's:

                          terminal spin  difference               band
  model, row by row             (rad/s)     (rad/s)  relative  (rad/s)
  the paper's model             -4.3401           -         -  4.4e-03
  moment balance                -4.3901       -0.05   +1.15 %  4.5e-03  formal
  grip                          -4.4401       -0.05   +1.14 %  4.5e-03
  where the foot touches        -4.4901       -0.05   +1.13 %  4.6e-03
  tilt                                -           -         -        -  The foot tips
  harmonics, all                -4.5901           -         -  4.7e-03

Terminal spin by load, all its harmonics kept, and by moment balance, and what the harmonics beyond
the first do to it, each load against its own first harmonic, with tilt for a foot, without for the
rims:

                                                        harmonics,
                       paper        hand        full  closure full
  load             (rad/s)     (rad/s)     (rad/s)         (rad/s)
  first harmonic  -1.13012 f  -2.24012 f  -3.35012 f             0
  elastic foot    -1.87012        none    -4.09012           -0.37

f  formal: the load, or what is left of it, would have to pull on the table

closure hand, elastic foot: no balance. No balance of moments was found

)");
}

// The rims of closed form know no tilt, so their effect of harmonics has another reference than a leaning
// foot's.
TEST(ComparisonByHand, SaysWhatTheEffectOfHarmonicsIsCountedFrom)
{
  Study study;
  EXPECT_NE(
    console_text(tabulate("compare", study, comparison_by_hand(), add_models)).find("with tilt for a foot"),
    std::string::npos);
  study.motion.tilt = false;
  const std::string upright = console_text(tabulate("compare", study, comparison_by_hand(), add_models));
  EXPECT_EQ(upright.find("tilt for a foot"), std::string::npos);
  EXPECT_NE(upright.find("against its own first harmonic:"), std::string::npos) << upright;
}

TEST(ComparisonByHand, AGlassThatDoesNotSpinHasNoPercentages)
{
  Comparison comparison = comparison_by_hand();
  comparison.spin_scale = 10;
  for (SpinRow &row : comparison.rows)
    if (row.terminal)
      row.terminal->omega = 1e-12;
  EXPECT_EQ(tabulate("compare", {}, comparison, add_models).report.answer,
            "The glass does not spin up, whatever its load and its moment balance.");
}

TEST(ComparisonByHand, Table)
{
  const Results results = made_comparison();
  EXPECT_EQ(csv_lines(file_text(results, "compare.csv")),
            R"(closure: paper | paper | paper | hand | hand | hand | full | full | full
load: first harmonic | elastic foot | elastic foot | first harmonic | elastic foot | elastic foot | first harmonic | elastic foot | elastic foot
harmonics: 1 | 1 | 2 | 1 | 1 | 2 | 1 | 1 | 2
all harmonics: 1 | 0 | 1 | 1 | 0 | 1 | 1 | 0 | 1
tau_z at rest (N m): 1.0701234567 | 1.4401234567 | 1.8101234567 | 2.1801234567 |  |  | 3.2901234567 | 3.6601234567 | 4.0301234567
moment ratio at rest (1): 1.1001234567 | 1.4701234567 | 1.8401234567 | 2.2101234567 |  |  | 3.3201234567 | 3.6901234567 | 4.0601234567
terminal omega (rad/s): -1.1301234567 | -1.5001234567 | -1.8701234567 | -2.2401234567 |  |  | -3.3501234567 | -3.7201234567 | -4.0901234567
relative difference to the paper (1): 0 | 0.017101234567000002 | 0.020801234567 | 0.024501234567 |  |  | 0.035601234567 | 0.039301234567 | 0.043001234566999995
least load at terminal omega (N/rad): -1.2601234567 | -1.6301234567 | -2.0001234567 | -2.3701234567 |  |  | -3.4801234567 | -3.8501234567 | -4.2201234567
contact fraction at terminal omega (1): 0.12801234567 | 0.16501234567 | 0.20201234566999998 | 0.23901234567000001 |  |  | 0.35001234567 | 0.38701234567 | 0.42401234567
harmonic effect (rad/s): 0 |  | -0.3700000000000001 | 0 |  |  | 0 |  | -0.36999999999999966
relative harmonic effect (1): 0 |  | 0.246646366569011 | 0 |  |  | 0 |  | 0.09945906481507326
state: formal | lift-off | lift-off | formal | no balance | no balance | formal | lift-off | lift-off
message:  |  |  |  | No balance of moments was found | No balance of moments was found |  |  | 
)");
}

TEST(ComparisonByHand, Report)
{
  const Results results = made_comparison();
  EXPECT_EQ(report_lines(results, "Harmonics beside moment balances"),
            R"(Terminal spin (rad/s) by load and harmonics kept, and by moment balance
load: first harmonic | elastic foot, n = 1 | elastic foot, all
paper: -1.13012 (formal) | -1.50012 | -1.87012
against the paper: 0 % | +1.71 % | +2.08 %
hand: -2.24012 (formal) | no balance | no balance
against the paper: +2.45 % | – | –
full: -3.35012 (formal) | -3.72012 | -4.09012
against the paper: +3.56 % | +3.93 % | +4.3 %
)");
  EXPECT_EQ(report_lines(results, "All rows"), R"(Closure paper
load: first harmonic | elastic foot, n = 1 | elastic foot, all
τz at rest (N m): 1.070123 | 1.440123 | 1.810123
m at rest: 1.1001 | 1.4701 | 1.8401
terminal spin (rad/s): -1.130123 | -1.500123 | -1.870123
least λ at the terminal spin (N/rad): -1.26 | -1.63 | -2
rim that carries: 12.8 % | 16.5 % | 20.2 %
: formal | lift-off | lift-off
Closure hand
load: first harmonic | elastic foot, n = 1 | elastic foot, all
τz at rest (N m): 2.180123 | – | –
m at rest: 2.2101 | – | –
terminal spin (rad/s): -2.240123 | – | –
least λ at the terminal spin (N/rad): -2.37 | – | –
rim that carries: 23.9 % | – | –
: formal | no balance | no balance
Closure full
load: first harmonic | elastic foot, n = 1 | elastic foot, all
τz at rest (N m): 3.290123 | 3.660123 | 4.030123
m at rest: 3.3201 | 3.6901 | 4.0601
terminal spin (rad/s): -3.350123 | -3.720123 | -4.090123
least λ at the terminal spin (N/rad): -3.48 | -3.85 | -4.22
rim that carries: 35.0 % | 38.7 % | 42.4 %
: formal | lift-off | lift-off
)");
}

TEST(ComparisonByHand, Summary)
{
  const Results results = made_comparison();
  EXPECT_EQ(json_lines(results.findings.summary["comparison"]),
            R"(closure: "paper" | "paper" | "paper" | "hand" | "hand" | "hand" | "full" | "full" | "full"
load: "first harmonic" | "elastic foot" | "elastic foot" | "first harmonic" | "elastic foot" | "elastic foot" | "first harmonic" | "elastic foot" | "elastic foot"
harmonics: 1 | 1 | 2 | 1 | 1 | 2 | 1 | 1 | 2
all_harmonics: true | false | true | true | false | true | true | false | true
tau_at_rest: 1.0701234567 | 1.4401234567 | 1.8101234567 | 2.1801234567 | null | null | 3.2901234567 | 3.6601234567 | 4.0301234567
moment_ratio_at_rest: 1.1001234567 | 1.4701234567 | 1.8401234567 | 2.2101234567 | null | null | 3.3201234567 | 3.6901234567 | 4.0601234567
omega_terminal: -1.1301234567 | -1.5001234567 | -1.8701234567 | -2.2401234567 | null | null | -3.3501234567 | -3.7201234567 | -4.0901234567
omega_terminal_band: 0.0012901234566999999 | 0.0016601234567 | 0.0020301234567000003 | 0.0024001234567 | null | null | 0.0035101234567000003 | 0.0038801234567 | 0.0042501234567
difference_to_paper: 0.0 | 0.017101234567000002 | 0.020801234567 | 0.024501234567 | null | null | 0.035601234567 | 0.039301234567 | 0.043001234566999995
load_minimum_at_terminal: -1.2601234567 | -1.6301234567 | -2.0001234567 | -2.3701234567 | null | null | -3.4801234567 | -3.8501234567 | -4.2201234567
contact_fraction_at_terminal: 0.12801234567 | 0.16501234567 | 0.20201234566999998 | 0.23901234567000001 | null | null | 0.35001234567 | 0.38701234567 | 0.42401234567
harmonic_effect: 0.0 | null | -0.3700000000000001 | 0.0 | null | null | 0.0 | null | -0.36999999999999966
harmonic_effect_relative: 0.0 | null | 0.246646366569011 | 0.0 | null | null | 0.0 | null | 0.09945906481507326
state: "formal" | "lift-off" | "lift-off" | "formal" | "no balance" | "no balance" | "formal" | "lift-off" | "lift-off"
message: null | null | null | null | "No balance of moments was found" | "No balance of moments was found" | null | null | null
)");
  EXPECT_EQ(results.findings.key_figures.dump(1), R"({
 "omega_terminal": -4.0901234567,
 "omega_terminal_band": 0.0042501234567,
 "harmonic_effect": -0.36999999999999966,
 "harmonic_effect_relative": 0.09945906481507326
})");
}

} // namespace
} // namespace stemware::pipeline
