// One table in its four forms: every kind of cell, what does not exist, and who sees which digits.
#include "fem/pipeline/report/render/table_renderers.h"
#include "fem/pipeline/support/numbers.h"

#include <gtest/gtest.h>

#include <limits>

namespace stemware::pipeline
{
namespace
{

const double nothing = std::numeric_limits<double>::quiet_NaN();

Table table_of_everything()
{
  const Quantity spin("spin", "terminal omega", "rad/s", "ω_∞", "terminal\nspin", format::significant<3>,
                      format::significant<5>);
  return {
    "All kinds of cells",
    { column(Quantity("name", "name", "", "name", "name"), std::vector<std::string>{ "a, \"b\"", "c < d" }),
      column(Quantity("n", "cells", "1", "cells", "cells"), std::vector<unsigned int>{ 100000, 7 }),
      column(
        spin, std::vector<double>{ -1.23456789, 1e-15 }, [](double value) { return value; }, 1e-12),
      column(Quantity("band", "band", "rad/s", "band", "band"),
             std::vector<std::optional<double>>{ 0.25, std::nullopt }),
      column(Quantity("pulls", "pulls"), std::vector<int>{ 1, 0 }, [](int value) { return value == 1; }),
      column(Quantity("at[]", "at 1", "s", "at 1", "at 1"), std::vector<double>{ 1.5, 2.5 }),
      column(Quantity("at[]", "at 2", "s", "at 2", "at 2"), std::vector<double>{ 3.5, 4.5 }) }
  };
}

TEST(Table, AsDataTable)
{
  EXPECT_EQ(data_table(table_of_everything().with("Numbers", "n spin band pulls at[]")), R"(# Numbers
# 1: cells (1)
# 2: terminal omega (rad/s)
# 3: band (rad/s)
# 4: pulls (1)
# 5: at 1 (s)
# 6: at 2 (s)
                  100000              -1.23456789                     0.25                        1                      1.5                      3.5
                       7                    1e-15                      nan                        0                      2.5                      4.5
)");
}

TEST(Table, AsCsv)
{
  EXPECT_EQ(csv_table(table_of_everything()),
            "name,cells (1),terminal omega (rad/s),band (rad/s),pulls (1),at 1 (s),at 2 (s)\r\n"
            "\"a, \"\"b\"\"\",100000,-1.23456789,0.25,1,1.5,3.5\r\nc < d,7,1e-15,,0,2.5,4.5\r\n");
}

TEST(Table, OnTheConsole)
{
  EXPECT_EQ(console_table(table_of_everything().with("", "name n spin band at[]")),
            R"(                  terminal
                      spin     band  at 1  at 2
  name     cells   (rad/s)  (rad/s)   (s)   (s)
  a, "b"  100000   -1.2346     0.25   1.5   3.5
  c < d        7         0        -   2.5   4.5
)");
}

TEST(Table, ConsoleCountsLettersNotBytes)
{
  EXPECT_EQ(console_table({ "",
                            { column(Quantity("", "", "1", "", "τ"), std::vector<int>{ 1 }),
                              column(Quantity("", "", "1", "", "ω"), std::vector<int>{ 10 }) } }),
            "  τ   ω\n  1  10\n");
}

TEST(Table, CsvQuotesLineEnds)
{
  EXPECT_EQ(csv_table(words("", { "a", "b" }, { { "two\nlines", "" } })), "a,b\r\n\"two\nlines\",\r\n");
}

TEST(Table, TooWideForTheConsoleGoesOnBelow)
{
  Table table = { "", { column(Quantity("", "", "1", "", "n"), std::vector<int>{ 1 }) } };
  for (int i = 0; i < 3; ++i)
    table.columns.push_back(column(Quantity("", "", "1", "", std::string(1, static_cast<char>('a' + i))),
                                   std::vector<std::string>{ std::string(40, static_cast<char>('a' + i)) }));
  const std::string blanks(39, ' ');
  EXPECT_EQ(console_table(table), "  n  " + blanks + "a  " + blanks + "b\n  1  " + std::string(40, 'a') +
                                    "  " + std::string(40, 'b') + "\n\n  n  " + blanks + "c\n  1  " +
                                    std::string(40, 'c') + "\n");
}

TEST(Table, AsHtml)
{
  EXPECT_EQ(html_table(table_of_everything().with("ω_∞ & more", "name spin band pulls")),
            R"(<div class="wide" tabindex="0" role="group" aria-label="ω_∞ &amp; more"><table>
<caption>ω_∞ &amp; more</caption>
<thead><tr><th scope="col">name</th><th scope="col" class="number">ω_∞ (rad/s)</th><th scope="col" class="number">band (rad/s)</th><th scope="col"></th></tr>
</thead>
<tbody>
<tr><td>a, &quot;b&quot;</td><td class="number">−1.23</td><td class="number">0.25</td><td>yes</td></tr>
<tr><td>c &lt; d</td><td class="number">0</td><td class="number">–</td><td>no</td></tr>
</tbody>
</table>
</div>
)");
}

TEST(Table, AsJson)
{
  EXPECT_EQ(json_table(table_of_everything()).dump(),
            R"([{"name":"a, \"b\"","n":100000,"spin":-1.23456789,"band":0.25,"pulls":true,"at":[1.5,3.5]},)"
            R"({"name":"c < d","n":7,"spin":1e-15,"band":null,"pulls":false,"at":[2.5,4.5]}])");
  EXPECT_EQ(json_by_name(table_of_everything().with("", "name n")).dump(),
            R"({"a, \"b\"":{"n":100000},"c < d":{"n":7}})");
}

TEST(Table, ANumberThatIsNotFiniteIsNoneForPeopleAndIsLeftToPublishInJson)
{
  const Table table = { "", { single(Quantity("x", "x", "1", "x", "x"), nothing) } };
  EXPECT_EQ(console_table(table), "  x\n  -\n");
  EXPECT_NE(html_table(table).find("–"), std::string::npos);
  EXPECT_TRUE(std::isnan(json_row(table)["x"].get<double>()));
  EXPECT_EQ(json_number(std::nullopt), nullptr);
  EXPECT_EQ(json_number(1.5), 1.5);
}

TEST(Table, AMissingColumnIsNamed)
{
  EXPECT_THROW(table_of_everything().with("", "name omega"), std::out_of_range);
  Table table = table_of_everything();
  EXPECT_THROW(table["omega"], std::out_of_range);
  table["spin"].digits = format::fixed<1>;
  EXPECT_EQ(shown(table.columns[2], 0, "–"), "-1.2");
}

TEST(NumberFormat, BandsAreRoundedUp)
{
  EXPECT_EQ(format::band(4.81e-6), "4.9e-06");
  EXPECT_EQ(format::band(4.8e-6), "4.8e-06");
  EXPECT_EQ(format::band(0), "0");
}

TEST(NumberFormat, ANumberThatDoesNotExistIsADash)
{
  const double infinite = std::numeric_limits<double>::infinity();
  for (const double none : { std::nan(""), -std::nan(""), infinite, -infinite })
  {
    EXPECT_EQ(format::significant<6>(none), "–");
    EXPECT_EQ(format::signed_significant<3>(none), "–");
    EXPECT_EQ(format::scientific_or_zero<1>(none), "–");
    EXPECT_EQ(format::fixed<2>(none), "–");
    EXPECT_EQ(fmt::format(FMT_STRING("{:+.3g} N, {:.1f} %"), format::Number{ none }, format::Number{ 12.34 }),
              "– N, 12.3 %");
  }
  EXPECT_EQ(format::band(-std::nan("")), "–");
  // Data files and pictures have one spelling.
  EXPECT_EQ(to_text(-std::nan("")), "nan");
  EXPECT_EQ(to_short_text(-std::nan("")), "nan");
}

TEST(NumberFormat, DigitsOfPeople)
{
  EXPECT_EQ(format::significant<6>(-3.1290926), "-3.12909");
  EXPECT_EQ(format::all_significant<6>(-3.12), "-3.12000");
  EXPECT_EQ(format::scientific<2>(1234.5), "1.23e+03");
  EXPECT_EQ(format::scientific_or_zero<2>(0), "0");
  EXPECT_EQ(format::percent<3>(0.17891), "17.9 %");
  EXPECT_EQ(format::percent_fixed<1>(1), "100.0 %");
  EXPECT_EQ(format::change(0.00274), "+0.274 %");
  EXPECT_EQ(format::change_fixed(-0.179), "-17.900 %");
}

} // namespace
} // namespace stemware::pipeline
