#include "fem/pipeline/result/verb_results.h"

#include <gmock/gmock.h>

namespace stemware::test
{
namespace
{

TEST(SweepAnswer, NamesCasesForDifferentTorquesButNotForEqualSpins)
{
  const pipeline::CaseList list = pipeline::cases_of_grid({ "Motion/Mass=0.2,0.3" });
  const auto solved = [](double spin, double torque)
  {
    pipeline::CaseResult result;
    result.values = { { "omega_terminal", spin }, { "harmonic_effect", 0 }, { "tau_at_rest", torque } };
    return result;
  };
  const pipeline::FinishedCases finished = { { 0, solved(-3, -0.2) }, { 1, solved(-3 * (1 + 4e-16), -0.3) } };
  const pipeline::Results results = pipeline::sweep_results(list, finished);
  const std::string answer = results.words["answer"], ranges = results.tables["ranges"].dump();
  EXPECT_THAT(answer, testing::Not(testing::HasSubstr("Motion/Mass")));
  EXPECT_THAT(answer, testing::Not(testing::HasSubstr("harmonics"))) << "the load has one";
  EXPECT_THAT(ranges, testing::HasSubstr("all 2 cases"));
  EXPECT_THAT(ranges, testing::HasSubstr("Motion/Mass = 0.2 kg"));
}

TEST(SweepAnswer, ExcludesTensileCasesFromTheRanges)
{
  const pipeline::CaseList list = pipeline::cases_of_grid({ "Motion/Mass=0.2,0.3,0.4" });
  const auto solved = [](double spin, const std::string &status) {
    return pipeline::CaseResult{ "", status, "", { { "omega_terminal", spin } } };
  };
  const pipeline::Results results = pipeline::sweep_results(
    list, { { 0, solved(-3, "ok") }, { 1, solved(-2, "ok") }, { 2, solved(-9, "formal") } });
  EXPECT_EQ(results.key_figures["omega_terminal"].dump(), "[-3.0,-2.0]");
  EXPECT_THAT(results.words["answer"].get<std::string>(), testing::HasSubstr("In 1 of 3 cases the load"));
}

} // namespace
} // namespace stemware::test
