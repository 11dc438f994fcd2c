// The results of `sweep` from cases made by hand, whose numbers are all different; the third has failed.
#include "fem/pipeline/output/sweep_results.h"
#include "tests/fem/pipeline/output/hand_made_studies.h"

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
paper) and 1.89012 rad/s (Load/Moment ratio = 1.5, Motion/Closure = full). The harmonics of the load
beyond the first make it up to 1.93 % faster (Load/Moment ratio = 1.5, Motion/Closure = full). 1 of
4 cases failed; the column message of sweep.csv says why.

  quantity                                             least     most
  moment ratio (1)                                   1.02012  1.66012
  contact fraction (1)                               1.03012  1.67012
  torque at rest (N m)                               1.24012  1.88012
  terminal spin (rad/s)                              1.25012  1.89012
  terminal spin of the first harmonic alone (rad/s)  1.26012  1.90012
  absolute harmonic effect (rad/s)                   1.28012  1.92012
  harmonic effect (%)                                1.29012  1.93012

)");
  EXPECT_EQ(console_text(sample), R"(
In 7 samples the glass spins up to 2.21 ± 0.69 rad/s (mean and standard deviation; 95 % of them lie
between 1.30 and 3.12 rad/s). 29 % of the variance is due to Table/Foundation modulus alone. The
harmonics of the load beyond the first change it by 2.25 % (mean; 95 % of the samples: 1.34 % to
3.16 %). 1 of 8 cases failed; the column message of sweep.csv says why.

                                                                                 standard
  quantity                                             least     mean     most  deviation    2.5 %
  moment ratio (1)                                   1.02012  1.98012  2.94012   0.691279  1.06812
  contact fraction (1)                               1.03012  1.99012  2.95012   0.691279  1.07812
  torque at rest (N m)                               1.24012  2.20012  3.16012   0.691279  1.28812
  terminal spin (rad/s)                              1.25012  2.21012  3.17012   0.691279  1.29812
  terminal spin of the first harmonic alone (rad/s)  1.26012  2.22012  3.18012   0.691279  1.30812
  absolute harmonic effect (rad/s)                   1.28012  2.24012  3.20012   0.691279  1.32812
  harmonic effect (%)                                1.29012  2.25012  3.21012   0.691279  1.33812


  quantity                                            97.5 %
  moment ratio (1)                                   2.89212
  contact fraction (1)                               2.90212
  torque at rest (N m)                               3.11212
  terminal spin (rad/s)                              3.12212
  terminal spin of the first harmonic alone (rad/s)  3.13212
  absolute harmonic effect (rad/s)                   3.15212
  harmonic effect (%)                                3.16212

)");
}

TEST(SweepByHand, CasesOfAGrid)
{
  const Results grid = made(grid_by_hand());
  EXPECT_EQ(csv_lines(file_text(grid, "sweep.csv")), R"(case: 1 | 2 | 3 | 4
Load/Moment ratio (1): 1 | 1 | 1.5 | 1.5
Motion/Closure: paper | full | paper | full
normal force (N): 1.0101234567 | 1.3301234567 |  | 1.6501234567
moment ratio (1): 1.0201234567 | 1.3401234567 |  | 1.6601234567
contact fraction (1): 1.0301234567 | 1.3501234567 |  | 1.6701234567
least load (N/rad): 1.0401234567 | 1.3601234567 |  | 1.6801234567
ring radius (m): 1.0501234567 | 1.3701234567 |  | 1.6901234567
mean radius (m): 1.0601234567 | 1.3801234567 |  | 1.7001234567
a_0 (N/rad): 1.0701234567 | 1.3901234567 |  | 1.7101234567
a_1/a_0 (1): 1.0801234567 | 1.4001234567 |  | 1.7201234567
b_1/a_0 (1): 1.0901234567 | 1.4101234567 |  | 1.7301234567
a_2/a_0 (1): 1.1001234567 | 1.4201234567 |  | 1.7401234567
b_2/a_0 (1): 1.1101234567 | 1.4301234567 |  | 1.7501234567
a_3/a_0 (1): 1.1201234567 | 1.4401234567 |  | 1.7601234567
b_3/a_0 (1): 1.1301234567 | 1.4501234567 |  | 1.7701234567
a_4/a_0 (1): 1.1401234567 | 1.4601234567 |  | 1.7801234567
b_4/a_0 (1): 1.1501234567 | 1.4701234567 |  | 1.7901234567
a_5/a_0 (1): 1.1601234567 | 1.4801234567 |  | 1.8001234567
b_5/a_0 (1): 1.1701234567 | 1.4901234567 |  | 1.8101234567
a_6/a_0 (1): 1.1801234567 | 1.5001234567 |  | 1.8201234567
b_6/a_0 (1): 1.1901234567 | 1.5101234567 |  | 1.8301234567
a_7/a_0 (1): 1.2001234567 | 1.5201234567 |  | 1.8401234567
b_7/a_0 (1): 1.2101234567 | 1.5301234567 |  | 1.8501234567
a_8/a_0 (1): 1.2201234567 | 1.5401234567 |  | 1.8601234567
b_8/a_0 (1): 1.2301234567 | 1.5501234567 |  | 1.8701234567
torque at rest (N m): 1.2401234567 | 1.5601234567 |  | 1.8801234567
terminal spin (rad/s): 1.2501234567 | 1.5701234567 |  | 1.8901234567
terminal spin of the first harmonic alone (rad/s): 1.2601234567 | 1.5801234567 |  | 1.9001234567
terminal spin of the closure's first harmonic (rad/s): 1.2701234567 | 1.5901234567 |  | 1.9101234567
absolute harmonic effect (rad/s): 1.2801234567 | 1.6001234567 |  | 1.9201234567
harmonic effect (%): 1.2901234567 | 1.6101234567 |  | 1.9301234567
closure effect (%):  |  |  | 
time constant (s): 1.3101234567 | 1.6301234567 |  | 1.9501234567
contact iterations (1): 1.3201234567 | 1.6401234567 |  | 1.9601234567
contact outcome: converged | converged |  | converged
status: ok | ok | failed | ok
message:  |  | No contact, "tipping". | 
)");
}

TEST(SweepByHand, RangesOfAGrid)
{
  const Results grid = made(grid_by_hand());
  EXPECT_EQ(report_lines(grid, "What comes out", true), R"(Least and largest values
quantity | least | at | most | at
normal force (N) | 1.01012 | Load/Moment ratio = 1, Motion/Closure = paper | 1.65012 | Load/Moment ratio = 1.5, Motion/Closure = full
moment ratio (1) | 1.02012 | Load/Moment ratio = 1, Motion/Closure = paper | 1.66012 | Load/Moment ratio = 1.5, Motion/Closure = full
contact fraction (1) | 1.03012 | Load/Moment ratio = 1, Motion/Closure = paper | 1.67012 | Load/Moment ratio = 1.5, Motion/Closure = full
least load (N/rad) | 1.04012 | Load/Moment ratio = 1, Motion/Closure = paper | 1.68012 | Load/Moment ratio = 1.5, Motion/Closure = full
ring radius (m) | 1.05012 | Load/Moment ratio = 1, Motion/Closure = paper | 1.69012 | Load/Moment ratio = 1.5, Motion/Closure = full
mean radius (m) | 1.06012 | Load/Moment ratio = 1, Motion/Closure = paper | 1.70012 | Load/Moment ratio = 1.5, Motion/Closure = full
a0 (N/rad) | 1.07012 | Load/Moment ratio = 1, Motion/Closure = paper | 1.71012 | Load/Moment ratio = 1.5, Motion/Closure = full
torque at rest (N m) | 1.24012 | Load/Moment ratio = 1, Motion/Closure = paper | 1.88012 | Load/Moment ratio = 1.5, Motion/Closure = full
terminal spin (rad/s) | 1.25012 | Load/Moment ratio = 1, Motion/Closure = paper | 1.89012 | Load/Moment ratio = 1.5, Motion/Closure = full
terminal spin of the first harmonic alone (rad/s) | 1.26012 | Load/Moment ratio = 1, Motion/Closure = paper | 1.90012 | Load/Moment ratio = 1.5, Motion/Closure = full
terminal spin of the closure&#39;s first harmonic (rad/s) | 1.27012 | Load/Moment ratio = 1, Motion/Closure = paper | 1.91012 | Load/Moment ratio = 1.5, Motion/Closure = full
absolute harmonic effect (rad/s) | 1.28012 | Load/Moment ratio = 1, Motion/Closure = paper | 1.92012 | Load/Moment ratio = 1.5, Motion/Closure = full
harmonic effect (%) | 1.29012 | Load/Moment ratio = 1, Motion/Closure = paper | 1.93012 | Load/Moment ratio = 1.5, Motion/Closure = full
time constant (s) | 1.31012 | Load/Moment ratio = 1, Motion/Closure = paper | 1.95012 | Load/Moment ratio = 1.5, Motion/Closure = full
contact iterations (1) | 1.32012 | Load/Moment ratio = 1, Motion/Closure = paper | 1.96012 | Load/Moment ratio = 1.5, Motion/Closure = full
)");
  EXPECT_EQ(grid.findings.summary["quantities"]["terminal spin"].dump(1), R"({
 "unit": "rad/s",
 "values": 3,
 "least": 1.2501234567,
 "least_case": 1,
 "most": 1.8901234567,
 "most_case": 4
})");
  EXPECT_EQ(grid.findings.key_figures.dump(1), R"({
 "cases": 4,
 "failed": 1,
 "omega_terminal": [
  1.2501234567,
  1.8901234567
 ],
 "harmonic_effect": [
  1.2801234567,
  1.9201234567
 ],
 "harmonic_effect_percent": [
  1.2901234567,
  1.9301234567
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
entry | standardised regression coefficient | first-order share of the variance
Motion/Mass | 0.415 | -0.500
Table/Foundation modulus | 0.533 | 0.286
What the harmonic effect depends on; the linear fit explains 41.5 % of its variance
entry | standardised regression coefficient | first-order share of the variance
Motion/Mass | 0.415 | -0.500
Table/Foundation modulus | 0.533 | 0.286
Bands of all samples
quantity | samples | mean | standard deviation | 2.5 % | 97.5 %
normal force (N) | 7 | 1.97012 | 0.691 | 1.05812 | 2.88212
moment ratio (1) | 7 | 1.98012 | 0.691 | 1.06812 | 2.89212
contact fraction (1) | 7 | 1.99012 | 0.691 | 1.07812 | 2.90212
least load (N/rad) | 7 | 2.00012 | 0.691 | 1.08812 | 2.91212
ring radius (m) | 7 | 2.01012 | 0.691 | 1.09812 | 2.92212
mean radius (m) | 7 | 2.02012 | 0.691 | 1.10812 | 2.93212
a0 (N/rad) | 7 | 2.03012 | 0.691 | 1.11812 | 2.94212
torque at rest (N m) | 7 | 2.20012 | 0.691 | 1.28812 | 3.11212
terminal spin (rad/s) | 7 | 2.21012 | 0.691 | 1.29812 | 3.12212
terminal spin of the first harmonic alone (rad/s) | 7 | 2.22012 | 0.691 | 1.30812 | 3.13212
terminal spin of the closure&#39;s first harmonic (rad/s) | 7 | 2.23012 | 0.691 | 1.31812 | 3.14212
absolute harmonic effect (rad/s) | 7 | 2.24012 | 0.691 | 1.32812 | 3.15212
harmonic effect (%) | 7 | 2.25012 | 0.691 | 1.33812 | 3.16212
time constant (s) | 7 | 2.27012 | 0.691 | 1.35812 | 3.18212
contact iterations (1) | 7 | 2.28012 | 0.691 | 1.36812 | 3.19212
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
    expect("first-order share of " + path + " (1)", entry["first_order"], spin.sensitivity->first_order[i]);
  }
  EXPECT_EQ(results.findings.key_figures["omega_terminal"],
            (nlohmann::ordered_json{ spin.band->lower, spin.band->upper }));
}

} // namespace
} // namespace stemware::pipeline
