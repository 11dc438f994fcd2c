#include "fem/pipeline/analysis/sweep_case.h"
#include "fem/pipeline/base/failures.h"
#include "tests/fem/pipeline/matchers.h"
#include "tests/fem/pipeline/program_runner.h"
#include "tests/fem/pipeline/refusal.h"

#include <gtest/gtest.h>

#include <functional>

namespace stemware::pipeline
{
namespace
{

using Values = std::vector<std::string>;

Values values_of(const std::string &varied)
{
  return cases_of_grid({ varied }).entries.at(0).values;
}

TEST(CaseList, ValuesOfARangeAreShortDecimalsBetweenTheExactEnds)
{
  EXPECT_EQ(values_of("Load/Moment ratio=0.1:1.9:7"),
            (Values{ "0.1", "0.4", "0.7", "1", "1.3", "1.6", "1.9" }));
  EXPECT_EQ(values_of(" Motion/Force offset = 5 : -5 cm : 3 "), (Values{ "0.05", "0", "-0.05" }));
  // In double precision, -0.3 + 3 * 0.1 is 5.6e-17, not 0.
  EXPECT_EQ(values_of("Motion/Force offset=-0.3:0.6:10"),
            (Values{ "-0.3", "-0.2", "-0.1", "0", "0.1", "0.2", "0.3", "0.4", "0.5", "0.6" }));
  EXPECT_EQ(values_of("Table/Foundation modulus=1e8:1e12:5:log"),
            (Values{ "1e8", "1e9", "1e10", "1e11", "1e12" }));
  EXPECT_EQ(values_of("Contact/Harmonics=4:16:4"), (Values{ "4", "8", "12", "16" }));
  const Values ends = values_of("Motion/Mass=0.12345678901234567:0.98765432109876543:2");
  EXPECT_EQ(std::stod(ends.front()), 0.12345678901234567);
  EXPECT_EQ(std::stod(ends.back()), 0.98765432109876543);
}

TEST(CaseList, AGridContainsEveryCombinationOfItsValuesAndKeepsTheBaseStudy)
{
  CaseList list = cases_of_grid({ "Motion/Closure=paper, full", "Motion/Mass=200,300 g" });
  EXPECT_TRUE(list.is_grid());
  EXPECT_EQ(list.cases, (std::vector<Values>{
                          { "paper", "0.2" }, { "paper", "0.3" }, { "full", "0.2" }, { "full", "0.3" } }));
  EXPECT_EQ(list.entries[0].unit, "");
  EXPECT_EQ(list.entries[1].unit, "kg");
  list.base.motion.orbit.friction_coefficient = 0.7;
  const Study study = list.study_of(1);
  EXPECT_EQ(study.motion.orbit.mass, 0.3);
  EXPECT_EQ(study.motion.closure, ring::Closure::paper);
  EXPECT_EQ(study.motion.orbit.friction_coefficient, 0.7);
}

TEST(CaseList, ReadsATableWithUnitsAndDecimalCommas)
{
  const test::ScratchFolder scratch;
  for (const std::string text : { "Motion/Mass (g),Glass/Rim waviness,Motion/Closure\n302.5,\"3: 2e-6, 5: "
                                  "1e-6\",full\n0.29 kg,,paper\n",
                                  "\xEF\xBB\xBFMotion/Mass [g];Glass/Rim waviness;Motion/Closure\r\n302,5;3: "
                                  "2 um, 5: 1 um;full\r\n290;;paper\r\n" })
  {
    SCOPED_TRACE(text);
    const CaseList list = cases_from_file(scratch.write("cases.csv", text));
    EXPECT_FALSE(list.is_grid());
    ASSERT_EQ(list.cases.size(), 2u);
    EXPECT_EQ(list.cases[0], (Values{ "0.3025", "3: 2e-6, 5: 1e-6", "full" }));
    EXPECT_EQ(list.cases[1], (Values{ "0.29", "", "paper" }));
    EXPECT_EQ(list.entries[0].path, "Motion/Mass");
  }
}

TEST(CaseList, InconsistentCasesFailIndividually)
{
  const CaseList list = cases_of_grid({ "Contact/Load harmonics=8,200" });
  EXPECT_EQ(list.study_of(0).contact.load_harmonics, 8u);
  EXPECT_THROW(list.study_of(1), BadInput);
}

void expect_refused(const std::function<void()> &action, const std::string &words)
{
  const std::string sentence = test::sentence_of(action);
  EXPECT_THAT(sentence, testing::AllOf(testing::HasSubstr(words), testing::Not(testing::HasSubstr("\n"))));
  EXPECT_THAT(sentence.back(), testing::AnyOf('.', ')')) << sentence;
}

TEST(CaseList, NamesTheErrorOfABadGrid)
{
  for (const auto &[varied, words] : std::vector<std::pair<Values, std::string>>{
         { { "Motion/Mass" }, "is not of the form" },
         { { "Mass=1:2:3" }, "is not of the form" },
         { { "Motion/Mas=1,2" }, "did you mean Motion/Mass?" },
         { { "Motion/Mass=" }, "names no values" },
         { { "Motion/Mass=1:2" }, "is not a range" },
         { { "Motion/Mass=1:2:3:4" }, "is not a range" },
         { { "Motion/Mass=1:2:1" }, "whole number of values" },
         { { "Motion/Mass=1:2:999999999" }, "whole number of values" },
         { { "Motion/Mass=0:2:3:log" }, "greater than 0" },
         { { "Motion/Mass=200:400 mm:3" }, "is a length, but a mass is needed" },
         { { "Motion/Mass=200 g:400:3" }, "unit behind its first number only" },
         { { "Motion/Mass=0.2,heavy" }, "Motion/Mass = heavy is not allowed" },
         { { "Motion/Mass=0.2,0.20" }, "stands twice" },
         { { "Motion/Mass=1,2", "Motion/Mass=3,4" }, "varies Motion/Mass twice" },
         { { "Motion/Mass=1,2", "Motion/Gravity=9,10", "Motion/Orbit radius=1,2" }, "--cases" },
         { { "Motion/Mass=1:2:2000", "Motion/Gravity=1:2:2000" }, "4000000 cases" },
         { { "Glass/Profile file=nothing.csv,other.csv" }, "does not exist" } })
    expect_refused([&, &varied = varied] { cases_of_grid(varied); }, words);
}

TEST(CaseList, NamesTheErrorOfABadTable)
{
  const test::ScratchFolder scratch;
  for (const auto &[text, words] : std::vector<std::pair<std::string, std::string>>{
         { "", "has no cases" },
         { "Motion/Mass\n", "has no cases" },
         { "Motion/Mas\n1\n", "line 1, column 1: there is no" },
         { "Motion/Mass (mm)\n1\n", "line 1, column 1: Motion/Mass (mm) is a length" },
         { "Motion/Closure (g)\npaper\n", "line 1, column 1: Motion/Closure (g) is words" },
         { "Motion/Mass,Motion/Mass\n1,2\n", "varies Motion/Mass twice" },
         { "Motion/Mass,Motion/Closure\n0.3,paper\n\n0.3\n", "line 4: the row has 1 cells" },
         { "Motion/Mass,Motion/Closure\n0.3,paper\n0.3,none\n",
           "line 3, column 2: Motion/Closure = none is not" },
         { "Motion/Mass,Motion/Closure\n,paper\n", "line 2, column 1: Motion/Mass = (nothing) is not" },
         { "Motion/Mass,Motion/Closure\n0.3 mm,paper\n",
           "line 2, column 1: Motion/Mass = 0.3 mm is a length" } })
    expect_refused([&, &text = text] { cases_from_file(scratch.write("cases.csv", text)); }, words);
  expect_refused([&] { cases_from_file(scratch / "none.csv"); }, "does not exist");
}

} // namespace
} // namespace stemware::pipeline
