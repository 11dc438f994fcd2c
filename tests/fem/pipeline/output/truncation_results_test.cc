// The results of `truncate` from a study made by hand, whose numbers are all different. The row with two
// harmonics has no balance.
#include "fem/pipeline/output/truncation_results.h"
#include "tests/fem/pipeline/output/hand_made_studies.h"

#include <gtest/gtest.h>

namespace stemware::pipeline
{
namespace
{

using namespace test;

Results made_truncation()
{
  const TruncationByHand by_hand;
  return tabulate(by_hand.study, by_hand.load, by_hand.truncations);
}

TEST(TruncationByHand, Console)
{
  const Results results = made_truncation();
  EXPECT_EQ(console_text(results), R"(
With the first harmonic of its load alone the glass spins up to -2.17012 rad/s, with all 3 to
-2.5401 ± 0.0019 rad/s (harmonics: +17 %). (Truncated afterwards, with the moment unchanged, the
first alone leaves -1.31012 rad/s.) From 3 harmonics on the spin is right to 1e-4. For scale: the
friction that the paper's moment balance leaves out makes the glass 24.4 % faster under a
first-harmonic load (-3.77012 instead of -3.03012 rad/s, formally: such a load would have to pull on
the table).

Truncated afterwards (moment unchanged):

             last one  terminal spin   change  omega(t) off by  bound on torque  tau at 0
  harmonics  over a_0        (rad/s)  of spin          (rad/s)            (N m)     (N m)
          1  1.43e+00     -1.3101235   +1.5 %         1.54e-03         1.51e-06   1.25012
          2  0.00e+00              -        -                -                -         -
          3  1.45e+00     -1.6801235  +1.87 %         1.91e-03         1.88e-06   1.62012

             tau at -1.5  tau at -3  least load  pulls with
  harmonics        (N m)      (N m)     (N/rad)      (of N)
          1      1.48012    1.49012        0.25           -
          2            -          -           0           -
          3      1.85012    1.86012       -1.81       1.8 %

Truncated in the loop (moment recomputed):

             last one  terminal spin   change  omega(t) off by  bound on torque  tau at 0
  harmonics  over a_0        (rad/s)  of spin          (rad/s)            (N m)     (N m)
          1  1.42e+00     -2.1701235  +2.36 %         2.40e-03         2.37e-06   2.11012
          3  1.43e+00     -2.5401235  +2.73 %         2.77e-03         2.74e-06   2.48012

             tau at -1.5  tau at -3  least load  pulls with
  harmonics        (N m)      (N m)     (N/rad)      (of N)
          1      2.34012    2.35012        -2.3       2.3 %
          3      2.71012    2.72012       -2.67       2.7 %

)");
}

TEST(TruncationByHand, DataFiles)
{
  const Results results = made_truncation();
  EXPECT_EQ(data_lines(file_text(results, "truncation.dat")),
            R"(# The answer with the load cut off after some harmonics; nan: there is none
harmonics (1): 1 | 2 | 3
amplitude of the highest one over a_0 at rest (1): 1.4320502599150735 | 0 | 1.4459473054713168
tau_z at rest (N m): 1.2501234567 | nan | 1.6201234567
terminal omega (rad/s): -1.3101234567 | nan | -1.6801234567
relative change of terminal omega to all harmonics (1): 0.015001234567 | nan | 0.018701234567
largest deviation of omega(t) from all harmonics (rad/s): 0.0015401234566999999 | nan | 0.0019101234567
deviation of omega(t) at the end (rad/s): 0.0015501234567 | nan | 0.0019201234567
a-priori bound on the change of tau_z at the terminal spin of all harmonics (N m): 1.5101234567e-6 | nan | 1.8801234567e-6
ring radius at the terminal spin (m): 1.3901234567 | nan | 1.7601234567
moment ratio at the terminal spin (1): 1.4301234567 | nan | 1.8001234567
minimum of the load at rest (N/rad): 0.25 | nan | -1.6601234567
minimum of the load at the terminal spin (N/rad): 0.25 | nan | -1.8101234567
share of N that would have to pull at rest (1): 0.013001234567 | nan | 0.016701234567
share of N that would have to pull at the terminal spin (1): 0.014501234567 | nan | 0.018201234567
1 if the load is negative somewhere (1): 0 | 0 | 1
tau_z at omega = -1.5 rad/s (N m): 1.4801234567 | nan | 1.8501234567
tau_z at omega = -3 rad/s (N m): 1.4901234567 | nan | 1.8601234567
)");
  EXPECT_EQ(data_lines(file_text(results, "truncation_self_consistent.dat")),
            R"(# The answer with the load cut off after some harmonics; nan: there is none
harmonics (1): 1 | 3
amplitude of the highest one over a_0 at rest (1): 1.4245650187484233 | 1.434668996105827
tau_z at rest (N m): 2.1101234567 | 2.4801234567
terminal omega (rad/s): -2.1701234567 | -2.5401234567
relative change of terminal omega to all harmonics (1): 0.023601234566999998 | 0.027301234567
largest deviation of omega(t) from all harmonics (rad/s): 0.0024001234567 | 0.0027701234567
deviation of omega(t) at the end (rad/s): 0.0024101234567 | 0.0027801234567
a-priori bound on the change of tau_z at the terminal spin of all harmonics (N m): 2.3701234567e-6 | 2.7401234567e-6
ring radius at the terminal spin (m): 2.2501234567 | 2.6201234567
moment ratio at the terminal spin (1): 2.2901234567 | 2.6601234567
minimum of the load at rest (N/rad): -2.1501234567 | -2.5201234567
minimum of the load at the terminal spin (N/rad): -2.3001234567 | -2.6701234567
share of N that would have to pull at rest (1): 0.021601234567 | 0.025301234567
share of N that would have to pull at the terminal spin (1): 0.023101234567 | 0.026801234567
1 if the load is negative somewhere (1): 1 | 1
tau_z at omega = -1.5 rad/s (N m): 2.3401234567 | 2.7101234567
tau_z at omega = -3 rad/s (N m): 2.3501234567 | 2.7201234567
)");
  EXPECT_EQ(data_lines(file_text(results, "spin_up.dat")), R"(# Spin-up from rest
time (s): 0 | 1.1601234567
omega, harmonics up to 1 (rad/s): 0 | -1.5301234567
omega, harmonics up to 3 (rad/s): 0 | -1.9001234567
)");
  EXPECT_EQ(data_lines(file_text(results, "spin_up_self_consistent.dat")), R"(# Spin-up from rest
time (s): 0 | 1.1601234567
omega, harmonics up to 1 (rad/s): 0 | -2.3901234567
omega, harmonics up to 3 (rad/s): 0 | -2.7601234567
)");
}

TEST(TruncationByHand, Report)
{
  const Results results = made_truncation();
  EXPECT_EQ(report_lines(results, "Truncated afterwards (moment unchanged)"), R"(Afterwards: the spin
harmonics: 1 | 2 | 3
amplitude of the last / a0: 1.432e+00 | 0.000e+00 | 1.446e+00
terminal spin (rad/s): -1.3101235 | – | -1.6801235
change of spin: +1.5 % | – | +1.87 %
ω(t) off by (rad/s): 1.54e-03 | – | 1.91e-03
at the end (rad/s): 1.55e-03 | – | 1.92e-03
bound on Δτz (N m): 1.51e-06 | – | 1.88e-06
Afterwards: torque and load, the worse of rest and terminal spin
harmonics: 1 | 2 | 3
τz at rest (N m): 1.25012 | – | 1.62012
τz at -1.5 rad/s (N m): 1.48012 | – | 1.85012
τz at -3 rad/s (N m): 1.49012 | – | 1.86012
least load (N/rad): 0.25 | 0 | -1.81
would have to pull (of N): – | – | 1.82 %
m at the terminal spin: 1.4301 | – | 1.8001
)");
  EXPECT_EQ(report_lines(results, "Truncated in the loop (moment recomputed)"), R"(In the loop: the spin
harmonics: 1 | 3
amplitude of the last / a0: 1.425e+00 | 1.435e+00
terminal spin (rad/s): -2.1701235 | -2.5401235
change of spin: +2.36 % | +2.73 %
ω(t) off by (rad/s): 2.40e-03 | 2.77e-03
at the end (rad/s): 2.41e-03 | 2.78e-03
bound on Δτz (N m): 2.37e-06 | 2.74e-06
In the loop: torque and load, the worse of rest and terminal spin
harmonics: 1 | 3
τz at rest (N m): 2.11012 | 2.48012
τz at -1.5 rad/s (N m): 2.34012 | 2.71012
τz at -3 rad/s (N m): 2.35012 | 2.72012
least load (N/rad): -2.3 | -2.67
would have to pull (of N): 2.31 % | 2.68 %
m at the terminal spin: 2.2901 | 2.6601
)");
  EXPECT_EQ(file_names(results), R"(summary.json: all numbers, for programs
parameters.prm: the study, to be run again
harmonics.dat: Fourier coefficients of the load at rest; Load/File reads them
truncation.dat: the answer by the number of harmonics, truncated afterwards
spin_up.dat: the spin against time by the number of harmonics, truncated afterwards
truncation_self_consistent.dat: the answer by the number of harmonics, truncated in the loop
spin_up_self_consistent.dat: the spin against time by the number of harmonics, truncated in the loop
timings.json: how long it took
)");
}

TEST(TruncationByHand, Summary)
{
  const Results results = made_truncation();
  EXPECT_EQ(json_lines(results.findings.summary["truncation"]), R"(harmonics: 1 | 2 | 3
amplitude: 1.4320502599150735 | 0.0 | 1.4459473054713168
tau_at_rest: 1.2501234567 | null | 1.6201234567
torque: [1.4801234567,1.4901234567] | [null,null] | [1.8501234567,1.8601234567]
omega_terminal: -1.3101234567 | null | -1.6801234567
relative_change: 0.015001234567 | null | 0.018701234567
spin_up_deviation: 0.0015401234566999999 | null | 0.0019101234567
spin_up_deviation_at_end: 0.0015501234567 | null | 0.0019201234567
bound: 1.5101234567e-06 | null | 1.8801234567e-06
pulls: false | false | true
load_minimum: 0.25 | null | -1.6601234567
pulling_share: 0.013001234567 | null | 0.016701234567
load_minimum_at_terminal: 0.25 | null | -1.8101234567
pulling_share_at_terminal: 0.014501234567 | null | 0.018201234567
load_at_terminal: {"a":[1.3401234567,1.3501234567,1.3701234567],"b":[0.0,1.3601234567,1.3801234567],"ring_radius":1.3901234567,"moment_ratio":1.4301234567} | null | {"a":[1.7101234567,1.7201234567,1.7401234567],"b":[0.0,1.7301234567,1.7501234567],"ring_radius":1.7601234567,"moment_ratio":1.8001234567}
trouble: null | "No balance of moments was found" | null
)");
  EXPECT_EQ(json_lines(results.findings.summary["truncation_self_consistent"]), R"(harmonics: 1 | 3
amplitude: 1.4245650187484233 | 1.434668996105827
tau_at_rest: 2.1101234567 | 2.4801234567
torque: [2.3401234567,2.3501234567] | [2.7101234567,2.7201234567]
omega_terminal: -2.1701234567 | -2.5401234567
relative_change: 0.023601234566999998 | 0.027301234567
spin_up_deviation: 0.0024001234567 | 0.0027701234567
spin_up_deviation_at_end: 0.0024101234567 | 0.0027801234567
bound: 2.3701234567e-06 | 2.7401234567e-06
pulls: true | true
load_minimum: -2.1501234567 | -2.5201234567
pulling_share: 0.021601234567 | 0.025301234567
load_minimum_at_terminal: -2.3001234567 | -2.6701234567
pulling_share_at_terminal: 0.023101234567 | 0.026801234567
load_at_terminal: {"a":[2.2001234567,2.2101234567,2.2301234567],"b":[0.0,2.2201234567,2.2401234567],"ring_radius":2.2501234567,"moment_ratio":2.2901234567} | {"a":[2.5701234567,2.5801234567,2.6001234567],"b":[0.0,2.5901234567,2.6101234567],"ring_radius":2.6201234567,"moment_ratio":2.6601234567}
trouble: null | null
)");
  EXPECT_EQ(results.findings.key_figures.dump(1), R"({
 "omega_terminal": -2.5401234567,
 "omega_terminal_band": 0.0018401234567,
 "relative_change_first_harmonic": 0.015001234567,
 "relative_change_first_harmonic_self_consistent": 0.023601234566999998,
 "closure_effect": 0.24421447197597268,
 "harmonics_for_1e-4": 3
})");
}

} // namespace
} // namespace stemware::pipeline
