#include "fem/pipeline/base/text_file.h"
#include "fem/pipeline/study/table_file.h"
#include "ring_model/load/constants.h"
#include "tests/fem/pipeline/matchers.h"
#include "tests/fem/pipeline/program_runner.h"
#include "tests/fem/pipeline/refusal.h"

#include <gtest/gtest.h>

#include <sys/stat.h>

namespace stemware::pipeline
{
namespace
{

using test::ScratchFolder;

const std::vector<FileColumn> time_and_speed = { { { "t", "time" }, "s" }, { { "v", "speed" }, "m/s" } };

std::vector<TableRow<double>> rows_of(const std::string &file)
{
  return parse_columns("Entry = my.csv", read_input_text("Entry = my.csv", file), time_and_speed);
}

std::string column_refusal(const std::string &file)
{
  return test::sentence_of([&] { rows_of(file); });
}

TEST(ColumnFile, ReadsAnySeparatorUnitHeadingAndOrderOfColumns)
{
  const ScratchFolder scratch;
  for (const std::string text :
       { "t (s), v (m/s)\n0.5, 0.2\n1.5, 0.35\n", "t, v\n0.5, 0.2\n1.5, 0.35\n",
         "# measured\n\n0.5 0.2\n 1.5\t0.35 \n", "time [ms]; speed [cm/s]\r\n500; 20\r\n\r\n1500; 35\r\n",
         "\xEF\xBB\xBF\"time (ms)\",\"speed (mm/s)\"\n# by hand\n500,200\n1500,350",
         "t v\n0.5  0.2\n1.5 0.35\n", "v (m/s), t (s)\n0.2, 0.5\n0.35, 1.5\n",
         "t ms, v cm/s\n5e2, 20\n+1500, 35\n" })
  {
    SCOPED_TRACE(text);
    const std::vector<TableRow<double>> rows = rows_of(scratch.write("my.csv", text));
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_DOUBLE_EQ(rows[0].cells.at(0), 0.5);
    EXPECT_DOUBLE_EQ(rows[0].cells.at(1), 0.2);
    EXPECT_DOUBLE_EQ(rows[1].cells.at(0), 1.5);
    EXPECT_DOUBLE_EQ(rows[1].cells.at(1), 0.35);
  }
  EXPECT_EQ(rows_of(scratch.write("my.csv", "\n# one\n\n1 2\n")).front().line, 4u);
}

TEST(ColumnFile, ReadsSpinsInTurnsOrDegreesPerTime)
{
  const std::vector<FileColumn> columns = { { { "t", "time" }, "s" }, { { "omega", "ω" }, "rad/s" } };
  for (const auto &[unit, factor] : { std::pair("rpm", ring::pi / 30), std::pair("rev/s", 2 * ring::pi),
                                      std::pair("°/s", ring::pi / 180), std::pair("deg/s", ring::pi / 180) })
    EXPECT_NEAR(
      parse_columns("run.csv", std::string("t (s), omega (") + unit + ")\n1,-60\n", columns).at(0).cells[1],
      -60 * factor, 60 * factor * 1e-15)
      << unit;
}

TEST(ColumnFile, NamesTheErrorOfABadFile)
{
  const ScratchFolder scratch;
  const std::string header = "t (s), v (m/s)\n";
  const std::vector<std::pair<std::string, std::string>> bad = {
    { "", "has no rows" },
    { header + "# nothing\n", "has no rows" },
    { "t (s), v (kg)\n0, 1\n", "line 1: the header \"t (s), v (kg)\" does not name the columns t, v" },
    { "t (s), v (furlong/s)\n0, 1\n", "line 1" },
    { "t (s)\n0\n", "line 1" },
    { header + header + "0, 1\n", "line 2" },
    { "0, 1\n" + header, "line 2" },
    { header + "0, 1, 2\n", "line 2" },
    { header + "\n0\n", "line 3" },
    { header + "0, 1\n1, two\n", "line 3, column 2: \"two\" is not a number" },
    { header + "0, nan\n", "line 2" },
    { header + "0, 1e999\n", "line 2" },
    { header + "0,,1\n", "line 2" },
    { std::string("\x7f"
                  "ELF\0\0\1",
                  7),
      "line 1" },
    { std::string(100000, '7'), "line 1" },
    { header + "1,\"-1,500\"\n", "line 2, column 2" },                // -1.5 or -1500?
    { "t (ms);v (m/s)\n100;-1.5\n1,200;-2.5\n", "line 3, column 1" }, // 1.2 or 1200?
    { header + "0,1,-1,43\n", "semicolons" },
    { "t (s),v (m/s),speed (m/s)\n1,2,3\n", "line 1" },
    { "frame,v (m/s)\n1,2\n", "line 1" },
    { header + "1,2\nend of record,-\n3,x\n", "line 3, column" },
    { "t v theta\n1 2\n", "line 2" },
    { "t,v\n1,2\n3,\n", "line 3, column 2" },
  };
  for (const auto &[text, words] : bad)
  {
    const std::string sentence = column_refusal(scratch.write("my.csv", text));
    EXPECT_EQ(sentence.rfind("Entry = my.csv", 0), 0u) << sentence;
    EXPECT_THAT(sentence, testing::HasSubstr(words));
    EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
    EXPECT_EQ(sentence.back(), '.') << sentence;
    EXPECT_LT(sentence.size(), 320u) << sentence;
  }
}

/// Pipes and devices are refused without being opened, because reading them might never end.
TEST(ColumnFile, RefusesMissingFilesFoldersPipesAndLargeFiles)
{
  const ScratchFolder scratch;
  const std::string pipe = scratch / "pipe.csv";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  for (const std::string &file : { scratch.path().string(), pipe, std::string("/dev/zero") })
    EXPECT_EQ(column_refusal(file), "Entry = my.csv is not a file; give the path of a file.") << file;
  EXPECT_THAT(column_refusal(scratch / "missing.csv"), testing::HasSubstr("does not exist"));
  EXPECT_THAT(column_refusal(scratch.write("long.csv", std::string(16000001, '\n'))),
              testing::HasSubstr("larger than 16 MB"));
}

} // namespace
} // namespace stemware::pipeline
