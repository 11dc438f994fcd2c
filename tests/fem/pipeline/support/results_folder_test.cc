#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/folder_claim.h"
#include "fem/pipeline/support/results_folder.h"
#include "fem/pipeline/support/text_file.h"
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

namespace stemware::pipeline
{
namespace
{

using test::names_in;
using test::read_text;
using test::ScratchFolder;
using Names = std::vector<std::string>;

void publish(const std::filesystem::path &target, const std::string &mark)
{
  ResultsFolder folder(target);
  write_text_file(folder.working_folder() / "mark", mark);
  write_text_file(folder.working_folder() / "summary.json",
                  R"({"schema": 1, "files": ["mark", "summary.json"]})");
  folder.publish();
}

TEST(ResultsFolder, AppearsOnlyWhenPublished)
{
  const ScratchFolder scratch;
  {
    ResultsFolder folder(scratch / "results/paper");
    EXPECT_TRUE(std::filesystem::is_directory(folder.working_folder()));
    EXPECT_FALSE(std::filesystem::exists(scratch / "results/paper"));
    write_text_file(folder.working_folder() / "b", "2");
    write_text_file(folder.working_folder() / "a", "1");
    EXPECT_EQ(folder.contents(), (Names{ "a", "b" }));
    folder.publish();
  }
  EXPECT_EQ(names_in(scratch / "results"), Names{ "paper" });
  EXPECT_EQ(names_in(scratch / "results/paper"), (Names{ "a", "b" }));
}

TEST(ResultsFolder, LeavesNothingWhenNotPublished)
{
  const ScratchFolder scratch;
  {
    const ResultsFolder folder(scratch / "results/deep/paper");
    write_text_file(folder.working_folder() / "a", "1");
  }
  EXPECT_EQ(names_in(scratch.path()), Names{});
}

TEST(ResultsFolder, ReplacesOlderResultsWholly)
{
  const ScratchFolder scratch;
  publish(scratch / "paper", "old");
  {
    const ResultsFolder given_up(scratch / "paper");
    write_text_file(given_up.working_folder() / "mark", "given up");
  }
  EXPECT_EQ(read_text(scratch / "paper/mark"), "old");
  publish(scratch / "paper", "new");
  EXPECT_EQ(read_text(scratch / "paper/mark"), "new");
  EXPECT_EQ(names_in(scratch.path()), Names{ "paper" });
}

TEST(ResultsFolder, LeavesOtherPeoplesFilesAlone)
{
  const ScratchFolder scratch;
  std::filesystem::create_directory(scratch / "thesis");
  scratch.write("thesis/chapter.tex", "years of work");
  EXPECT_THROW(ResultsFolder(scratch / "thesis"), OutputFailure);
  publish(scratch / "paper", "old");
  scratch.write("paper/notes.txt", "a note beside the results");
  EXPECT_THROW(ResultsFolder(scratch / "paper"), OutputFailure);
  scratch.write("file", "");
  EXPECT_THROW(ResultsFolder(scratch / "file"), OutputFailure);
  EXPECT_EQ(read_text(scratch / "thesis/chapter.tex"), "years of work");
  EXPECT_EQ(read_text(scratch / "paper/mark"), "old");
  EXPECT_EQ(names_in(scratch.path()), (Names{ "file", "paper", "thesis" }));
}

TEST(ResultsFolder, RemovesWhatKilledProcessesLeft)
{
  const ScratchFolder scratch;
  for (const char *name :
       { ".paper.partial-1", ".paper.partial-2", ".paper.partial-3.replaced", ".other.partial-1" })
    std::filesystem::create_directory(scratch / name);
  scratch.write(".paper.partial-1/load.dat", "half a table");
  {
    const FolderClaim at_work(scratch / ".paper.partial-2");
    EXPECT_TRUE(at_work.held());
    const ResultsFolder folder(scratch / "paper");
    // The older results of a process that was killed in the midst of replacing them exist nowhere else.
    EXPECT_FALSE(std::filesystem::exists(scratch / ".paper.partial-1"));
    for (const char *name : { ".paper.partial-2", ".paper.partial-3.replaced", ".other.partial-1" })
      EXPECT_TRUE(std::filesystem::exists(scratch / name)) << name;
  }
  publish(scratch / "paper", "new");
  publish(scratch / "paper", "newer");
  EXPECT_EQ(names_in(scratch.path()), (Names{ ".other.partial-1", "paper" }));
}

TEST(ResultsFolder, TakesAnEmptyFolder)
{
  const ScratchFolder scratch;
  std::filesystem::create_directory(scratch / "empty");
  publish(scratch / "empty", "new");
  EXPECT_EQ(read_text(scratch / "empty/mark"), "new");
}

TEST(ResultsFolder, RefusesPlacesThatCannotBeWritten)
{
  const ScratchFolder scratch;
  scratch.write("file", "");
  EXPECT_THROW(ResultsFolder(scratch / "file/results"), OutputFailure);
  EXPECT_THROW(ResultsFolder("/proc/stemware"), OutputFailure);
  EXPECT_EQ(names_in(scratch.path()), Names{ "file" });
}

TEST(ResultsFolder, TellsWhenAFileCannotBeWritten)
{
  EXPECT_THROW(write_text_file("/dev/full", "text"), OutputFailure);
  EXPECT_THROW(write_text_file("/proc/stemware", "text"), OutputFailure);
}

} // namespace
} // namespace stemware::pipeline
