// The answer of a sweep from given case results.
#include "fem/pipeline/analysis/case_list.h"
#include "fem/pipeline/analysis/sweep_case.h"
#include "fem/pipeline/result/answers.h"

#include <gmock/gmock.h>

namespace stemware::test
{
namespace
{

TEST(SweepAnswer, NamesNoCaseIfAllCasesAreEqual)
{
  const pipeline::CaseList list = pipeline::cases_of_grid({ "Motion/Mass=0.2,0.3" });
  const auto solved = [](double spin, double torque)
  {
    pipeline::CaseResult result;
    result.values = { { "omega_terminal", spin }, { "harmonic_effect", 0 }, { "tau_at_rest", torque } };
    return result;
  };
  const pipeline::FinishedCases finished = { { 0, solved(-3, -0.2) }, { 1, solved(-3 * (1 + 4e-16), -0.3) } };
  const std::string answer = pipeline::sweep_answer(list, finished);
  EXPECT_THAT(answer, testing::Not(testing::HasSubstr("Motion/Mass")));
  EXPECT_THAT(answer, testing::Not(testing::HasSubstr("harmonics"))) << "the load has one";
  EXPECT_EQ(pipeline::range_of(list, finished, "omega_terminal")->max_case, "all 2 cases");
  EXPECT_EQ(pipeline::range_of(list, finished, "tau_at_rest")->max_case, "Motion/Mass = 0.2 kg");
}

TEST(SweepAnswer, LeavesFormalCasesOutOfTheRanges)
{
  const pipeline::CaseList list = pipeline::cases_of_grid({ "Motion/Mass=0.2,0.3,0.4" });
  const auto solved = [](double spin, bool is_formal)
  {
    pipeline::CaseResult result;
    result.values = { { "omega_terminal", spin } };
    result.is_formal = is_formal;
    return result;
  };
  const pipeline::FinishedCases finished = { { 0, solved(-3, false) },
                                             { 1, solved(-2, false) },
                                             { 2, solved(-9, true) } };
  const auto range = pipeline::range_of(list, finished, "omega_terminal");
  EXPECT_EQ(range->n, 2u);
  EXPECT_EQ(range->min, -3);
  EXPECT_EQ(finished.at(2).status(), "formal");
  EXPECT_EQ(finished.at(1).status(), "ok");
}

} // namespace
} // namespace stemware::test
