#include "fem/pipeline/study/table_file.h"
#include "tests/fem/pipeline/matchers.h"
#include "tests/fem/pipeline/refusal.h"

#include <gtest/gtest.h>

namespace stemware::pipeline
{
namespace
{

using Cells = std::vector<std::string>;

TEST(TableFile, DetectsTheSeparatorInTheFirstRow)
{
  for (const std::string text :
       { "a,b c\n1,2.5\n", "a;b c\r\n1;2,5\r\n", "a\tb c\n1\t2,5", "# by hand\n\n a , b c \n1 ,2.5\n" })
  {
    SCOPED_TRACE(text);
    const TextTable table = parse_table("cases.csv", text);
    ASSERT_EQ(table.rows.size(), 2u);
    EXPECT_EQ(table.rows[0].cells, (Cells{ "a", "b c" }));
    EXPECT_EQ(table.rows[1].cells[0], "1");
    EXPECT_EQ(table.with_point(table.rows[1].cells[1]), "2.5");
  }
  EXPECT_EQ(parse_table("", "t  v\n1 \t 2\n", true).rows[1].cells, (Cells{ "1", "2" }));
  EXPECT_EQ(parse_table("", "Motion/Force offset\n-0,05\n").rows[0].cells, Cells{ "Motion/Force offset" });
}

TEST(TableFile, ReadsTheSeparatorLineOfSpreadsheetsAndRefusesInvalidLines)
{
  for (const std::string text :
       { "sep=;\nt (s), of video;v\n1;2,5\n", "SEP=;\r\nt (s), of video;v\r\n1;2,5" })
  {
    const TextTable table = parse_table("", text);
    ASSERT_EQ(table.rows.size(), 2u);
    EXPECT_EQ(table.rows[0].cells, (Cells{ "t (s), of video", "v" }));
    EXPECT_EQ(table.rows[1].line, 3u);
    EXPECT_EQ(table.with_point(table.rows[1].cells[1]), "2.5");
  }
  EXPECT_EQ(parse_table("", "sep=,\na;b,c\n").rows[0].cells, (Cells{ "a;b", "c" }));
  EXPECT_TRUE(parse_table("", "sep=;").rows.empty());
  for (const std::string text : { "sep=|\na|b\n", "sep=\na,b\n", "sep=;;\n" })
    EXPECT_THROW(parse_table("a table", text), BadInput) << text;
}

TEST(TableFile, ReadsQuotesAccordingToRfc4180AndRefusesAnOpenQuote)
{
  const TextTable table =
    parse_table("", "name,\"a, \"\"quoted\"\" heading\"\n\"two\nlines\",\" x \"\n\"1,000\",;\n");
  ASSERT_EQ(table.rows.size(), 3u);
  EXPECT_EQ(table.rows[0].cells[1], "a, \"quoted\" heading");
  EXPECT_EQ(table.rows[1].cells, (Cells{ "two\nlines", "x" }));
  EXPECT_EQ(table.rows[1].line, 2u);
  EXPECT_EQ(table.rows[2].line, 4u);
  EXPECT_EQ(table.with_point(table.rows[2].cells[0]),
            "1,000"); // no decimal comma, because commas separate columns
  EXPECT_THAT(test::sentence_of([] { parse_table("cases.csv", "a,b\n1,\"2\n"); }),
              testing::HasSubstr("cases.csv, line 2: "));
}

TEST(TableFile, ReadsEmptyCellsAndDecimalCommasButNoThousandsSeparators)
{
  const TextTable table = parse_table("", "a;b;c\n;1,5;\n1.000,5;2,000,3;2\n");
  EXPECT_EQ(table.rows[1].cells, (Cells{ "", "1,5", "" }));
  EXPECT_EQ(table.with_point("1,5 mm"), "1.5 mm");
  EXPECT_EQ(table.with_point("1.000,5"), "1.000,5");
  EXPECT_EQ(table.with_point("2,000,3"), "2,000,3");
}

TEST(TableFile, SeparatesNameAndUnitOfAHeading)
{
  for (const auto &[cell, name, unit] :
       { std::tuple("Motion/Mass (g)", "Motion/Mass", "g"),
         std::tuple("Motion/Orbit speed [cm/s]", "Motion/Orbit speed", "cm/s"),
         std::tuple("Motion/Closure", "Motion/Closure", ""), std::tuple("", "", "") })
  {
    EXPECT_EQ(parse_heading(cell).first, name);
    EXPECT_EQ(parse_heading(cell).second, unit);
  }
}

} // namespace
} // namespace stemware::pipeline
