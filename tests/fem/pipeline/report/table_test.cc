// One table in its forms: every kind of cell, what does not exist, and who sees which digits.
#include "fem/pipeline/report/table_renderers.h"
#include "fem/pipeline/support/numbers.h"

#include <gtest/gtest.h>

#include <limits>

namespace stemware::pipeline
{
namespace
{

using Json = nlohmann::ordered_json;

const double nothing = std::numeric_limits<double>::quiet_NaN();

/// Quantities of a document.
const Json own = { { "all",
                     { { "spin",
                         { { "name", "terminal omega" },
                           { "unit", "rad/s" },
                           { "heading", "ω_∞" },
                           { "label", "terminal\nspin" },
                           { "digits", ".3g" },
                           { "console_digits", ".5g" } } },
                       { "pulls", { { "name", "pulls" } } },
                       { "at[]",
                         { { { "name", "at 1" }, { "unit", "s" }, { "label", "at 1" } },
                           { { "name", "at 2" }, { "unit", "s" }, { "label", "at 2" } } } } } } };

Json rows_of_everything()
{
  Json rows = { { { "who", "a, \"b\"" },
                  { "cells (1)", 100000 },
                  { "spin", -1.23456789 },
                  { "half (rad/s)", std::optional(0.25) },
                  { "pulls", true },
                  { "at", { 1.5, 3.5 } } },
                { { "who", "c < d" },
                  { "cells (1)", 7 },
                  { "spin", 1e-15 },
                  { "half (rad/s)", std::optional<double>() },
                  { "pulls", false },
                  { "at", { 2.5, 4.5 } } } };
  return rows;
}

/// All of them, in the order of the rows.
Table table_of_everything(Json rows = rows_of_everything())
{
  return table_of(rows, "", "all", "All kinds of cells", own);
}

TEST(Table, AsDataTable)
{
  Table table = table_of_everything();
  table.title = "Numbers";
  table.columns.erase(table.columns.begin());
  EXPECT_EQ(data_table(table), R"(# Numbers
# 1: cells (1)
# 2: terminal omega (rad/s)
# 3: half (rad/s)
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
            "who,cells (1),terminal omega (rad/s),half (rad/s),pulls (1),at 1 (s),at 2 (s)\r\n"
            "\"a, \"\"b\"\"\",100000,-1.23456789,0.25,1,1.5,3.5\r\nc < d,7,1e-15,,0,2.5,4.5\r\n");
}

TEST(Table, OnTheConsole)
{
  Json rows = rows_of_everything();
  zero_rounding_errors(rows, "spin at", 1e-12);
  Table table = table_of_everything(rows);
  table.title = "";
  table.columns.erase(table.columns.begin() + 4);
  EXPECT_EQ(console_table(table),
            R"(                  terminal
                      spin     half  at 1  at 2
  who      cells   (rad/s)  (rad/s)   (s)   (s)
  a, "b"  100000   -1.2346     0.25   1.5   3.5
  c < d        7         0        -   2.5   4.5
)");
}

TEST(Table, ConsoleCountsLettersNotBytes)
{
  EXPECT_EQ(console_table(table_of({ { { "τ", 1 }, { "ω", 10 } } })), "  τ   ω\n  1  10\n");
}

TEST(Table, CsvQuotesLineEnds)
{
  EXPECT_EQ(csv_table(table_of({ { { "a", "two\nlines" }, { "b", "" } } }, "a b")),
            "a,b\r\n\"two\nlines\",\r\n");
}

TEST(Table, TooWideForTheConsoleGoesOnBelow)
{
  Json row = { { "n (1)", 1 } };
  for (const char letter : { 'a', 'b', 'c' })
    row[std::string(1, letter) + " (1)"] = std::string(40, letter);
  const std::string blanks(39, ' ');
  EXPECT_EQ(console_table(table_of(Json::array({ row }))),
            "  n  " + blanks + "a  " + blanks + "b\n  1  " + std::string(40, 'a') + "  " +
              std::string(40, 'b') + "\n\n  n  " + blanks + "c\n  1  " + std::string(40, 'c') + "\n");
}

TEST(Table, PartsOfItsRowsInJson)
{
  EXPECT_EQ(selected_keys(rows_of_everything(), "spin who").dump(),
            R"([{"spin":-1.23456789,"who":"a, \"b\""},{"spin":1e-15,"who":"c < d"}])");
  EXPECT_EQ(selected_keys(rows_of_everything()[1], "at").dump(), R"({"at":[2.5,4.5]})");
}

TEST(Table, OneObjectAsAList)
{
  EXPECT_EQ(
    name_value_list(table_of({ { "spin", 1.23456 }, { "at", { 1.5, 2 } } }, "spin at[]", "all", "", own))
      .dump(),
    R"=([{"what":"ω_∞ (rad/s)","is":"1.23"},{"what":"at 1 (s)","is":"1.5"},{"what":"at 2 (s)","is":"2"}])=");
}

TEST(Table, ANumberThatIsNotFiniteIsNoneForPeopleAndIsLeftToPublishInJson)
{
  const Table table = table_of({ { { "x (1)", nothing } } });
  EXPECT_EQ(console_table(table), "  x\n  -\n");
  EXPECT_EQ(Json(std::optional<double>()), nullptr);
  EXPECT_EQ(Json(std::optional(1.5)), 1.5);
}

TEST(Table, AMissingColumnIsNamed)
{
  EXPECT_THROW(table_of(rows_of_everything(), "who omega"), std::out_of_range);
  EXPECT_THROW(selected_keys(rows_of_everything(), "who omega"), Json::out_of_range);
}

TEST(Quantities, OfASectionStandBeforeThoseOfAll)
{
  EXPECT_EQ(heading_with_unit(quantity_named("band", "chain")), "band (rad/s)");
  EXPECT_EQ(heading_with_unit(quantity_named("band", "bands")), "band");
  EXPECT_EQ(quantity_named("band", "bands").digits, "band");
  EXPECT_EQ(quantity_named("force[]", "", 1).heading, "T_y");
  EXPECT_EQ(quantity_named("load harmonics", "band_parts").digits, "band");
  EXPECT_EQ(quantity_named("harmonic effect (%)").unit, "%");
  EXPECT_EQ(quantity_named("harmonic effect (%)").name, "harmonic effect");
}

TEST(Quantities, AreDeclaredByTheSchemaOfTheSummary)
{
  EXPECT_EQ(heading_with_unit(quantity_named("omega_terminal")), "terminal spin (rad/s)");
  EXPECT_EQ(quantity_named("omega_terminal", "budget").name, "terminal omega");
  EXPECT_EQ(quantity_named("step").unit, "") << "a word";
  EXPECT_EQ(quantity_named("torques[]", "chain", 1).unit, "N m") << "that of the list";
  EXPECT_EQ(quantity_named("table_motion[]", "contact", 2).unit, "rad") << "that of its place";
  EXPECT_EQ(quantity_named("omega", "terminal_spins").heading, "spin ω");
  EXPECT_EQ(quantity_named("tau_closed_form").heading, "tau_closed_form") << "no table shows it";
}

TEST(Quantities, APartOfTheSummaryHasTheKeysOfTheSchemaInItsOrder)
{
  const Json row = {
    { "reason", nullptr }, { "remark", "" }, { "omega_terminal", -3.5 }, { "name", "tilt" }
  };
  EXPECT_EQ(declared(Json::array({ row, row }), "without")[1].dump(),
            R"({"name":"tilt","omega_terminal":-3.5,"reason":null})");
  EXPECT_EQ(declared({ { "unknowns", 7 }, { "body", "solid" }, { "x", 1 } }, "contact").dump(),
            R"({"body":"solid","unknowns":7})");
  EXPECT_THROW(declared(row, "no part"), Json::out_of_range);
}

TEST(Quantities, ListedOnesOfAPartStandInTheOrderOfTheSchema)
{
  const Json contact = { { "unknowns", 7 },
                         { "mesh", { { "rim_radius", 0.03 }, { "cells", 9 } } },
                         { "linear_iterations", 5 },
                         { "table_motion", { 1e-6, 0., 2e-6 } },
                         { "body", "solid" } };
  const Json list = listed(contact, "contact");
  EXPECT_EQ(list.dump(), R"=({"body":"solid","cells":9,"unknowns":7,"table_motion":[1e-06,0.0,2e-06]})=");
  EXPECT_EQ(name_value_list(table_of(list, "", "contact")).back()["what"], "table tilted by q_2 (rad)");
  EXPECT_TRUE(listed(contact, "no part").empty());
}

TEST(NumberFormat, BandsAreRoundedUp)
{
  EXPECT_EQ(format::number(4.81e-6, "band"), "4.9e-06");
  EXPECT_EQ(format::number(4.8e-6, "band"), "4.8e-06");
  EXPECT_EQ(format::number(0, "band"), "0");
}

TEST(NumberFormat, ANumberThatDoesNotExistIsADash)
{
  const double infinite = std::numeric_limits<double>::infinity();
  for (const double none : { std::nan(""), -std::nan(""), infinite, -infinite })
  {
    for (const char *digits : { ".6g", "+.3g", ".1e", ".2f" })
      EXPECT_EQ(format::number(none, digits), "–") << digits;
  }
  EXPECT_EQ(format::number(-std::nan(""), "band"), "–");
  // Data files and pictures have one spelling.
  EXPECT_EQ(to_text(-std::nan("")), "nan");
  EXPECT_EQ(to_short_text(-std::nan("")), "nan");
}

TEST(NumberFormat, DigitsOfPeople)
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
  EXPECT_EQ(format::number(0.0123456, "1e3*.4g"), "12.35");
  EXPECT_EQ(format::number(4412, "about"), "about 4400");
  EXPECT_EQ(format::number(2110.4, "short"), "2110");
}

} // namespace
} // namespace stemware::pipeline
