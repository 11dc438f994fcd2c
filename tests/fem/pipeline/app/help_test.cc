#include "tests/fem/pipeline/matchers.h"
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

#include <sstream>

namespace stemware::test
{
namespace
{

std::vector<std::string> all_verbs(const std::string &help)
{
  std::istringstream lines(help);
  std::vector<std::string> verbs;
  std::string line;
  while (std::getline(lines, line) && line != "Verbs:")
    ;
  while (std::getline(lines, line) && !line.empty())
    // A verb's line is "  run      Compute a study ...". Continuation lines are indented deeper.
    if (line.compare(0, 3, "   ") != 0)
      verbs.push_back(line.substr(2, line.find(' ', 2) - 2));
  return verbs;
}

TEST(Help, FitsTheConsoleAndNamesExistingPages)
{
  const ScratchFolder scratch;
  const std::string help = stemware(scratch, { "--help" }).out;
  EXPECT_EQ(stemware(scratch, { "help" }).out, help);
  EXPECT_EQ(bad_lines(help), "");
  const std::vector<std::string> verbs = all_verbs(help);
  EXPECT_GE(verbs.size(), 4u);
  std::size_t n_pages = 0;
  for (const std::string &verb : verbs)
  {
    SCOPED_TRACE(verb);
    const Ended ended = stemware(scratch, { verb, "--help" });
    EXPECT_EQ(ended.exit_code, 0);
    EXPECT_EQ(ended.err, "");
    EXPECT_EQ(bad_lines(ended.out), "");
    for (const std::string &page : all_between(ended.out, "docs/", ".md"))
    {
      EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(STEMWARE_DOCS) / (page + ".md"))) << page;
      ++n_pages;
    }
  }
  EXPECT_GT(n_pages, 0u);
  EXPECT_EQ(stemware(scratch, { "help", "run" }).out, stemware(scratch, { "run", "--help" }).out);
}

TEST(Help, DefaultsOfOneSectionAreAValidStudyFile)
{
  const ScratchFolder scratch;
  const Ended table = stemware(scratch, { "defaults", "table" });
  EXPECT_EQ(table.exit_code, 0);
  EXPECT_EQ(table.out.rfind("subsection Table\n", 0), 0u) << table.out;
  EXPECT_EQ(table.out.find("subsection", 5), std::string::npos);
  scratch.write("table.prm", table.out);
  EXPECT_EQ(stemware(scratch, { "run", "table.prm", "--set", "Load/Source=first harmonic" }).exit_code, 0);
}

TEST(StudyOptions, ReadAStudyFromStandardInput)
{
  const ScratchFolder scratch;
  const std::string study = "subsection Load\n  set Source = first harmonic\nend\nsubsection Motion\n"
                            "  set Mass = 250 g\nend\n";
  scratch.write("study.prm", study);
  scratch.write("study.json", R"({"Load": {"Source": "first harmonic"}, "Motion": {"Mass": "250 g"}})");
  ASSERT_EQ(stemware(scratch, { "run", "study.prm" }).exit_code, 0);
  for (const char *file : { "study.prm", "study.json" })
  {
    const std::string command = std::string(STEMWARE_PROGRAM) + " run - --output piped < " + file;
    const Ended ended = RunningProgram({ "/bin/sh", "-c", command }, scratch.path()).end();
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    EXPECT_EQ(read_summary(scratch / "piped")["ring"], read_summary(scratch / "results/study")["ring"]);
  }
}

TEST(Help, PrintsTheVersion)
{
  const ScratchFolder scratch;
  const Ended ended = stemware(scratch, { "--version" });
  EXPECT_EQ(ended.exit_code, 0);
  EXPECT_EQ(ended.out.rfind("stemware " STEMWARE_VERSION " (", 0), 0u) << ended.out;
}

TEST(DefaultStudy, RunsWithoutAStudyFile)
{
  const ScratchFolder scratch;
  const std::string source = "Load/Source=first harmonic";
  const Ended ended = stemware(scratch, { "run", "--set", source });
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_THAT(ended.out, testing::HasSubstr("Study     default\n"));
  const std::string file = scratch.write("empty.prm", "# nothing differs\n");
  EXPECT_EQ(stemware(scratch, { "run", file, "--set", source }).exit_code, 0);
  EXPECT_EQ(read_text(scratch / "results/default/summary.json"),
            read_text(scratch / "results/empty/summary.json"));

  EXPECT_EQ(stemware(scratch, { "truncate", "--set", source }).exit_code, 0);
  EXPECT_EQ(stemware(scratch, { "sweep", "--set", source, "--vary", "Motion/Mass=0.2,0.3" }).exit_code, 0);
  EXPECT_EQ(names_in(scratch / "results"),
            (std::vector<std::string>{ "default", "default-sweep", "default-truncate", "empty" }));
}

TEST(Container, SolvesAContactIfNoOtherProgramIsOnThePath)
{
  const ScratchFolder scratch;
  scratch.write("coarse.prm", coarse_study());
  const std::string command = "PATH=/nowhere exec " STEMWARE_PROGRAM " run coarse.prm";
  const Ended ended = RunningProgram({ "/bin/sh", "-c", command }, scratch.path()).end();
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_EQ(ended.err, "");
  EXPECT_THAT(ended.out, testing::HasSubstr("unknowns"));
}

} // namespace
} // namespace stemware::test
