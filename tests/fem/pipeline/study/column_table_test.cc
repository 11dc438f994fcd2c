#include "fem/pipeline/study/column_table.h"
#include "ring_model/load/constants.h"
#include "tests/fem/pipeline/matchers.h"
#include "tests/fem/pipeline/refusal.h"

#include <gtest/gtest.h>

namespace stemware::pipeline
{
namespace
{

const std::vector<FileColumn> time_and_spin = { { { "t", "time" }, "s" },
                                                { { "omega", "ω", "gyroscope z" }, "rad/s" } };

std::vector<TableRow<double>> read(const std::string &text)
{
  return parse_columns("run.csv", text, time_and_spin);
}

std::string column_text_refusal(const std::string &text)
{
  return test::sentence_of([&] { read(text); });
}

TEST(ColumnTable, ReadsSpinsInTurnsOrDegreesPerTime)
{
  for (const auto &[unit, factor] : { std::pair("rpm", ring::pi / 30), std::pair("rev/s", 2 * ring::pi),
                                      std::pair("°/s", ring::pi / 180), std::pair("deg/s", ring::pi / 180) })
    EXPECT_NEAR(read(std::string("t (s), omega (") + unit + ")\n1,-60\n").at(0).cells[1], -60 * factor,
                60 * factor * 1e-15)
      << unit;
}

TEST(ColumnTable, NamesTheErrorOfABadTable)
{
  for (const auto &[text, words] : std::vector<std::pair<std::string, std::string>>{
         { "t (s),omega (rad/s)\n1,\"-1,500\"\n", "line 2, column 2" },          // -1.5 or -1500?
         { "t (ms);omega (rad/s)\n100;-1.5\n1,200;-2.5\n", "line 3, column 1" }, // 1.2 or 1200?
         { "t (s),omega (rad/s)\n0,1,-1,43\n", "semicolons" },
         { "t (s),omega (rad/s),ω (rad/s)\n1,2,3\n", "line 1" },
         { "frame,omega (rad/s)\n1,2\n", "line 1" },
         { "t (s),omega (rad/s)\n1,2\nend of record,-\n3,x\n", "line 3, column" },
         { "t omega theta\n1 2\n", "line 2" },
         { "t,omega\n1,2\n3,\n", "line 3, column 2" } })
  {
    const std::string sentence = column_text_refusal(text);
    EXPECT_THAT(sentence, testing::HasSubstr(words)) << text;
    EXPECT_EQ(sentence.rfind("run.csv", 0), 0u);
    EXPECT_EQ(sentence.back(), '.');
    EXPECT_LT(sentence.size(), 320u) << sentence;
  }
}

} // namespace
} // namespace stemware::pipeline
