// The results of `truncate` from rows made by hand, whose numbers are all different. The row with two
// harmonics has no balance.
#include "fem/pipeline/result/truncation_results.h"
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
  Study study;
  const LoadReport load = hand_made_load_report(next);
  std::vector<ring::Answer> rows = { hand_made_row(next, 1), missing_row(2), hand_made_row(next, 3) };
  rows.back().relative_change = 0;
  ring::TorqueEffects effects = hand_made_effects();
  effects.rows.push_back(effects.rows.back());
  effects.rows.back().harmonics = 3;
  return make_truncation_document(study, load, rows, effects);
}

TEST(TruncationByHand, SaysHowManyHarmonicsAreEnough)
{
  const Results results = made_truncation();
  EXPECT_EQ(results.findings.key_figures["harmonics_for_1e-4"], 3);
  EXPECT_EQ(results.findings.summary["truncation"][1]["message"], "No balance of moments was found");
}

} // namespace
} // namespace stemware::pipeline
