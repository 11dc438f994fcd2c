// The results of `truncate` from rows made by hand, whose numbers are all different. The row with two
// harmonics has no balance.
#include "fem/pipeline/report/truncation_results.h"
#include "tests/fem/pipeline/report/hand_made_studies.h"

#include <gtest/gtest.h>

namespace stemware::pipeline
{
namespace
{

using namespace test;

Results made_truncation(LoadCoupling coupling = LoadCoupling::two_way)
{
  Numbers next;
  Study study;
  study.load.coupling = coupling;
  const LoadReport load = hand_made_load_report(next);
  std::vector<ring::Answer> rows = { hand_made_row(next, 1), missing_row(2), hand_made_row(next, 3) };
  rows.back().relative_change = 0;
  return tabulate_truncations(study, load, rows);
}

TEST(TruncationByHand, SaysHowManyHarmonicsAreEnough)
{
  const Results results = made_truncation();
  EXPECT_EQ(results.findings.key_figures["harmonics_for_1e-4"], 3);
  EXPECT_EQ(results.findings.summary["truncation"][1]["message"], "No balance of moments was found");
  const std::string console = console_text(results);
  EXPECT_NE(console.find("From 3 harmonics on"), std::string::npos) << console;
  EXPECT_NE(console.find("In balance at every spin:"), std::string::npos) << console;
}

TEST(TruncationByHand, OneWayIsSaid)
{
  const std::string console = console_text(made_truncation(LoadCoupling::one_way));
  EXPECT_NE(console.find("one-way"), std::string::npos) << console;
  EXPECT_NE(console.find("One-way, the load of rest cut off:"), std::string::npos) << console;
}

} // namespace
} // namespace stemware::pipeline
