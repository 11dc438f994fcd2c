// The results of `run` from a study made by hand, whose numbers are all different: each heading, unit and
// digit of every table stands beside the values that belong there.
#include "fem/pipeline/output/run_results.h"
#include "tests/fem/pipeline/output/hand_made_studies.h"

#include <gtest/gtest.h>

namespace stemware::pipeline
{
namespace
{

using namespace test;

Results made_run()
{
  const RunByHand by_hand;
  return tabulate(by_hand.study, by_hand.report, by_hand.spin, by_hand.bands);
}

TEST(RunByHand, TruncationsInFourForms)
{
  const Results results = made_run();
  EXPECT_EQ(console_tables(results),
            R"(             torque at rest  terminal spin   change  bound on torque  least load
  harmonics           (N m)        (rad/s)  of spin            (N m)     (N/rad)
          1        1.460123     -1.5201235  +1.71 %        1.720e-06        -1.5
          2        1.830123     -1.8901235  +2.08 %        2.090e-06       -1.87
)");
  EXPECT_EQ(data_lines(file_text(results, "truncation.dat")),
            R"(# The answer with the load cut off after some harmonics
harmonics (1): 1 | 2
tau_z at rest (N m): 1.4601234567 | 1.8301234567
terminal omega (rad/s): -1.5201234567 | -1.8901234567
relative change of terminal omega to all harmonics, nan where that is 0 (1): 0.017101234567000002 | 0.020801234567
a-priori bound on the change of tau_z at the terminal spin (N m): 1.7201234567000001e-6 | 2.0901234567000004e-6
minimum of the load at rest (N/rad): -1.5001234567 | -1.8701234567
)");
  EXPECT_EQ(report_lines(results, "Fewer harmonics"), R"(The answer with the load cut off after some harmonics
harmonics: 1 | 2
τz at rest (N m): 1.460123 | 1.830123
terminal spin (rad/s): -1.5201235 | -1.8901235
change of spin: +1.71 % | +2.08 %
bound on Δτz (N m): 1.72e-06 | 2.09e-06
least load (N/rad): -1.5 | -1.87
)");
  EXPECT_EQ(json_lines(results.findings.summary["truncation"]), R"(harmonics: 1 | 2
tau_at_rest: 1.4601234567 | 1.8301234567
omega_terminal: -1.5201234567 | -1.8901234567
relative_change: 0.017101234567000002 | 0.020801234567
bound: 1.7201234567000001e-06 | 2.0901234567000004e-06
load_minimum: -1.5001234567 | -1.8701234567
)");
}

TEST(RunByHand, MomentBalances)
{
  const Results results = made_run();
  EXPECT_EQ(report_lines(results, "Moment balances"), R"(A first-harmonic load in balance at every spin
closure: paper | hand | full
τz at rest (N m): 2.20012 | 2.57012 | 2.94012
terminal spin (rad/s): -2.26012 | – | -3.00012
moment ratio at rest: 2.23 | 2.6 | 2.97
at the terminal spin: 2.38 | – | 3.12
:  | formal | formal
)");
  EXPECT_EQ(results.findings.summary["closures"].dump(1), R"({
 "paper": {
  "tau_at_rest": 2.2001234567,
  "omega_terminal": -2.2601234567,
  "moment_ratio_at_rest": 2.2301234567,
  "moment_ratio_at_terminal": 2.3801234567,
  "formal": false
 },
 "hand": {
  "tau_at_rest": 2.5701234567,
  "omega_terminal": null,
  "moment_ratio_at_rest": 2.6001234567,
  "moment_ratio_at_terminal": null,
  "formal": true
 },
 "full": {
  "tau_at_rest": 2.9401234567,
  "omega_terminal": -3.0001234567,
  "moment_ratio_at_rest": 2.9701234567,
  "moment_ratio_at_terminal": 3.1201234567,
  "formal": true
 }
})");
}

TEST(RunByHand, FrictionOnTheRingAndOfThePressure)
{
  const Results results = made_run();
  EXPECT_EQ(report_lines(results, "Torque and spin"), R"(Friction of the table on the glass
: equivalent ring, at rest | equivalent ring, at the terminal spin | pressure field p(r, θ), at rest | pressure field p(r, θ), at the terminal spin
τz (N m): 1.83012 | 1.98012 | 1.32012 | 1.35012
Tx (N): 1.84012 | 1.99012 | 1.33012 | 1.36012
Ty (N): 1.85012 | 2.00012 | 1.34012 | 1.37012
)");
  EXPECT_EQ(results.findings.summary["resolved"].dump(1), R"({
 "at_rest": {
  "torque": 1.3201234567,
  "force": [
   1.3301234567,
   1.3401234567
  ],
  "ring_torque": 1.8301234567,
  "ring_force": [
   1.8401234567,
   1.8501234567
  ]
 },
 "at_terminal": {
  "torque": 1.3501234567,
  "force": [
   1.3601234567,
   1.3701234567
  ],
  "ring_torque": 1.9801234567,
  "ring_force": [
   1.9901234567,
   2.0001234567
  ]
 }
})");
}

TEST(RunByHand, Contact)
{
  const Results results = made_run();
  EXPECT_EQ(report_lines(results, "The contact at rest", true), R"(body | solid
cells | 101
unknowns | 102
contact nodes | 103
of them under load | 104
side by side across the contact | 105
outcome | narrow contact
Newton steps | 106
|Σf - N| / N | 1.2e-10
|Σr×f - MN| / (N R) | 1.2e-11
residual of the body&#39;s equilibrium | 1.2e-12
table moved by q0 (m) | 1.21012
table tilted by q1 (rad) | 1.22012
table tilted by q2 (rad) | 1.23012
)");
  EXPECT_EQ(results.findings.summary["contact"].dump(1), R"({
 "body": "solid",
 "friction_coupling": "none",
 "outcome": "narrow contact",
 "mesh": {
  "cells": 101,
  "round_rim": false,
  "rim_radius": 1.1601234567,
  "land_area_deficit": 1.1701234567
 },
 "unknowns": 102,
 "contact_nodes": 103,
 "loaded_nodes": 104,
 "nodes_across": 105,
 "iterations": 106,
 "linear_iterations": 107,
 "force_residual": 1.1801234567e-10,
 "moment_residual": 1.1901234567e-11,
 "equilibrium_residual": 1.2001234567000001e-12,
 "table_motion": [
  1.2101234567,
  1.2201234567,
  1.2301234567
 ]
})");
  EXPECT_EQ(data_lines(file_text(results, "contact_history.dat")), R"(# Newton steps of the contact
step (1): 1 | 2
loaded places (1): 201 | 204
changed places (1): 202 | 205
relative imbalance of forces (1): 1.2401234567 | 1.2601234567
share of the step taken (1): 1.2501234567 | 1.2701234567
iterations of the linear solver (1): 203 | 206
)");
  EXPECT_EQ(
    file_text(results, "footprint.dat"),
    R"(# Pressure of the foot on the table at rest, where there is some: a grid, one block for each azimuth
# 1: r (m)
# 2: theta (rad)
# 3: pressure (Pa)
1.2801234567 0.25 1.29012
1.3001234567 0.25 1.31012

)");
}

TEST(RunByHand, LoadAndItsHarmonics)
{
  const Results results = made_run();
  EXPECT_EQ(results.findings.summary["load"].dump(1), R"({
 "a": [
  1.0101234567,
  1.0201234567,
  1.0401234567
 ],
 "b": [
  0.0,
  1.0301234567,
  1.0501234567
 ],
 "normal_force": 1.0701234567,
 "moment": [
  1.0801234567,
  1.0901234567
 ],
 "moment_ratio": 1.1001234567,
 "ring_radius": 1.0601234567,
 "mean_radius": 1.1101234567,
 "contact_fraction": 0.11201234567,
 "minimum": 1.1301234567
})");
  EXPECT_EQ(report_lines(results, "The load on the table"),
            R"(Harmonics of the load over its mean, a0 = 1.01012 N/rad
n: 1 | 2
an / a0: 1.0099 | 1.0297
bn / a0: 1.0198 | 1.0396
amplitude / a0: 1.43523 | 1.46323
largest at θ (degrees): 45.3 | 22.6
)");
  EXPECT_EQ(
    data_lines(file_text(results, "load_lines.dat")),
    R"(# Load on the table round the ring at rest, pointwise: at the azimuths of the contact's lines, 0 where they carry none
theta (rad): 0.5 | 1.5
lambda (N/rad): 1.1401234567 | 1.1501234567
)");
}

TEST(RunByHand, RingCouplingAndWavinessOfTheSummary)
{
  const Results results = made_run();
  EXPECT_EQ(results.findings.summary["ring"].dump(1), R"({
 "tau_at_rest": 1.8301234567,
 "tau_closed_form": 0.32403703701,
 "omega_terminal": -1.8901234567,
 "time_constant": 1.9101234567,
 "no_lift_off": false,
 "moment_ratio_at_terminal": 2.0101234567,
 "phase_dependent": true,
 "spin_ripple": 3.4301234567
})");
  EXPECT_EQ(results.findings.summary["coupling"].dump(1), R"({
 "balanced_spins": 301,
 "contact_solutions": 302,
 "response_error": 1.3801234567,
 "interpolation_error": 1.3901234567
})");
  EXPECT_EQ(results.findings.summary["waviness"].dump(1), R"({
 "spin_ripple": 3.4301234567,
 "spin_uncertainty": 3.4401234567,
 "zero_of_mean_torque": 3.4501234567,
 "torque_ripple": 3.4601234567,
 "least_load": 3.4701234567,
 "least_contact_fraction": 3.4801234567,
 "glass_phases": 401,
 "table_phases": 402,
 "spins": 403,
 "interpolation_error": 3.4901234567
})");
  EXPECT_EQ(results.findings.key_figures.dump(1), R"({
 "tau_at_rest": 1.8301234567,
 "omega_terminal": -1.8901234567,
 "omega_terminal_band": 0.0036101234566999997,
 "omega_terminal_first_harmonic": -1.5201234567,
 "relative_change": 0.017101234567000002
})");
}

TEST(RunByHand, CurvesOverSpinTimeAndPhase)
{
  const Results results = made_run();
  EXPECT_EQ(data_lines(file_text(results, "torque.dat")),
            R"(# Friction of the table on the ring against its spin
omega (rad/s): -3.2501234567 | 3.2601234567
slip ratio omega R / v (1): 3.2701234567 | 3.2801234567
tau_z, all harmonics (N m): 3.2901234567 | 3.3201234567
T_x (N): 3.3001234567 | 3.3301234567
T_y (N): 3.3101234567 | 3.3401234567
tau_z, harmonics up to 1 (N m): 3.3501234567 | 3.3601234567
)");
  EXPECT_EQ(data_lines(file_text(results, "spin_up.dat")),
            R"(# Spin-up from rest; columns 3 to 5 from loads interpolated in omega, within 1.39012 of a_0
time (s): 0 | 3.3701234567
omega, adaptive (rad/s): 0 | 3.3801234567
omega, forward Euler (rad/s): 0 | 3.3901234567
omega, first harmonic alone, adaptive (rad/s): 0 | 3.4001234567
yaw angle, adaptive (rad): 0 | 3.4101234567
)");
  EXPECT_EQ(data_lines(file_text(results, "phases.dat")),
            R"(# Yaw torque over the phase: where the marks of glass and table stand in the slip frame
mark of the glass (rad): 3.5001234567
mark of the table (rad): 3.5101234567
tau_z at rest (N m): 3.5201234567
tau_z at the mean spin in the long run (N m): 3.5301234567
)");
}

TEST(RunByHand, SpinUpPlotDrawsTheCurvesThatItNames)
{
  const Results results = made_run();
  EXPECT_EQ(plot_data(results, "spin_up"), R"(# all harmonics
# 1: time (s)
# 2: spin ω (rad/s)
                       0                        0
            3.3701234567             3.3801234567


# first harmonic
# 1: time (s)
# 2: spin ω (rad/s)
                       0                        0
            3.3701234567             3.4001234567


# the paper's model
# 1: time (s)
# 2: spin ω (rad/s)
                       0                        0
            3.3701234567             3.4201234567
)");
}

TEST(RunByHand, ErrorBands)
{
  const Results results = made_run();
  EXPECT_EQ(report_lines(results, "Error bands"), R"(The study as it is; harmonics not listed are zero
quantity: b1/a0 | a2/a0 | terminal spin
value: 3.54012346 | 3.57012346 | 3.60012346
band: 3.6e-03 | 3.6e-03 | 3.7e-03
Richardson value: 3.56012346 | 3.59012346 | 3.62012346
unit: 1 | 1 | rad/s
)");
  EXPECT_EQ(results.findings.summary["error_bands"].dump(1), R"({
 "a1": {
  "value": 0.0,
  "band": 0.0,
  "unit": "1"
 },
 "b1": {
  "value": 3.5401234567,
  "band": 0.0035501234567000004,
  "unit": "1"
 },
 "a2": {
  "value": 3.5701234567,
  "band": 0.0035801234567,
  "unit": "1"
 },
 "b2": {
  "value": 0.0,
  "band": 0.0,
  "unit": "1"
 },
 "omega_terminal": {
  "value": 3.6001234567,
  "band": 0.0036101234566999997,
  "unit": "rad/s"
 }
})");
}

TEST(RunByHand, ModelsAndFiles)
{
  const Results results = made_run();
  EXPECT_EQ(report_lines(results, "What changes the spin"),
            R"(Terminal spin of the same glass in models of increasing detail
load: first harmonic | first harmonic | first harmonic | all 2 harmonics
moment balance: closure paper | closure full | closure full | closure full
terminal spin (rad/s): -2.26012 | -3.00012 | -1.52012 | -1.89012
effect:  | closure: +32.7 % |  | harmonics: +24.3 %
)");
  EXPECT_EQ(file_names(results), R"(summary.json: all numbers, for programs
parameters.prm: the study, to be run again
load.dat: λ(θ) at rest
harmonics.dat: its Fourier coefficients; Load/File reads them
torque.dat: τ_z, T_x, T_y against the spin
spin_up.dat: the spin against time
truncation.dat: the answer after 1, 2, 3, 4, 6, 8 ... harmonics
phases.dat: τ_z by the orientation of glass and table
load_lines.dat: λ(θ) at rest where the contact was solved
footprint.dat: pressure p(r, θ) of the foot on the table at rest
contact_history.dat: Newton steps of the contact
fields/contact.vtu: displacement, stress and contact pressure for ParaView
timings.json: how long it took
)");
}

TEST(RunByHand, LoadOverTheAzimuth)
{
  const RunByHand by_hand;
  const Results results = made_run();
  const Table table = std::get<Table>(results.files.at(2).content);
  ASSERT_EQ(results.files.at(2).name, "load.dat");
  for (const auto &[c, title] :
       { std::pair(0u, "theta (rad)"), std::pair(1u, "lambda, all harmonics (N/rad)"),
         std::pair(2u, "lambda, first harmonic (N/rad)") })
    EXPECT_EQ(with_unit(table.columns[c].quantity.name, table.columns[c].quantity.unit), title);
  ASSERT_EQ(table.n_rows(), 721u);
  const ring::RingStack &load = by_hand.report.load.rings;
  for (std::size_t i = 0; i < table.n_rows(); ++i)
  {
    const double theta = 2 * std::acos(-1.) * static_cast<double>(i) / 720;
    EXPECT_NEAR(std::get<double>(table.columns[0].cells[i]), theta, 1e-14);
    EXPECT_NEAR(std::get<double>(table.columns[1].cells[i]), load(theta), 1e-13);
    EXPECT_NEAR(std::get<double>(table.columns[2].cells[i]), load.truncated(1)(theta), 1e-13);
  }
}

TEST(RunByHand, WithoutAContactThereIsNothingAboutOne)
{
  const RunByHand by_hand;
  ContactReport report = by_hand.report;
  report.foot.reset();
  report.coupling.reset();
  const Results without = tabulate(by_hand.study, report, by_hand.spin, {});
  for (const char *key : { "contact", "resolved", "coupling" })
    EXPECT_TRUE(without.findings.summary[key].is_null()) << key;
  EXPECT_FALSE(without.findings.summary.contains("error_bands"));
  EXPECT_THROW(file_text(without, "contact_history.dat"), std::out_of_range);
  EXPECT_THROW(report_lines(without, "The contact at rest"), std::out_of_range);
}

} // namespace
} // namespace stemware::pipeline
