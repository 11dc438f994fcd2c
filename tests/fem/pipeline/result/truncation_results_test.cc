// The results of `truncate` from rows made by hand, whose numbers are all different. The row with two
// harmonics has no balance.
#include "fem/pipeline/result/verb_results.h"
#include "tests/fem/pipeline/result/hand_made_studies.h"

#include <gtest/gtest.h>

namespace stemware::pipeline
{
namespace
{

using namespace test;

Results made_truncation()
{
  Numbers next;
  StudyAnswer answer;
  answer.contact.load = hand_made_load_report(next);
  answer.spin.rows = { hand_made_row(next, 1), missing_row(2), hand_made_row(next, 3) };
  answer.spin.rows.back().relative_change = 0;
  ring::TorqueEffects &effects = answer.spin.torque_effects = hand_made_effects();
  effects.rows.push_back(effects.rows.back());
  effects.rows.back().harmonics = 3;
  return truncation_results(answer);
}

TEST(TruncationByHand, SaysHowManyHarmonicsAreEnough)
{
  const Results results = made_truncation();
  EXPECT_EQ(results.key_figures["harmonics_for_1e-4"], 3);
  EXPECT_EQ(results.summary["truncation"][1]["message"], "No balance of moments was found");
}

} // namespace
} // namespace stemware::pipeline
