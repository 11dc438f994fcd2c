#include "tests/fem/pipeline/matchers.h"
#include "tests/fem/pipeline/page_document.h"
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <map>
#include <regex>

namespace stemware::test
{
namespace
{

namespace fs = std::filesystem;

struct LiftedRun
{
  const ScratchFolder scratch;
  const Ended ended = stemware(
    scratch, with_settings({ "run", scratch.write("study.prm", plain_study()), "--output", "results" },
                           { "Load/Moment ratio=1.3", "Motion/Closure=paper", "Motion/End time=0.2",
                             "Motion/Euler step=0.01" }));
  const fs::path results = scratch / "results";
};

const LiftedRun &lifted_run()
{
  static const LiftedRun run;
  return run;
}

/// Returns the number after the first occurrence of @p words in @p broken, a text with line breaks.
double number_behind(const std::string &words, const std::string &broken)
{
  const std::string text = std::regex_replace(broken, std::regex("\\s+"), " ");
  const auto place = text.find(words);
  return place == std::string::npos ? std::nan("") : std::stod(text.substr(place + words.size()));
}

std::string per_cent(double change)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.3g %%", 100 * std::abs(change));
  return text;
}

TEST(RunReport, ShowsTheNumbersOfTheSummary)
{
  const LiftedRun &run = lifted_run();
  ASSERT_EQ(run.ended.exit_code, 0) << run.ended.err;
  EXPECT_EQ(run.ended.err, "");
  const auto summary = read_summary(run.results);
  const std::string answer = between(read_text(run.results / "report.html"), "<p class=\"answer\">", "</p>");
  const double omega = summary["ring"]["omega_terminal"];
  const double band = summary["error_bands"]["omega_terminal"]["band"];
  const double effect = summary["harmonic_effect"]["relative"];
  for (const std::string &text : { answer, run.ended.out })
  {
    EXPECT_NEAR(number_behind("terminal spin is ", text), omega, std::max(5e-4 * std::abs(omega), band))
      << text;
    const double printed = number_behind("(\u00b1 ", text);
    EXPECT_GE(printed, band * (1 - 1e-9)) << text;
    EXPECT_LE(printed, 1.2 * band) << text;
  }
  EXPECT_THAT(answer, testing::HasSubstr("harmonics of the"));
  EXPECT_THAT(answer, testing::HasSubstr(per_cent(effect) + (effect > 0 ? " faster" : " slower")));
  EXPECT_THAT(answer, testing::HasSubstr("(one-way)")); // a given moment implies one-way coupling
  EXPECT_THAT(run.ended.out,
              testing::HasSubstr("\nReport    " + fs::absolute(run.results / "report.html").string() + "\n"));
}

TEST(RunReport, ListsTheFilesOfTheFolder)
{
  const fs::path &results = lifted_run().results;
  const nlohmann::json files = page_document(results)["files"];
  EXPECT_GT(files.size(), 10u);
  for (const auto &file : files)
    EXPECT_TRUE(fs::exists(results / file[0].get<std::string>())) << file;
  EXPECT_EQ(read_summary(results)["files"].get<std::vector<std::string>>(), names_in(results));
}

TEST(RunReport, MarksEntriesThatDifferFromTheirDefaults)
{
  const nlohmann::json page = page_document(lifted_run().results);
  std::map<std::string, bool> differs;
  for (const auto &entry : page["entries"])
    differs[entry["entry"].get<std::string>()] = entry.contains("default");
  EXPECT_TRUE(differs.at("Load/Moment ratio"));
  EXPECT_FALSE(differs.at("Motion/Mass"));
}

} // namespace
} // namespace stemware::test
