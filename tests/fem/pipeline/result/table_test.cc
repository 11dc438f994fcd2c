#include "fem/pipeline/base/numbers.h"
#include "fem/pipeline/result/number_format.h"
#include "fem/pipeline/result/results.h"

#include <gtest/gtest.h>

#include <limits>

namespace stemware::pipeline
{
namespace
{

const double nothing = std::numeric_limits<double>::quiet_NaN();

struct Everything
{
  std::string who;
  unsigned int cells;
  double spin;
  std::optional<double> half;
  bool pulls;
  std::array<double, 2> at;
};

const std::vector<Everything> rows = { { "a, \"b\"", 100000, -1.23456789, 0.25, true, { 1.5, 3.5 } },
                                       { "c < d", 7, 1e-15, std::nullopt, false, { 2.5, 4.5 } } };

Fields<Everything> all_fields()
{
  return Fields<Everything>{
    { "who", "", "Who.", &Everything::who, in_file("who", "who it is"), shown_as("who") },
    { "cells", "1", "", &Everything::cells, in_file("cells", "how many"), on_console("cells") },
    { "spin", "rad/s", "Spin.", &Everything::spin, in_file("terminal omega", "spin"), on_page("ω_∞"),
      on_console("terminal\nspin"), with_digits(".5g") },
    { "half", "rad/s", "Half.", &Everything::half, in_file("half", "half"), on_console("half") },
    { "pulls", "", "", &Everything::pulls, in_file("pulls", "whether it pulls") },
    { "at", "s", "Places.", &Everything::at,
      with_places({ { "at1", "s", "", "at 1", "first", "first", "at 1" },
                    { "at2", "s", "", "at 2", "second", "", "at 2" } }) }
  };
}

TEST(Table, PrintsAsADataTable)
{
  Table table = all_fields().table(rows, Face::file, "Numbers");
  table.columns.erase(table.columns.begin());
  EXPECT_EQ(data_table(table), R"(# Numbers
# 1: cells (1)
# 2: terminal omega (rad/s)
# 3: half (rad/s)
# 4: pulls ()
# 5: at 1 (s)
# 6: at 2 (s)
                  100000              -1.23456789                     0.25                        1                      1.5                      3.5
                       7                    1e-15                      nan                        0                      2.5                      4.5
)");
}

TEST(Table, PrintsAsCsv)
{
  EXPECT_EQ(csv_table(all_fields().table(rows, Face::file)),
            "who,cells (1),terminal omega (rad/s),half (rad/s),pulls,at 1 (s),at 2 (s)\r\n"
            "\"a, \"\"b\"\"\",100000,-1.23456789,0.25,1,1.5,3.5\r\nc < d,7,1e-15,,0,2.5,4.5\r\n");
}

TEST(Table, PrintsOnTheConsole)
{
  std::vector<Everything> shown = rows;
  shown[1].spin = 0;
  EXPECT_EQ(console_table(all_fields().table(shown, Face::console)),
            R"(                  terminal
                      spin     half  at 1  at 2
  who      cells   (rad/s)  (rad/s)   (s)   (s)
  a, "b"  100000   -1.2346     0.25   1.5   3.5
  c < d        7         0        -   2.5   4.5
)");
}

Table texts(const std::vector<std::pair<std::string, Json>> &cells)
{
  Table table;
  for (const auto &[label, cell] : cells)
  {
    table.columns.push_back({ { label, "", "", label, label, label, label }, { cell } });
  }
  return table;
}

TEST(Table, ColumnsOnTheConsoleAreAlignedByCharactersNotBytes)
{
  EXPECT_EQ(console_table(texts({ { "τ", 1 }, { "ω", 10 } })), "  τ   ω\n  1  10\n");
}

TEST(Table, CsvQuotesLineEnds)
{
  EXPECT_EQ(csv_table(texts({ { "a", "two\nlines" }, { "b", "" } })), "a,b\r\n\"two\nlines\",\r\n");
}

TEST(Table, WrapsWideTablesOnTheConsole)
{
  const auto wide = [](char letter) { return Json(std::string(40, letter)); };
  const std::string blanks(39, ' ');
  EXPECT_EQ(console_table(texts({ { "n", 1 }, { "a", wide('a') }, { "b", wide('b') }, { "c", wide('c') } })),
            "  n  a" + blanks + "  b\n  1  " + std::string(40, 'a') + "  " + std::string(40, 'b') +
              "\n\n  n  c\n  1  " + std::string(40, 'c') + "\n");
}

TEST(Table, ShowsOneRowAsAList)
{
  const Table list = as_list(all_fields().table({ rows[0] }, Face::page));
  EXPECT_EQ(Json(list.columns[0].cells).dump(), R"=(["who","ω_∞ (rad/s)","first (s)"])=");
  EXPECT_EQ(Json(list.columns[1].cells).dump(), R"(["a, \"b\"","-1.2346","1.5"])");
}

TEST(Table, ConsoleShowsADashForNonFiniteNumbers)
{
  EXPECT_EQ(console_table(texts({ { "x", nothing } })), "  x\n  -\n");
}

TEST(Quantities, AreWrittenToTheSummaryAndSchemaIfTheyHaveADescription)
{
  EXPECT_EQ(all_fields().json(rows[1]).dump(), R"({"who":"c < d","spin":1e-15,"half":null,"at":[2.5,4.5]})");
  const Json schema = all_fields().schema();
  EXPECT_EQ(schema["properties"]["half"].dump(),
            R"({"description":"Half.","unit":"rad/s","type":["number","null"]})");
  EXPECT_EQ(schema["properties"]["at"]["maxItems"], 2);
  EXPECT_EQ(schema["required"].dump(), R"(["who","spin","half","at"])");
}

TEST(Quantities, AreNullOrAbsentIfTheResultTheyDescribeIsMissing)
{
  using Row = std::optional<Everything>;
  const auto all_rows = [](const Row &row) { return row ? &rows : nullptr; };
  const auto self = [](const Row &row) { return row; };
  const Fields<Row> fields = { { "part", "Part.", all_fields(), self },
                               { "all", "List.", all_fields(), all_rows },
                               { "maybe", "Not always there.", all_fields(), self, or_absent() } };
  EXPECT_EQ(fields.json(std::nullopt).dump(), R"({"part":null,"all":null})");
  EXPECT_EQ(fields.json(rows[0])["all"][1]["who"], "c < d");
  EXPECT_EQ(fields.json(rows[0])["maybe"]["spin"], -1.23456789);
  EXPECT_EQ(fields.schema()["properties"]["part"]["type"].dump(), R"(["object","null"])");
  EXPECT_EQ(fields.schema()["required"].dump(), R"(["part","all"])");
}

TEST(NumberFormat, RoundsErrorBandsUp)
{
  EXPECT_EQ(format::number(4.81e-6, "band"), "4.9e-06");
  EXPECT_EQ(format::number(4.8e-6, "band"), "4.8e-06");
  EXPECT_EQ(format::number(0, "band"), "0");
}

TEST(NumberFormat, ShowsNonFiniteNumbersAsADashOrNan)
{
  const double infinite = std::numeric_limits<double>::infinity();
  for (const double none : { std::nan(""), -std::nan(""), infinite, -infinite })
  {
    for (const char *digits : { ".6g", "+.3g", ".1e", ".2f" })
      EXPECT_EQ(format::number(none, digits), "–") << digits;
  }
  EXPECT_EQ(format::number(-std::nan(""), "band"), "–");
  EXPECT_EQ(to_text(-std::nan("")), "nan");
  EXPECT_EQ(to_short_text(-std::nan("")), "nan");
}

TEST(NumberFormat, PrintsNumbersInTheGivenFormat)
{
  EXPECT_EQ(format::number(-3.1290926, ".6g"), "-3.12909");
  EXPECT_EQ(format::number(-3.12, "#.6g"), "-3.12000");
  EXPECT_EQ(format::number(1234.5, ".2e"), "1.23e+03");
  EXPECT_EQ(format::number(0, ".2e"), "0");
  EXPECT_EQ(format::number(0, "#.2e"), "0.00e+00");
  EXPECT_EQ(format::number(0, "+.3g%"), "0 %");
  EXPECT_EQ(format::number(0.17891, ".3g%"), "17.9 %");
  EXPECT_EQ(format::number(1, ".1f%"), "100.0 %");
  EXPECT_EQ(format::number(0.00274, "+.3g%"), "+0.274 %");
}

} // namespace
} // namespace stemware::pipeline
