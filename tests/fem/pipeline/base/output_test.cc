#include "fem/pipeline/base/failures.h"
#include "fem/pipeline/base/output.h"
#include "fem/pipeline/base/text_file.h"
#include "tests/fem/pipeline/matchers.h"
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

#include <functional>
#include <sys/stat.h>

namespace stemware::pipeline
{
namespace
{

namespace fs = std::filesystem;
using test::names_in;
using test::read_text;
using test::ScratchFolder;
using Names = std::vector<std::string>;

void write_results(const fs::path &folder, const std::string &mark)
{
  write_text_file(folder / "summary.json", mark);
  fs::create_directory(folder / "fields");
  write_text_file(folder / "fields/contact.vtu", "a field of " + mark);
}

void publish(const fs::path &target, const std::string &mark)
{
  ResultsFolder folder(target);
  folder.open();
  write_results(folder.working_folder(), mark);
  folder.publish();
}

/// Returns the message that refuses @p target before the computation; empty if @p target is accepted.
std::string refusal_of_folder(const fs::path &target)
{
  try
  {
    const ResultsFolder folder(target);
    return "";
  }
  catch (const OutputFailure &failure)
  {
    return failure.what();
  }
}

void expect_sentence(const std::string &sentence, const std::string &part)
{
  EXPECT_THAT(sentence, testing::HasSubstr(part));
  EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
}

TEST(ResultsFolder, IsPublishedCompletelyOrNotAtAll)
{
  const ScratchFolder scratch;
  {
    ResultsFolder folder(scratch / "results/paper");
    EXPECT_EQ(names_in(scratch / "results"), Names{});
    folder.open();
    write_results(folder.working_folder(), "new");
    EXPECT_FALSE(fs::exists(scratch / "results/paper"));
    folder.publish();
  }
  EXPECT_EQ(names_in(scratch / "results"), Names{ "paper" });
  EXPECT_EQ(names_in(scratch / "results/paper"), (Names{ "fields", "summary.json" }));
  EXPECT_EQ(read_text(scratch / "results/paper/.stemware"), "fields\nfields/contact.vtu\nsummary.json\n");
  {
    ResultsFolder failed(scratch / "results/other");
    failed.open();
    write_results(failed.working_folder(), "lost");
  }
  EXPECT_EQ(names_in(scratch / "results"), Names{ "paper" });
}

TEST(ResultsFolder, ReplacesItsOwnFilesAndKeepsHiddenFiles)
{
  const ScratchFolder scratch;
  fs::create_directory(scratch / "paper");
  scratch.write("paper/.DS_Store", "seen before the first run");
  {
    ResultsFolder folder(scratch / "paper");
    folder.open();
    write_results(folder.working_folder(), "old");
    write_text_file(folder.working_folder() / "without.csv", "not written again");
    folder.publish();
  }
  for (const char *name :
       { "Thumbs.db", "desktop.ini", ".nfs000012", ".~lock.load.csv#", "fields/.DS_Store" })
    scratch.write(std::string("paper/") + name, name);
  fs::create_directory(scratch / "paper/.ipynb_checkpoints");
  scratch.write("paper/.ipynb_checkpoints/note", "mine");
  ResultsFolder folder(scratch / "paper");
  folder.open();
  write_text_file(folder.working_folder() / "summary.json", "new"); // the new results have no folder fields
  folder.publish();
  EXPECT_EQ(read_text(scratch / "paper/summary.json"), "new");
  EXPECT_EQ(names_in(scratch / "paper"),
            (Names{ ".DS_Store", ".ipynb_checkpoints", ".nfs000012", ".~lock.load.csv#", "Thumbs.db",
                    "desktop.ini", "fields", "summary.json" }));
  EXPECT_EQ(names_in(scratch / "paper/fields"), Names{ ".DS_Store" });
  EXPECT_EQ(read_text(scratch / "paper/.ipynb_checkpoints/note"), "mine");
  EXPECT_EQ(names_in(scratch.path()), Names{ "paper" });
  // `fields/` contains hidden files only, but .stemware still lists `fields/`, so the results can be replaced
  // again.
  publish(scratch / "paper", "newest");
}

TEST(ResultsFolder, RefusesOnlyNamesThatAreTooLongForThePartialFolder)
{
  const ScratchFolder scratch;
  const std::size_t longest = 255 - std::string(".partial-" + std::to_string(::getpid())).size();
  publish(scratch / std::string(longest, 'n'), "old");
  publish(scratch / std::string(longest, 'n'), "new");
  EXPECT_EQ(read_text(scratch / std::string(longest, 'n') / "summary.json"), "new");
  expect_sentence(refusal_of_folder(scratch / std::string(longest + 1, 'n')), "File name too long");
  EXPECT_EQ(names_in(scratch.path()), Names{ std::string(longest, 'n') });
}

struct Change
{
  std::string name;
  std::function<void(const ScratchFolder &)> make; ///< changes the results folder "paper"
  std::string reason;
};

class ChangedResults : public testing::TestWithParam<Change>
{
};

TEST_P(ChangedResults, AreNotOverwrittenAndTheNewResultsAreKept)
{
  const ScratchFolder scratch;
  scratch.write("elsewhere", "years of work");
  publish(scratch / "paper", "old");
  ResultsFolder folder(scratch / "paper"); // accepted, because the folder is unchanged
  folder.open();
  write_results(folder.working_folder(), "new");
  GetParam().make(scratch);
  const auto before = test::all_files(scratch / "paper");
  expect_sentence(refusal_of_folder(scratch / "paper"), GetParam().reason);
  try
  {
    folder.publish();
    ADD_FAILURE();
  }
  catch (const OutputFailure &failure) // the message names the folder with the new results
  {
    expect_sentence(failure.what(), folder.final_folder().string() + ".partial-");
  }
  EXPECT_EQ(test::all_files(scratch / "paper"), before);
  EXPECT_EQ(read_text(scratch / "elsewhere"), "years of work");
  const std::string partial = "paper.partial-" + std::to_string(::getpid());
  EXPECT_EQ(read_text(scratch / (partial + "/summary.json")), "new");
}

INSTANTIATE_TEST_SUITE_P(
  Kinds, ChangedResults,
  testing::Values(
    Change{ "note", [](const auto &s) { s.write("paper/note.txt", "mine"); }, "holds note.txt, which" },
    Change{ "own_field", [](const auto &s) { s.write("paper/fields/note.vtu", "mine"); },
            "holds fields/note.vtu, which Stemware did not write" },
    Change{ "quotes_and_lines", [](const auto &s) { s.write("paper/it's \"mine\"\n`x`", "mine"); },
            "holds it's \"mine\" `x`, which" },
    Change{ "folder", [](const auto &s) { fs::create_directory(s / "paper/mine"); }, "holds mine, which" },
    Change{ "folder_named_as_a_file",
            [](const auto &s)
            {
              fs::remove(s / "paper/summary.json");
              fs::create_directory(s / "paper/summary.json");
            },
            "holds summary.json, which" },
    Change{ "no_stamp",
            [](const auto &s)
            {
              fs::remove_all(s / "paper");
              fs::create_directory(s / "paper");
              s.write("paper/load.csv", "measured by hand");
            },
            "holds load.csv, which" },
    Change{ "link_for_a_file",
            [](const auto &s)
            {
              fs::remove(s / "paper/summary.json");
              fs::create_symlink("../elsewhere", s / "paper/summary.json");
            },
            "holds summary.json, which" },
    Change{ "link_for_a_folder",
            [](const auto &s)
            {
              fs::rename(s / "paper/fields", s / "moved");
              fs::create_directory_symlink("../moved", s / "paper/fields");
            },
            "holds fields, which" }),
  [](const auto &info) { return info.param.name; });

TEST(ResultsFolder, RefusesInvalidFoldersAndAcceptsALinkedParent)
{
  const ScratchFolder scratch;
  scratch.write("file", "mine");
  fs::create_directory(scratch / "folder");
  fs::create_symlink("nowhere", scratch / "to_nothing");
  fs::create_symlink("loop", scratch / "loop");
  fs::create_directory_symlink("folder", scratch / "to_folder");
  ASSERT_EQ(::mkfifo((scratch / "pipe").c_str(), 0600), 0);
  const auto before = names_in(scratch.path());
  for (const auto &[place, reason] :
       { std::pair("file", "is not a folder"), std::pair("pipe", "is not a folder"),
         std::pair("to_nothing", "is not a folder"), std::pair("loop", "is not a folder"),
         std::pair("to_folder/", "is not a folder"), std::pair("file/results", "cannot be written"),
         std::pair("loop/results", "cannot be written") })
    expect_sentence(refusal_of_folder(scratch / place), reason);
  expect_sentence(refusal_of_folder("/proc/stemware"), "cannot be written");
  expect_sentence(refusal_of_folder("/dev"), "Stemware did not write");
  expect_sentence(refusal_of_folder("/"), "contains the folder where the program was started");
  expect_sentence(refusal_of_folder("."), "contains the folder where the program was started");
  EXPECT_EQ(names_in(scratch.path()), before);
  // The parent of a results folder may be a link.
  publish(scratch / "to_folder/it's \"odd\"\n$(x)", "new");
  EXPECT_EQ(names_in(scratch / "folder"), Names{ "it's \"odd\"\n$(x)" });
}

TEST(ResultsFolder, KeepsPartialFoldersOfOtherRuns)
{
  const ScratchFolder scratch;
  const std::string own =
    "paper.partial-" + std::to_string(::getpid()); // folder of an older process with the same id
  fs::create_directory(scratch / own);
  scratch.write(own + "/load.csv", "half");
  publish(scratch / "paper", "new");
  EXPECT_EQ(names_in(scratch.path()), (Names{ "paper", own }));
  EXPECT_EQ(names_in(scratch / own), Names{ "load.csv" });
}

TEST(ResultsFolder, TheRunThatPublishesLastReplacesTheOther)
{
  const ScratchFolder scratch;
  ResultsFolder one(scratch / "paper"), two(scratch / "paper");
  one.open();
  two.open();
  write_results(one.working_folder(), "one");
  write_results(two.working_folder(), "two");
  one.publish();
  two.publish();
  EXPECT_EQ(read_text(scratch / "paper/summary.json"), "two");
  EXPECT_EQ(names_in(scratch.path()), Names{ "paper" });
}

TEST(OutputFile, ReplacesOnlyFilesWrittenByStemware)
{
  const ScratchFolder scratch;
  const std::string page = std::string("<!-- ") + written_by_stemware + " -->\n";
  write_output_file(scratch / "page.html", page);
  write_output_file(scratch / "page.html", page + "newer");
  EXPECT_EQ(read_text(scratch / "page.html"), page + "newer");

  scratch.write("mine.html", "years of work");
  fs::create_directory(scratch / "folder");
  fs::create_symlink("page.html", scratch / "link");
  fs::create_symlink("nowhere", scratch / "to_nothing");
  fs::create_symlink("loop", scratch / "loop");
  ASSERT_EQ(::mkfifo((scratch / "pipe").c_str(), 0600), 0);
  const auto before = names_in(scratch.path());
  for (const char *name : { "mine.html", "folder", "link", "to_nothing", "loop", "pipe", "no/folder",
                            "mine.html/page", "loop/page", "/", ".", "/proc/page", "" })
  {
    SCOPED_TRACE(name);
    const fs::path file = std::string(name).size() > 1 ? scratch / name : fs::path(name);
    EXPECT_THROW(require_writable(file), OutputFailure);
    EXPECT_THROW(write_output_file(file, page), OutputFailure);
  }
  EXPECT_EQ(names_in(scratch.path()), before);
  EXPECT_EQ(read_text(scratch / "mine.html"), "years of work");
  EXPECT_EQ(read_text(scratch / "page.html"), page + "newer");
}

TEST(TextFile, ThrowsIfItCannotBeWritten)
{
  EXPECT_THROW(write_text_file("/dev/full", "text"), OutputFailure);
  EXPECT_THROW(write_text_file("/proc/stemware", "text"), OutputFailure);
}

} // namespace
} // namespace stemware::pipeline
