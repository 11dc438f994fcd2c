// The results of `truncate` from a study made by hand, whose numbers are all different. The row with two
// harmonics has no balance.
#include "fem/pipeline/document/spin_rows.h"
#include "fem/pipeline/report/truncation_results.h"
#include "tests/fem/pipeline/report/hand_made_studies.h"

#include <gtest/gtest.h>

namespace stemware::pipeline
{
namespace
{

using namespace test;

Results made_truncation()
{
  const TruncationByHand by_hand;
  return tabulate(by_hand.study, by_hand.load, by_hand.truncations, {});
}

TEST(TruncationByHand, Console)
{
  const Results results = made_truncation();
  EXPECT_EQ(console_text(results), R"(
The glass spins up to -1.7401 ± 0.0020 rad/s with all 3 harmonics of its load, to -1.37012 rad/s
with the first alone. The harmonics of the load beyond the first make the glass 0.212 % faster
(-0.0211 rad/s). From 3 harmonics on the spin is right to 1e-4.

In balance at every spin:

                                                                                      least load,
             last one  terminal spin   change  omega(t) off by  bound on torque  rest or terminal
  harmonics  over a_0        (rad/s)  of spin          (rad/s)            (N m)           (N/rad)
          1  1.43e+00     -1.3701235  +1.56 %         1.60e-03         1.57e-06              0.25
          2  0.00e+00              -        -                -                -                 0
          3  1.44e+00     -1.7401235  +1.93 %         1.97e-03         1.94e-06             -1.87

From the paper's model to this study's:

                          terminal spin  difference               band
  model, row by row             (rad/s)     (rad/s)  relative  (rad/s)
  the paper's model             -2.1301           -         -  2.2e-03
  moment balance                -2.1801       -0.05   +2.35 %  2.2e-03  formal
  grip                          -2.2301       -0.05   +2.29 %  2.3e-03
  where the foot touches        -2.2801       -0.05   +2.24 %  2.3e-03
  tilt                                -           -         -        -  The foot tips
  harmonics, all                -2.3801           -         -  2.0e-03

)");
}

TEST(TruncationByHand, OneWayIsSaid)
{
  TruncationByHand by_hand;
  by_hand.study.load.coupling = LoadCoupling::one_way;
  const Results results = tabulate(by_hand.study, by_hand.load, by_hand.truncations, {});
  const std::string console = console_text(results);
  EXPECT_NE(console.find("With the load of rest kept at every spin (one-way), the glass spins up to"),
            std::string::npos);
  EXPECT_NE(console.find("One-way, the load of rest cut off:"), std::string::npos);
  for (const ReportSection &section : results.report.sections)
    for (const Plot &plot : section.plots)
      EXPECT_EQ(plot.caption.find("One-way") == std::string::npos,
                plot.name == "load" || plot.name == "spectrum")
        << plot.name;
}

TEST(TruncationByHand, HarmonicsBelowTheirBandsAreHollow)
{
  const TruncationByHand by_hand;
  const auto caption_of_spectrum = [&](const ErrorBands &bands)
  {
    const Results results = tabulate(by_hand.study, by_hand.load, by_hand.truncations, bands);
    for (const ReportSection &section : results.report.sections)
      for (const Plot &plot : section.plots)
        if (plot.name == "spectrum")
          return plot.caption;
    return std::string();
  };
  ErrorBands bands;
  for (unsigned int n = 1; n <= n_harmonics_of_interest; ++n)
    for (const char *part : { "a", "b" })
      bands.push_back({ { part + std::to_string(n), "", "1" }, n == 1 ? 1e-9 : 1e9 });
  EXPECT_NE(caption_of_spectrum(bands).find("not resolved"), std::string::npos);
  EXPECT_EQ(caption_of_spectrum({}).find("not resolved"), std::string::npos);
}

TEST(TruncationByHand, DataFiles)
{
  const Results results = made_truncation();
  EXPECT_EQ(file_lines(results, "truncation.csv"),
            R"(harmonics (1): 1 | 2 | 3
amplitude of the highest one over a_0 at rest (1): 1.4311936264986744 | 0 | 1.4447718232442266
tau_z at rest (N m): 1.3101234567 | nan | 1.6801234567
terminal omega (rad/s): -1.3701234567 | nan | -1.7401234567
relative change of terminal omega to all harmonics (1): 0.015601234567 | nan | 0.019301234567
largest deviation of omega(t) from all harmonics (rad/s): 0.0016001234567 | nan | 0.0019701234567
deviation of omega(t) at the end (rad/s): 0.0016101234567 | nan | 0.0019801234566999997
a-priori bound on the change of tau_z at the terminal spin of all harmonics (N m): 1.5701234567e-6 | nan | 1.9401234567e-6
ring radius at the terminal spin (m): 1.4501234567 | nan | 1.8201234567
moment ratio at the terminal spin (1): 1.4901234567 | nan | 1.8601234567
minimum of the load at rest (N/rad): 0.25 | nan | -1.7201234567
minimum of the load at the terminal spin (N/rad): 0.25 | nan | -1.8701234567
share of N that would have to pull at rest (1): 0.013601234567 | nan | 0.017301234566999998
share of N that would have to pull at the terminal spin (1): 0.015101234566999999 | nan | 0.018801234567
1 if the load is negative somewhere (1): 0 | 0 | 1
tau_z at omega = -1.5 rad/s (N m): 1.5401234567 | nan | 1.9101234567
tau_z at omega = -3 rad/s (N m): 1.5501234567 | nan | 1.9201234567
)");
  EXPECT_EQ(file_lines(results, "spin_up.csv"), R"(time (s): 0 | 1.2201234567
omega, harmonics up to 1 (rad/s): 0 | -1.5901234567
omega, harmonics up to 3 (rad/s): 0 | -1.9601234567
)");
}

TEST(TruncationByHand, Report)
{
  const Results results = made_truncation();
  EXPECT_EQ(report_lines(results, "Fewer harmonics"), R"(The spin
harmonics: 1 | 2 | 3
amplitude of the last / a0: 1.431e+00 | 0.000e+00 | 1.445e+00
terminal spin (rad/s): -1.3701235 | – | -1.7401235
change of spin: +1.56 % | – | +1.93 %
ω(t) off by (rad/s): 1.60e-03 | – | 1.97e-03
at the end (rad/s): 1.61e-03 | – | 1.98e-03
bound on Δτz (N m): 1.57e-06 | – | 1.94e-06
Torque and load, the worse of rest and terminal spin
harmonics: 1 | 2 | 3
τz at rest (N m): 1.31012 | – | 1.68012
τz at -1.5 rad/s (N m): 1.54012 | – | 1.91012
τz at -3 rad/s (N m): 1.55012 | – | 1.92012
least λ, at rest or at the terminal spin (N/rad): 0.25 | 0 | -1.87
would have to pull (of N): – | – | 1.88 %
m at the terminal spin: 1.4901 | – | 1.8601
)");
  EXPECT_EQ(file_names(results), R"(summary.json: all numbers, for programs
parameters.prm: the study, to be run again
harmonics.dat: Fourier coefficients of the load at rest; Load/File reads them
rings.csv: the same ring by ring
truncation.csv: the answer by the number of harmonics
torque.csv: τ_z, T_x, T_y against the spin, of 1, 2, 3 and all harmonics
spin_up.csv: the spin against time by the number of harmonics
timings.json: how long it took
)");
}

TEST(TruncationByHand, Budget)
{
  const TruncationByHand by_hand;
  const Results results = made_truncation();
  EXPECT_EQ(report_lines(results, "From the paper's model to this study's"),
            R"(Terminal spin in models of increasing detail
step: 1 | 2 | 2a | 3 | 3a | 4 | 5
what is added: the paper&#39;s model | moment balance | grip | where the foot touches | tilt | harmonics, n ≤ 2 | harmonics, all
terminal spin (rad/s): -2.1301 | -2.1801 | -2.2301 | -2.2801 | – | -2.3301 | -2.3801
difference (rad/s): – | -0.05 | -0.05 | -0.05 | – | – | -0.05
relative: – | +2.35 % | +2.29 % | +2.24 % | – | – | +2.15 %
band (rad/s): 2.2e-03 | 2.2e-03 | 2.3e-03 | 2.3e-03 | – | 2.4e-03 | 2.0e-03
:  | formal |  |  | The foot tips |  | 
)");
  EXPECT_EQ(json_lines(results.findings.summary["budget"]),
            json_lines(budget_summary(by_hand.study, by_hand.truncations.budget)));
}

TEST(TruncationByHand, Summary)
{
  const Results results = made_truncation();
  EXPECT_EQ(json_lines(results.findings.summary["truncation"]), R"(harmonics: 1 | 2 | 3
amplitude: 1.4311936264986744 | 0.0 | 1.4447718232442266
tau_at_rest: 1.3101234567 | null | 1.6801234567
torque: [1.5401234567,1.5501234567] | [null,null] | [1.9101234567,1.9201234567]
omega_terminal: -1.3701234567 | null | -1.7401234567
relative_change: 0.015601234567 | null | 0.019301234567
spin_up_deviation: 0.0016001234567 | null | 0.0019701234567
spin_up_deviation_at_end: 0.0016101234567 | null | 0.0019801234566999997
bound: 1.5701234567e-06 | null | 1.9401234567e-06
pulls: false | false | true
load_minimum: 0.25 | null | -1.7201234567
pulling_share: 0.013601234567 | null | 0.017301234566999998
load_minimum_at_terminal: 0.25 | null | -1.8701234567
pulling_share_at_terminal: 0.015101234566999999 | null | 0.018801234567
load_at_terminal: {"a":[1.4001234567,1.4101234567,1.4301234567],"b":[0.0,1.4201234567,1.4401234567],"ring_radius":1.4501234567,"moment_ratio":1.4901234567} | null | {"a":[1.7701234567,1.7801234567,1.8001234567],"b":[0.0,1.7901234567,1.8101234567],"ring_radius":1.8201234567,"moment_ratio":1.8601234567}
trouble: null | "No balance of moments was found" | null
)");
  EXPECT_EQ(results.findings.summary["harmonic_effect"].dump(),
            R"({"absolute":-0.021101234567,"relative":0.0021201234567})");
  EXPECT_EQ(results.findings.key_figures.dump(1), R"({
 "omega_terminal": -1.7401234567,
 "omega_terminal_band": 0.0019001234567,
 "harmonic_effect": -0.021101234567,
 "harmonic_effect_relative": 0.0021201234567,
 "harmonics_for_1e-4": 3
})");
}

} // namespace
} // namespace stemware::pipeline
