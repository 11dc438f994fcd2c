// The results of `run` from a study made by hand, whose numbers are all different: each heading, unit and
// digit of every table stands beside the values that belong there.
#include "fem/pipeline/result/verb_results.h"
#include "tests/fem/pipeline/result/hand_made_studies.h"

#include <gtest/gtest.h>

namespace stemware::pipeline
{
namespace
{

using namespace test;

TEST(RunByHand, Truncations)
{
  const Results results = made_run();
  EXPECT_EQ(file_lines(results, "truncation.csv"),
            R"(harmonics (1): 1 | 2
tau_z at rest (N m): 1.4601234567 | 1.8301234567
change of tau_z at half the terminal spin (N m): 0 | 0.25
change of tau_z at half the terminal spin over |tau_z| at rest (1): 0 | 0.125
change of tau_z at the terminal spin (N m): 0 | 0.375
change of tau_z at the terminal spin over |tau_z| at rest (1): 0 | 0.1875
largest change of tau_z from rest to the terminal spin (N m): 0 | 0.5
omega of the largest change (rad/s): 0 | -3
tau_z of all harmonics minus tau_z(n) at half the terminal spin (N m): 0.25 | 0
a-priori bound on that rest at half the terminal spin (N m): 0.3125 | 0
tau_z of all harmonics minus tau_z(n) at the terminal spin (N m): 0.375 | 0
a-priori bound on the rest of tau_z at the terminal spin (N m): 0.4375 | 0
terminal omega (rad/s): -1.5201234567 | -1.8901234567
relative change of terminal omega to all harmonics, nan where that is 0 (1): 0.017101234567000002 | 0.020801234567
minimum of the load at rest (N/rad): -1.5001234567 | -1.8701234567
)");
}

TEST(RunByHand, EffectOnTheTorque)
{
  const Results results = made_run();
  EXPECT_EQ(results.summary["torque_effect"].dump(),
            R"({"half":0.25,"half_relative":0.125,"terminal":0.375,"terminal_relative":0.1875,"largest":0.5,)"
            R"("largest_relative":0.25,"largest_at":-3.0})");
  EXPECT_EQ(results.summary["truncation"][0]["torque_rest"].dump(), R"({"half":0.25,"terminal":0.375})");
}

TEST(RunByHand, OneRing)
{
  RunByHand by_hand;
  by_hand.bands.clear();
  Numbers next;
  by_hand.spin.one_ring = hand_made_row(next, 2);
  const Results results = run_results(by_hand);
  EXPECT_EQ(
    results.summary["one_ring"].dump(),
    R"({"tau_at_rest":1.0701234567,"omega_terminal":-1.1301234567,"relative_change":0.013201234567})");
  EXPECT_EQ(results.summary["truncation"].size(), 2u);
  EXPECT_TRUE(made_run().summary["one_ring"].is_null());
}

TEST(RunByHand, NoLiftOffIsDecidedByTheLoadItself)
{
  RunByHand by_hand;
  const auto decided = [&] { return run_results(by_hand).summary["ring"]["no_lift_off"].get<bool>(); };
  for (LoadReport *load : { &by_hand.contact.load, &by_hand.contact.load_at_end })
  {
    load->contact_fraction = 1;
    load->minimum = 0.1;
    load->moment_ratio = 0.9;
  }
  EXPECT_TRUE(decided());
  by_hand.contact.load.minimum = -1e-3; // it pulls, whatever its moment ratio
  EXPECT_FALSE(decided());
  by_hand.contact.load.minimum = 0;
  EXPECT_TRUE(decided());
  by_hand.contact.load_at_end.contact_fraction = 0.99;
  EXPECT_FALSE(decided());
}

TEST(RunByHand, Contact)
{
  const Results results = made_run();
  EXPECT_EQ(file_lines(results, "contact_history.csv"), R"(step (1): 1 | 2
loaded places (1): 201 | 204
changed places (1): 202 | 205
relative imbalance of forces (1): 1.3001234567 | 1.3201234567
share of the step taken (1): 1.3101234567 | 1.3301234567
iterations of the linear solver (1): 203 | 206
)");
  EXPECT_EQ(file_text(results, "footprint.csv"), "r (m),theta (rad),pressure (Pa)\r\n"
                                                 "1.3401234567,0.25,1.3501234567\r\n"
                                                 "1.3601234567,0.25,1.3701234567\r\n");
}

TEST(RunByHand, RingOfTheSummary)
{
  // Closed form of the mean over the phases, as the torque beside it: mu pi r b_1 = 0.3
  // pi 1.8201234567 1.7901234567, not mu times the moment 1.1401234567 at the phase of t = 0.
  const Results results = made_run();
  EXPECT_EQ(results.summary["ring"].dump(1), R"({
 "omega_terminal": -1.8901234567,
 "tau_at_rest": 1.8301234567,
 "lean_torque_at_rest": 0.0,
 "fall": null,
 "tau_at_terminal": 1.9801234567,
 "lean_torque_at_terminal": 0.0,
 "grip_torque_at_terminal": 0.0,
 "time_constant": 1.9101234567,
 "force_at_terminal": [
  1.9901234567,
  2.0001234567
 ],
 "moment_ratio_at_terminal": 2.0101234567,
 "tau_closed_form": 3.0708242206909597,
 "standing": "lift-off",
 "terminal_spins": [],
 "driven": null,
 "no_lift_off": false,
 "tilt_at_terminal": [
  2.7301234567,
  2.7401234567
 ],
 "phase_dependent": true,
 "spin_ripple": 2.3201234567
})");
}

TEST(RunByHand, ErrorBands)
{
  const Results results = made_run();
  EXPECT_EQ(
    results.summary["error_bands"]["omega_terminal"].dump(),
    R"({"value":2.4901234567,"band":0.0025001234567,"parts":{"mesh":0.00031901234567,"degree":null,)"
    R"("harmonics":null,"lines":null,"interface":null,"load_harmonics":null,"rings":0.00032001234567,)"
    R"("interpolation":null,"solver":null},"unit":"rad/s"})");
}

TEST(RunByHand, Rings)
{
  const Results results = made_run();
  EXPECT_EQ(file_lines(results, "rings.csv"),
            R"(ring j (1): 1 | 1 | 1 | 2 | 2 | 2
r_j (m): 1.0101234567 | 1.0101234567 | 1.0101234567 | 1.0701234567 | 1.0701234567 | 1.0701234567
n (1): 0 | 1 | 2 | 0 | 1 | 2
a_n (N/rad): 1.0201234567 | 1.0301234567 | 1.0501234567 | 1.0801234567 | 1.0901234567 | 1.1101234567
b_n (N/rad): 0 | 1.0401234567 | 1.0601234567 | 0 | 1.1001234567 | 1.1201234567
)");
}

TEST(RunByHand, WithoutAContactThereIsNothingAboutOne)
{
  RunByHand by_hand;
  by_hand.contact.foot.reset();
  by_hand.contact.coupling.reset();
  const Results without = run_results(by_hand);
  for (const char *key : { "contact", "coupling" })
    EXPECT_TRUE(without.summary[key].is_null()) << key;
  EXPECT_THROW(file_text(without, "contact_history.csv"), std::out_of_range);
  EXPECT_FALSE(without.tables.contains("contact"));
}

} // namespace
} // namespace stemware::pipeline
