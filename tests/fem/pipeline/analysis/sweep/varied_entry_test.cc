// What --vary takes: ranges, ranges by factors, lists; one sentence for everything else.
#include "fem/pipeline/analysis/sweep/swept_entry.h"
#include "fem/pipeline/support/failures.h"

#include <gtest/gtest.h>

namespace stemware::pipeline
{
namespace
{

using Values = std::vector<std::string>;

TEST(VariedEntry, RangeInEqualSteps)
{
  const SweptEntry entry = parse_varied_entry("Load/Moment ratio=0.1:1.9:7");
  EXPECT_EQ(entry.path, "Load/Moment ratio");
  EXPECT_EQ(entry.values, (Values{ "0.1", "0.4", "0.7", "1", "1.3", "1.6", "1.9" }));
  EXPECT_EQ(parse_varied_entry(" Motion/Force offset = 0.05 : -0.05 : 3 ").values,
            (Values{ "0.05", "0", "-0.05" }));
}

TEST(VariedEntry, RangeInEqualStepsPassesThroughZero)
{
  // -0.08 + 32 * 0.0025 is 1.4e-17 in doubles, -0.3 + 3 * 0.1 is 5.6e-17.
  const Values hand = parse_varied_entry("Motion/Force offset=-0.08:0.02:41").values;
  EXPECT_EQ(hand[31], "-0.0025");
  EXPECT_EQ(hand[32], "0");
  EXPECT_EQ(hand[33], "0.0025");
  EXPECT_EQ(parse_varied_entry("A/B=-0.3:0.6:10").values,
            (Values{ "-0.3", "-0.2", "-0.1", "0", "0.1", "0.2", "0.3", "0.4", "0.5", "0.6" }));
  EXPECT_EQ(parse_varied_entry("A/B=0:0:2").values, (Values{ "0", "0" }));
  EXPECT_EQ(parse_varied_entry("A/B=1e-20:3e-20:3").values, (Values{ "1e-20", "2e-20", "3e-20" }));
}

TEST(VariedEntry, RangeByEqualFactors)
{
  EXPECT_EQ(parse_varied_entry("Table/Foundation modulus=1e8:1e12:5:log").values,
            (Values{ "1e8", "1e9", "1e10", "1e11", "1e12" }));
  EXPECT_EQ(parse_varied_entry("A/B=1:2:3:log").values, (Values{ "1", "1.4142135623731", "2" }));
  EXPECT_EQ(parse_varied_entry("A/B=4:1:3:log").values, (Values{ "4", "2", "1" }));
}

TEST(VariedEntry, EndsKeepAllTheirDigits)
{
  const Values values = parse_varied_entry("A/B=0.12345678901234567:0.98765432109876543:2").values;
  EXPECT_EQ(std::stod(values.front()), 0.12345678901234567);
  EXPECT_EQ(std::stod(values.back()), 0.98765432109876543);
}

TEST(VariedEntry, CountsStayWholeNumbers)
{
  EXPECT_EQ(parse_varied_entry("Contact/Harmonics=4:16:4").values, (Values{ "4", "8", "12", "16" }));
}

TEST(VariedEntry, ListsKeepTheirWords)
{
  EXPECT_EQ(parse_varied_entry("Motion/Closure=paper, hand,full").values,
            (Values{ "paper", "hand", "full" }));
  EXPECT_EQ(parse_varied_entry("Load/Moment ratio=0.50").values, (Values{ "0.50" }));
  EXPECT_EQ(parse_varied_entry("Load/File=a=b.dat,c.dat").values, (Values{ "a=b.dat", "c.dat" }));
}

class BadRange : public testing::TestWithParam<std::pair<const char *, const char *>>
{
};

TEST_P(BadRange, IsRefusedInOneSentence)
{
  const auto [text, expected] = GetParam();
  try
  {
    parse_varied_entry(text);
    FAIL() << text << " was taken";
  }
  catch (const BadInput &refusal)
  {
    const std::string sentence = refusal.what();
    EXPECT_NE(sentence.find(expected), std::string::npos) << sentence;
    EXPECT_NE(sentence.find("--vary \"" + std::string(text) + "\""), std::string::npos) << sentence;
    EXPECT_EQ(sentence.find('\n'), std::string::npos);
    EXPECT_EQ(sentence.back(), '.');
  }
}

INSTANTIATE_TEST_SUITE_P(All, BadRange,
                         testing::Values(std::pair("Load/Moment ratio", "is not of the form"),
                                         std::pair("Moment ratio=1:2:3", "is not of the form"),
                                         std::pair("a=b/c", "is not of the form"),
                                         std::pair("A/B=", "names no values"),
                                         std::pair("A/B=1:2", "is not a range"),
                                         std::pair("A/B=1:2:3:4", "is not a range"),
                                         std::pair("A/B=1:2:3:log:5", "is not a range"),
                                         std::pair("A/B=one:2:3", "from one number to another"),
                                         std::pair("A/B=1:1e999:3", "from one number to another"),
                                         std::pair("A/B=1:2:1", "number of values from 2"),
                                         std::pair("A/B=1:2:2.5", "number of values from 2"),
                                         std::pair("A/B=1:2:-3", "number of values from 2"),
                                         std::pair("A/B=1:2:999999999", "number of values from 2"),
                                         std::pair("A/B=0:2:3:log", "greater than 0"),
                                         std::pair("A/B=-2:-1:3:log", "greater than 0")));

} // namespace
} // namespace stemware::pipeline
