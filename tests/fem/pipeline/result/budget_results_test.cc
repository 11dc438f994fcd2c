// The budget of effects from one made by hand: its tables in every form. The second row is formal, that with
// tilt has no balance.
#include "fem/pipeline/result/verb_results.h"
#include "tests/fem/pipeline/result/hand_made_studies.h"

#include <gtest/gtest.h>

namespace stemware::pipeline
{
namespace
{

using namespace test;

constexpr double rounding = 1e-9;

Budget made_budget()
{
  Numbers next;
  return hand_made_budget(next);
}

TEST(BudgetByHand, Summary)
{
  EXPECT_EQ(json_lines(chain_fields().json(made_budget().rows)),
            R"(step: "1" | "2" | "2a" | "3" | "3a" | "4" | "5"
name: "paper" | "moment balance" | "grip" | "where the foot touches" | "tilt" | "harmonics" | "harmonics"
harmonics: 1 | 1 | 1 | 1 | 1 | 2 | "all"
omega_terminal: -1.0101234567 | -1.0601234567 | -1.1101234567 | -1.1601234567 | null | -1.2101234567 | -1.2601234567
difference: null | -0.050000000000000044 | -0.050000000000000044 | -0.050000000000000044 | null | null | -0.04999999999999982
band: 0.0010201234567 | 0.0010701234567 | 0.0011201234567 | 0.0011701234567 | null | 0.0012201234567000001 | 0.0012701234567
torques: [1.0301234567,1.0401234567,1.0501234567] | [1.0801234567,1.0901234567,1.1001234567] | [1.1301234567,1.1401234567,1.1501234567] | [1.1801234567,1.1901234567,1.2001234567] | [null,null,null] | [1.2301234567,1.2401234567,1.2501234567] | [1.2801234567,1.2901234567,1.3001234567]
state: "full contact" | "formal" | "full contact" | "full contact" | "tips" | "full contact" | "full contact"
reason: null | null | null | null | "The foot tips" | null | null
)");
  EXPECT_EQ(json_lines(without_fields().json(made_budget().without)),
            R"(name: "tilt" | "elasticity of the foot" | "compliance of the interface"
omega_terminal: -1.3101234567 | -1.3301234567 | null
difference: 0.013201234567 | -0.013401234567 | null
reason: null | null | "not defined"
)");
  EXPECT_EQ(harmonic_effect_fields().json(made_budget().harmonics).dump(),
            R"({"absolute":-0.013501234567,"relative":0.0013601234567})");
  EXPECT_EQ(harmonic_effect_fields().json(HarmonicEffect()).dump(), R"({"absolute":null,"relative":null})");
}

TEST(BudgetByHand, HarmonicsThatChangeNothingAreNotShown)
{
  Budget budget = made_budget();
  const std::size_t n_rows = budget.rows.size();
  budget.rows[5].difference = 1e-13;
  EXPECT_EQ(shown_chain(budget.rows, rounding).size(), n_rows - 1);
  // The row below is compared with the row above it that is shown.
  budget.rows[4].omega_terminal = -1.2;
  const BudgetRow last = shown_chain(budget.rows, rounding).back();
  EXPECT_DOUBLE_EQ(last.difference.value(), *budget.rows[6].omega_terminal - *budget.rows[4].omega_terminal);
  budget.rows.back().difference = 0; // the study itself stays
  EXPECT_EQ(shown_chain(budget.rows, rounding).size(), n_rows - 1);
}

TEST(BudgetByHand, NothingIsRelatedToAGlassThatDoesNotSpin)
{
  Budget budget = made_budget();
  budget.rows[0].omega_terminal = 0;
  budget.rows[1].difference = budget.rows[1].omega_terminal;
  const Table table = chain_fields().table(budget.rows, Face::page);
  const auto column =
    std::find_if(table.columns.begin(), table.columns.end(),
                 [](const Column &one) { return one.quantity.key == "relative_difference"; });
  ASSERT_NE(column, table.columns.end());
  EXPECT_TRUE(column->cells[0].is_null());
  EXPECT_TRUE(column->cells[1].is_null());
  EXPECT_FALSE(column->cells[2].is_null());
}

TEST(BudgetByHand, NamedStepsCountAllHarmonicsFromTheFirst)
{
  const std::vector<BudgetRow> rows = named_steps({ { { 1 }, "paper", 1, -3. },
                                                    { { 3 }, "where the foot touches", 1, -3.4, -0.4 },
                                                    { { 4 }, "harmonics", 2, -3.2, 0.2 },
                                                    { { 5 }, "harmonics", 3, {}, {} },
                                                    { { 6 }, "harmonics", {}, -3.25, {} } });
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(title_of(rows[2]), "harmonics, all");
  EXPECT_NEAR(rows[2].difference.value(), 0.15, 1e-15); // -3.25 + 3.4
  EXPECT_FALSE(named_steps({ { { 1 }, "paper", 1, -3. },
                             { { 3 }, "tilt", 1 },
                             { { 4 }, "harmonics", 2, -3.2 },
                             { { 5 }, "harmonics", {}, -3.25, -0.05 } })
                 .back()
                 .difference);
}

} // namespace
} // namespace stemware::pipeline
