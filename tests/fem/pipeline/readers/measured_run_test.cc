// Runs of a glass as phones, video trackers, spreadsheets, instruments and boards write them. The files in
// tables/ are made by hand after the documentation of these programs.
#include "fem/pipeline/input/data_files.h"
#include "tests/fem/pipeline/matchers.h"
#include "tests/fem/pipeline/refusal.h"

#include <gtest/gtest.h>

#include <cmath>

namespace stemware::pipeline
{
namespace
{

MeasuredRun read(const std::string &name, const std::string &column = "")
{
  return read_measured_run(STEMWARE_TABLES + ("/" + name), column);
}

MeasuredRun parse(const std::string &text)
{
  return parse_measured_run("run.csv", text);
}

TEST(MeasuredRun, FilesOfTheUsualProgramsAreRead)
{
  struct File
  {
    std::string name, column = "";
    unsigned int n_skipped = 0;
  };
  for (const auto &[name, column, n_skipped] : std::vector<File>{ { "phyphox_comma.csv" },
                                                                  { "phyphox_semicolon.csv" },
                                                                  { "phyphox_tab.csv" },
                                                                  { "phyphox_tab.csv", "Gyroscope z" },
                                                                  { "tracker5.txt", "", 2 },
                                                                  { "tracker6.txt", "", 2 },
                                                                  { "libreoffice.csv" },
                                                                  { "libreoffice_quoted.csv" },
                                                                  { "excel_german.csv", "", 1 },
                                                                  { "excel_us.csv" },
                                                                  { "oscilloscope.csv", "CH1" },
                                                                  { "arduino.txt" } })
  {
    SCOPED_TRACE(name + " " + column);
    const MeasuredRun run = read(name, column);
    ASSERT_EQ(run.times.size(), 2u);
    EXPECT_FALSE(run.is_angle);
    for (std::size_t i = 0; i < 2; ++i)
    {
      EXPECT_DOUBLE_EQ(run.times[i], i == 0 ? 0.1 : 0.2);
      EXPECT_NEAR(run.values[i], i == 0 ? -1.5 : -2.25, 1e-11); // rpm have twelve digits
    }
    EXPECT_THAT(run.summary, testing::HasSubstr("2 rows"));
    EXPECT_EQ(run.summary.find("skipped") != std::string::npos, n_skipped > 0) << run.summary;
    if (n_skipped > 0)
    {
      EXPECT_THAT(run.summary, testing::HasSubstr(std::to_string(n_skipped) + " without a value"));
    }
  }
}

/// Each sentence names the file's line or column and the cure.
TEST(MeasuredRun, OtherFilesAreRefusedWithTheCure)
{
  for (const auto &[name, words] :
       std::vector<std::pair<std::string, std::string>>{ { "tracker5_degrees.txt", "angle (deg)" },
                                                         { "excel_us_thousands.csv", "line 2, column 1" },
                                                         { "excel_german_thousands.csv", "line 2, column 1" },
                                                         { "oscilloscope.csv", "Motion/Measured column" },
                                                         { "oscilloscope_units.csv", "write " },
                                                         { "arduino_timestamps.txt", "timestamps" },
                                                         { "arduino_plotter.txt", "write " } })
  {
    const std::string file = name, sentence = test::sentence_of([&] { read(file); });
    EXPECT_THAT(sentence, testing::HasSubstr(words)) << name;
    EXPECT_EQ(sentence.back(), '.');
    EXPECT_LT(sentence.size(), 700u) << sentence;
  }
  EXPECT_THAT(test::sentence_of([] { read("oscilloscope.csv", "CH2"); }), testing::HasSubstr("\"CH2\""));
}

TEST(MeasuredRun, AnglesBecomeTheirMeanSpins)
{
  const MeasuredRun run = parse("t (s),angle (deg)\n0,0\n0.5,-90\n0.5,-90\n1,-270\n");
  EXPECT_TRUE(run.is_angle);
  EXPECT_DOUBLE_EQ(run.values[1], -M_PI / 2);
  const std::vector<MeasuredSpin> spins = spins_of(run);
  ASSERT_EQ(spins.size(), 2u);
  EXPECT_DOUBLE_EQ(spins[0].time, 0.25);
  EXPECT_DOUBLE_EQ(spins[0].omega, -M_PI);
  EXPECT_DOUBLE_EQ(spins[1].omega, -2 * M_PI);
  EXPECT_FALSE(parse("t (s),θ (rad),ω (rad/s)\n0,0,1\n").is_angle);
}

TEST(MeasuredRun, FallingTimesAndDegreesWithoutUnitAreRefused)
{
  const auto refusal = [&](const std::string &text) { return test::sentence_of([&] { parse(text); }); };
  EXPECT_THAT(refusal("t (s), omega (rad/s)\n0.2, -1\n0.1, -2\n"), testing::HasSubstr("line 3: the time"));
  EXPECT_THAT(refusal("t, omega\n0.1, -1\n0.2, -82\n"), testing::HasSubstr("line 3: omega"));
  EXPECT_EQ(parse("t, omega (rad/s)\n0.1, -82\n").times.size(), 1u);
  EXPECT_THAT(parse("t, omega\n0.1, -1\n0.1, -2\n").summary, testing::HasSubstr("(line 3)"));
}

} // namespace
} // namespace stemware::pipeline
