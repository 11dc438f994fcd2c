// The results of `sweep` from cases made by hand, whose numbers are all different; the third has failed.
#include "fem/pipeline/report/plots/plots.h"
#include "fem/pipeline/report/sweep_results.h"
#include "tests/fem/pipeline/report/hand_made_studies.h"

#include <gtest/gtest.h>

namespace stemware::pipeline
{
namespace
{

using namespace test;

Results made(const SweepPlan &plan)
{
  const FinishedCases cases = cases_by_hand(plan);
  return tabulate(plan, cases, find_out(plan, cases));
}

TEST(SweepByHand, Console)
{
  const Results grid = made(grid_by_hand());
  const Results sample = made(sample_by_hand());
  EXPECT_EQ(console_text(grid), R"(
In 3 cases the glass spins up to between 1.25012 rad/s (Load/Moment ratio = 1, Motion/Closure =
paper) and 1.99012 rad/s (Load/Moment ratio = 1.5, Motion/Closure = full). In some of them the
fingers hold the glass at rest (Load/Moment ratio = 1, Motion/Closure = full); see the column "held
by the grip" of sweep.csv. The harmonics of the load beyond the first make it up to 2.07 % faster
(Load/Moment ratio = 1.5, Motion/Closure = full). 1 of 4 cases failed; the column message of
sweep.csv says why.

  quantity                                             least     most
  moment ratio                                       1.02012  1.76012
  contact fraction                                   1.03012  1.77012
  torque at rest (N m)                               1.24012  1.98012
  terminal spin (rad/s)                              1.25012  1.99012
  terminal spin of the first harmonic alone (rad/s)  1.26012  2.00012
  absolute harmonic effect (rad/s)                   1.32012  2.06012
  harmonic effect (%)                                1.33012  2.07012

)");
  EXPECT_EQ(console_text(sample), R"(
In 7 samples the glass spins up to 2.36 ± 0.80 rad/s (mean and standard deviation; 95 % of them lie
between 1.31 and 3.41 rad/s). In some of them the fingers hold the glass at rest (Motion/Mass =
0.290243 kg, Table/Foundation modulus = 2.4434e9 Pa/m); see the column "held by the grip" of
sweep.csv. The harmonics of the load beyond the first change it by 2.44 % (mean; 95 % of the
samples: 1.39 % to 3.49 %). 1 of 8 cases failed; the column message of sweep.csv says why.

                                                               standard
  quantity                                              mean  deviation    2.5 %   97.5 %
  moment ratio                                       2.13012   0.799291  1.07562  3.18462
  contact fraction                                   2.14012   0.799291  1.08562  3.19462
  torque at rest (N m)                               2.35012   0.799291  1.29562  3.40462
  terminal spin (rad/s)                              2.36012   0.799291  1.30562  3.41462
  terminal spin of the first harmonic alone (rad/s)  2.37012   0.799291  1.31562  3.42462
  absolute harmonic effect (rad/s)                   2.43012   0.799291  1.37562  3.48462
  harmonic effect (%)                                2.44012   0.799291  1.38562  3.49462

)");
}

TEST(SweepByHand, CasesOfAGrid)
{
  const Results grid = made(grid_by_hand());
  EXPECT_EQ(csv_lines(file_text(grid, "sweep.csv")), R"(case: 1 | 2 | 3 | 4
Load/Moment ratio (1): 1 | 1 | 1.5 | 1.5
Motion/Closure: paper | full | paper | full
normal force (N): 1.0101234567 | 1.3801234567 |  | 1.7501234567
moment ratio (1): 1.0201234567 | 1.3901234567 |  | 1.7601234567
contact fraction (1): 1.0301234567 | 1.4001234567 |  | 1.7701234567
least load at rest (N/rad): 1.0401234567 | 1.4101234567 |  | 1.7801234567
ring radius (m): 1.0501234567 | 1.4201234567 |  | 1.7901234567
mean radius (m): 1.0601234567 | 1.4301234567 |  | 1.8001234567
a_0 (N/rad): 1.0701234567 | 1.4401234567 |  | 1.8101234567
a_1/a_0 (1): 1.0801234567 | 1.4501234567 |  | 1.8201234567
b_1/a_0 (1): 1.0901234567 | 1.4601234567 |  | 1.8301234567
a_2/a_0 (1): 1.1001234567 | 1.4701234567 |  | 1.8401234567
b_2/a_0 (1): 1.1101234567 | 1.4801234567 |  | 1.8501234567
a_3/a_0 (1): 1.1201234567 | 1.4901234567 |  | 1.8601234567
b_3/a_0 (1): 1.1301234567 | 1.5001234567 |  | 1.8701234567
a_4/a_0 (1): 1.1401234567 | 1.5101234567 |  | 1.8801234567
b_4/a_0 (1): 1.1501234567 | 1.5201234567 |  | 1.8901234567
a_5/a_0 (1): 1.1601234567 | 1.5301234567 |  | 1.9001234567
b_5/a_0 (1): 1.1701234567 | 1.5401234567 |  | 1.9101234567
a_6/a_0 (1): 1.1801234567 | 1.5501234567 |  | 1.9201234567
b_6/a_0 (1): 1.1901234567 | 1.5601234567 |  | 1.9301234567
a_7/a_0 (1): 1.2001234567 | 1.5701234567 |  | 1.9401234567
b_7/a_0 (1): 1.2101234567 | 1.5801234567 |  | 1.9501234567
a_8/a_0 (1): 1.2201234567 | 1.5901234567 |  | 1.9601234567
b_8/a_0 (1): 1.2301234567 | 1.6001234567 |  | 1.9701234567
torque at rest (N m): 1.2401234567 | 1.6101234567 |  | 1.9801234567
terminal spin (rad/s): 1.2501234567 | 1.6201234567 |  | 1.9901234567
terminal spin of the first harmonic alone (rad/s): 1.2601234567 | 1.6301234567 |  | 2.0001234567
terminal spin of the closure's first harmonic (rad/s): 1.2701234567 | 1.6401234567 |  | 2.0101234567
moment balance (rad/s): 1.2801234567 | 1.6501234567 |  | 2.0201234567
grip (rad/s): 1.2901234567 | 1.6601234567 |  | 2.0301234567
where the foot touches (rad/s): 1.3001234567 | 1.6701234567 |  | 2.0401234567
tilt (rad/s): 1.3101234567 | 1.6801234567 |  | 2.0501234567
absolute harmonic effect (rad/s): 1.3201234567 | 1.6901234567 |  | 2.0601234567
harmonic effect (%): 1.3301234567 | 1.7001234567 |  | 2.0701234567
closure effect (%):  |  |  | 
held by the grip (1): 0 | 1 |  | 0
time constant (s): 1.3601234567 | 1.7301234567 |  | 2.1001234567
contact iterations (1): 1.3701234567 | 1.7401234567 |  | 2.1101234567
spin at which it falls over (rad/s):  |  |  | 
moment ratio at which it falls over (1):  |  |  | 
contact outcome: converged | converged |  | converged
status: ok | ok | failed | ok
message:  |  | No contact, "tipping". | 
)");
}

TEST(SweepByHand, RangesOfAGrid)
{
  const Results grid = made(grid_by_hand());
  EXPECT_EQ(report_lines(grid, "Least and largest values", true), R"(quantity | least | at | most | at
normal force (N) | 1.01012 | Load/Moment ratio = 1, Motion/Closure = paper | 1.75012 | Load/Moment ratio = 1.5, Motion/Closure = full
moment ratio | 1.02012 | Load/Moment ratio = 1, Motion/Closure = paper | 1.76012 | Load/Moment ratio = 1.5, Motion/Closure = full
contact fraction | 1.03012 | Load/Moment ratio = 1, Motion/Closure = paper | 1.77012 | Load/Moment ratio = 1.5, Motion/Closure = full
least load at rest (N/rad) | 1.04012 | Load/Moment ratio = 1, Motion/Closure = paper | 1.78012 | Load/Moment ratio = 1.5, Motion/Closure = full
ring radius (m) | 1.05012 | Load/Moment ratio = 1, Motion/Closure = paper | 1.79012 | Load/Moment ratio = 1.5, Motion/Closure = full
mean radius (m) | 1.06012 | Load/Moment ratio = 1, Motion/Closure = paper | 1.80012 | Load/Moment ratio = 1.5, Motion/Closure = full
a0 (N/rad) | 1.07012 | Load/Moment ratio = 1, Motion/Closure = paper | 1.81012 | Load/Moment ratio = 1.5, Motion/Closure = full
torque at rest (N m) | 1.24012 | Load/Moment ratio = 1, Motion/Closure = paper | 1.98012 | Load/Moment ratio = 1.5, Motion/Closure = full
terminal spin (rad/s) | 1.25012 | Load/Moment ratio = 1, Motion/Closure = paper | 1.99012 | Load/Moment ratio = 1.5, Motion/Closure = full
terminal spin of the first harmonic alone (rad/s) | 1.26012 | Load/Moment ratio = 1, Motion/Closure = paper | 2.00012 | Load/Moment ratio = 1.5, Motion/Closure = full
terminal spin of the closure&#39;s first harmonic (rad/s) | 1.27012 | Load/Moment ratio = 1, Motion/Closure = paper | 2.01012 | Load/Moment ratio = 1.5, Motion/Closure = full
moment balance (rad/s) | 1.28012 | Load/Moment ratio = 1, Motion/Closure = paper | 2.02012 | Load/Moment ratio = 1.5, Motion/Closure = full
grip (rad/s) | 1.29012 | Load/Moment ratio = 1, Motion/Closure = paper | 2.03012 | Load/Moment ratio = 1.5, Motion/Closure = full
where the foot touches (rad/s) | 1.30012 | Load/Moment ratio = 1, Motion/Closure = paper | 2.04012 | Load/Moment ratio = 1.5, Motion/Closure = full
tilt (rad/s) | 1.31012 | Load/Moment ratio = 1, Motion/Closure = paper | 2.05012 | Load/Moment ratio = 1.5, Motion/Closure = full
absolute harmonic effect (rad/s) | 1.32012 | Load/Moment ratio = 1, Motion/Closure = paper | 2.06012 | Load/Moment ratio = 1.5, Motion/Closure = full
harmonic effect (%) | 1.33012 | Load/Moment ratio = 1, Motion/Closure = paper | 2.07012 | Load/Moment ratio = 1.5, Motion/Closure = full
held by the grip | 0 | 2 cases | 1 | Load/Moment ratio = 1, Motion/Closure = full
time constant (s) | 1.36012 | Load/Moment ratio = 1, Motion/Closure = paper | 2.10012 | Load/Moment ratio = 1.5, Motion/Closure = full
contact iterations | 1.37012 | Load/Moment ratio = 1, Motion/Closure = paper | 2.11012 | Load/Moment ratio = 1.5, Motion/Closure = full
)");
  EXPECT_EQ(grid.findings.summary["quantities"]["terminal spin"].dump(1), R"({
 "unit": "rad/s",
 "values": 3,
 "least": 1.2501234567,
 "least_case": 1,
 "most": 1.9901234567,
 "most_case": 4
})");
  EXPECT_EQ(grid.findings.key_figures.dump(1), R"({
 "cases": 4,
 "failed": 1,
 "omega_terminal": [
  1.2501234567,
  1.9901234567
 ],
 "harmonic_effect": [
  1.3201234567,
  2.0601234567
 ],
 "harmonic_effect_percent": [
  1.3301234567,
  2.0701234567
 ]
})");
  EXPECT_EQ(report_lines(grid, "Cases that failed", true), R"(cases | first of them | message
1 | Load/Moment ratio = 1.5, Motion/Closure = paper | No contact, &quot;tipping&quot;.
)");
}

TEST(SweepByHand, BandsOfASample)
{
  const Results sample = made(sample_by_hand());
  EXPECT_EQ(report_lines(sample, "Bands and sensitivities", true),
            R"(What the terminal spin depends on; the linear fit explains 41.5 % of its variance
entry | standardised regression coefficient
Motion/Mass | 0.415
Table/Foundation modulus | 0.533
What the harmonic effect depends on; the linear fit explains 41.5 % of its variance
entry | standardised regression coefficient
Motion/Mass | 0.415
Table/Foundation modulus | 0.533
Bands of all samples
quantity | samples | mean | standard deviation | 2.5 % | 97.5 %
normal force (N) | 7 | 2.12012 | 0.799 | 1.06562 | 3.17462
moment ratio | 7 | 2.13012 | 0.799 | 1.07562 | 3.18462
contact fraction | 7 | 2.14012 | 0.799 | 1.08562 | 3.19462
least load at rest (N/rad) | 7 | 2.15012 | 0.799 | 1.09562 | 3.20462
ring radius (m) | 7 | 2.16012 | 0.799 | 1.10562 | 3.21462
mean radius (m) | 7 | 2.17012 | 0.799 | 1.11562 | 3.22462
a0 (N/rad) | 7 | 2.18012 | 0.799 | 1.12562 | 3.23462
torque at rest (N m) | 7 | 2.35012 | 0.799 | 1.29562 | 3.40462
terminal spin (rad/s) | 7 | 2.36012 | 0.799 | 1.30562 | 3.41462
terminal spin of the first harmonic alone (rad/s) | 7 | 2.37012 | 0.799 | 1.31562 | 3.42462
terminal spin of the closure&#39;s first harmonic (rad/s) | 7 | 2.38012 | 0.799 | 1.32562 | 3.43462
moment balance (rad/s) | 7 | 2.39012 | 0.799 | 1.33562 | 3.44462
grip (rad/s) | 7 | 2.40012 | 0.799 | 1.34562 | 3.45462
where the foot touches (rad/s) | 7 | 2.41012 | 0.799 | 1.35562 | 3.46462
tilt (rad/s) | 7 | 2.42012 | 0.799 | 1.36562 | 3.47462
absolute harmonic effect (rad/s) | 7 | 2.43012 | 0.799 | 1.37562 | 3.48462
harmonic effect (%) | 7 | 2.44012 | 0.799 | 1.38562 | 3.49462
held by the grip | 7 | 0.142857 | 0.378 | 0 | 0.85
time constant (s) | 7 | 2.47012 | 0.799 | 1.41562 | 3.52462
contact iterations | 7 | 2.48012 | 0.799 | 1.42562 | 3.53462
)");
}

TEST(SweepByHand, Files)
{
  const Results grid = made(grid_by_hand());
  const Results sample = made(sample_by_hand());
  EXPECT_EQ(file_names(grid), R"(sweep.csv: a row for every case, units in the header
sweep.json: how the cases came about
summary.json: all findings, for programs
parameters.prm: the base study
timings.json: how long it took
)");
  EXPECT_EQ(file_names(sample), R"(sweep.csv: a row for every case, units in the header
statistics.csv: bands and sensitivities of every quantity
sweep.json: how the cases came about
summary.json: all findings, for programs
parameters.prm: the base study
timings.json: how long it took
)");
}

TEST(SweepByHand, StatisticsOfASample)
{
  const SweepPlan plan = sample_by_hand();
  const SweepFindings findings = find_out(plan, cases_by_hand(plan));
  const QuantityFindings &spin = *findings.about("terminal spin");
  const Results results = made(plan);
  const CsvTable table(file_text(results, "statistics.csv"));
  const auto &json = results.findings.summary["quantities"]["terminal spin"];
  std::size_t row = 0;
  while (table.text(row, "quantity") != "terminal spin")
    ++row;
  EXPECT_EQ(table.text(row, "unit"), "rad/s");
  EXPECT_EQ(json["unit"], "rad/s");
  EXPECT_EQ(table.text(row, "values"), "7");
  EXPECT_EQ(json["values"], 7);
  const auto expect = [&](const std::string &title, const nlohmann::ordered_json &value, double expected)
  {
    EXPECT_EQ(table.number(row, title), expected) << title;
    EXPECT_EQ(value, expected) << title;
  };
  expect("mean", json["band"]["mean"], spin.band->mean);
  expect("standard deviation", json["band"]["standard_deviation"], spin.band->deviation);
  expect("2.5 % percentile", json["band"]["percentile_2.5"], spin.band->lower);
  expect("97.5 % percentile", json["band"]["percentile_97.5"], spin.band->upper);
  expect("r squared of the linear fit (1)", json["sensitivity"]["r_squared"], spin.sensitivity->r_squared);
  for (std::size_t i = 0; i < plan.entries.size(); ++i)
  {
    const std::string &path = plan.entries[i].path;
    const auto &entry = json["sensitivity"]["entries"][path];
    expect("regression on " + path + " (1)", entry["regression"], spin.sensitivity->regression[i]);
    // Seven samples are too few for shares of the variance.
    EXPECT_EQ(table.text(row, "first-order share of " + path + " (1)"), "");
    EXPECT_TRUE(entry["first_order"].is_null());
  }
  EXPECT_EQ(results.findings.key_figures["omega_terminal"],
            (nlohmann::ordered_json{ spin.band->lower, spin.band->upper }));
}

TEST(SweepByHand, SamplesAreDrawnOverTheFirstOfEntriesThatCountAlike)
{
  const SweepPlan plan = sample_by_hand();
  const FinishedCases cases = cases_by_hand(plan);
  SweepFindings findings = find_out(plan, cases);
  ASSERT_EQ(plan.entries.size(), 2u);
  for (QuantityFindings &about : findings.quantities)
    if (about.sensitivity)
      about.sensitivity->regression = { 0.5, -0.5 };
  Document document;
  add_sweep_plots(plan, cases, findings, document);
  const std::string label = document.plots["terminal_spin_samples"]["x_label"];
  EXPECT_EQ(label.substr(0, label.find(" (")),
            plan.entries[0].path.substr(plan.entries[0].path.find('/') + 1));
}

} // namespace
} // namespace stemware::pipeline
