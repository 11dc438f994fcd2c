#include "fem/pipeline/base/numbers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace stemware::pipeline
{
namespace
{

TEST(Numbers, TextIsTheShortestThatParsesToTheSameNumber)
{
  EXPECT_EQ(to_text(0.03), "0.03");
  EXPECT_EQ(to_text(70e9), "7e10");
  EXPECT_EQ(to_text(3e-4), "3e-4");
  EXPECT_EQ(to_text(-1.5707963267948966), "-1.5707963267948966");
  EXPECT_EQ(to_text(0), "0");
  for (const double value :
       { 0.1, 1. / 3, 6.02214076e23, -2.2250738585072014e-308, 5e-324, std::numeric_limits<double>::max() })
    EXPECT_EQ(parse_number(to_text(value)), value) << to_text(value);
}

TEST(Numbers, ShortTextHasSixSignificantDigits)
{
  EXPECT_EQ(to_short_text(9.080892337936447), "9.08089");
  EXPECT_EQ(to_short_text(1.23456789e-7), "1.23457e-7");
}

TEST(Numbers, DistinctNumbersGetDistinctTexts)
{
  using Texts = std::pair<std::string, std::string>;
  EXPECT_EQ(distinct_texts(2.5, 2), Texts("2.5", "2"));
  EXPECT_EQ(distinct_texts(2.0000004, 2), Texts("2.0000004", "2"));
  EXPECT_EQ(distinct_texts(2, 2), Texts("2", "2"));
  EXPECT_EQ(distinct_texts(8.04e9, 8e9, 2), Texts("8.04e9", "8e9"));
  const auto [next, one] = distinct_texts(std::nextafter(1., 2), 1);
  EXPECT_EQ(std::stod(next), std::nextafter(1., 2));
  EXPECT_EQ(one, "1");
}

TEST(Numbers, RoundsToSignificantDigits)
{
  EXPECT_EQ(rounded(0.1 + 0.2, 15), 0.3);
  EXPECT_EQ(rounded(1e10 / 3, 12), 3333333333.33);
  EXPECT_EQ(rounded(-2e300 / 3, 3), -6.67e299);
  EXPECT_EQ(rounded(0, 5), 0);
}

TEST(Numbers, ParsesOnlyFiniteDecimalNumbers)
{
  EXPECT_EQ(parse_number("0.0312345678901234"), 0.0312345678901234);
  EXPECT_EQ(parse_number(" +7e10 "), 7e10);
  for (const char *text :
       { "", " ", "nan", "inf", "-inf", "1e400", "0x10", "1 kg", "1,5", "+-1", "--1", "1e" })
    EXPECT_FALSE(parse_number(text)) << text;
}

TEST(Numbers, ParsesOnlyUnsignedIntegersAsCounts)
{
  EXPECT_EQ(parse_count("48"), 48u);
  for (const char *text : { "", "-8", "4.0", "1e2", "12a", "99999999999" })
    EXPECT_FALSE(parse_count(text)) << text;
}

} // namespace
} // namespace stemware::pipeline
