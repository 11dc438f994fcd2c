#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/folders.h"
#include "fem/pipeline/support/json_text.h"
#include "fem/pipeline/support/results_folder.h"
#include "fem/pipeline/support/text_file.h"
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <functional>
#include <sys/resource.h>
#include <unistd.h>

namespace stemware::pipeline
{
namespace
{

namespace fs = std::filesystem;
using test::names_in;
using test::read_text;
using test::ScratchFolder;
using Names = std::vector<std::string>;

/// Results with a file of their own and one in a folder.
void write_results(const fs::path &folder, const std::string &mark)
{
  write_text_file(folder / "mark", mark);
  fs::create_directory(folder / "figures");
  write_text_file(folder / "figures/load.svg", "a picture of " + mark);
  write_text_file(folder / "timings.json", sealed_text({ { "total", mark.size() } }));
}

void publish(const fs::path &target, const std::string &mark)
{
  ResultsFolder folder(target);
  write_results(folder.working_folder(), mark);
  folder.publish();
}

/// Sentence with which a place is refused for results, before and instead of any work; empty when it is not.
std::string refusal(const fs::path &target)
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

/// Asserts that a place is refused with a sentence that contains @p reason, and that all in it stays what it
/// is.
void expect_refused(const fs::path &target, const std::string &reason)
{
  using Files = std::map<std::string, std::string>;
  const auto files = [&] { return fs::is_directory(target) ? test::all_files(target) : Files(); };
  const Files before = files();
  EXPECT_NE(refusal(target).find(reason), std::string::npos) << refusal(target);
  EXPECT_EQ(files(), before);
}

TEST(ResultsFolder, AppearsOnlyWhenPublished)
{
  const ScratchFolder scratch;
  {
    ResultsFolder folder(scratch / "results/paper");
    EXPECT_TRUE(fs::is_directory(folder.working_folder()));
    EXPECT_FALSE(fs::exists(scratch / "results/paper"));
    write_text_file(folder.working_folder() / "b", "2");
    write_text_file(folder.working_folder() / "a", "1");
    EXPECT_EQ(folder.contents(), (Names{ "a", "b", "manifest.json" }));
    folder.publish();
  }
  EXPECT_EQ(names_in(scratch / "results"), Names{ "paper" });
  EXPECT_EQ(names_in(scratch / "results/paper"), (Names{ "a", "b", "manifest.json" }));
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

TEST(ResultsFolder, LeavesNothingWhenDescriptorsHaveRunOut)
{
  const ScratchFolder scratch;
  rlimit before;
  ASSERT_EQ(::getrlimit(RLIMIT_NOFILE, &before), 0);
  const rlimit few = { 100, before.rlim_max };
  std::vector<int> descriptors;
  {
    const ResultsFolder folder(scratch / "results");
    write_results(folder.working_folder(), "lost");
    ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &few), 0);
    for (int descriptor = 0; (descriptor = ::open("/dev/null", O_RDONLY)) >= 0;)
      descriptors.push_back(descriptor);
  }
  for (const int descriptor : descriptors)
    ::close(descriptor);
  ::setrlimit(RLIMIT_NOFILE, &before);
  EXPECT_FALSE(descriptors.empty());
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
  publish(scratch / "paper", "newer");
  EXPECT_EQ(read_text(scratch / "paper/mark"), "newer");
  EXPECT_EQ(names_in(scratch.path()), Names{ "paper" });
}

TEST(ResultsFolder, ManifestListsSizesAndCheckSums)
{
  const ScratchFolder scratch;
  publish(scratch / "one", "123456789");
  const auto manifest = nlohmann::json::parse(read_text(scratch / "one/manifest.json"));
  EXPECT_EQ(manifest["program"], "stemware");
  // The check value that the catalogue of CRCs lists for CRC-64/XZ.
  EXPECT_EQ(manifest["files"]["mark"], (nlohmann::json{ { "bytes", 9 }, { "crc64", "995dc9bbdf1939fa" } }));
  EXPECT_TRUE(manifest["files"].contains("figures/load.svg"));
  // Times differ between equal runs, manifests do not.
  {
    ResultsFolder folder(scratch / "two");
    write_results(folder.working_folder(), "123456789");
    write_text_file(folder.working_folder() / "timings.json", sealed_text({ { "total", 0.25 } }));
    folder.publish();
  }
  EXPECT_EQ(read_text(scratch / "two/manifest.json"), read_text(scratch / "one/manifest.json"));
  EXPECT_EQ(refusal(scratch / "two"), "");
}

TEST(ResultsFolder, LeavesOtherPeoplesFilesAlone)
{
  const ScratchFolder scratch;
  fs::create_directory(scratch / "thesis");
  scratch.write("thesis/chapter.tex", "years of work");
  expect_refused(scratch / "thesis", "holds chapter.tex, which is not a result of Stemware");
  scratch.write("file", "");
  expect_refused(scratch / "file", "is not a folder");
  fs::create_symlink("nowhere", scratch / "link");
  expect_refused(scratch / "link", "is not a folder");
  EXPECT_EQ(names_in(scratch.path()), (Names{ "file", "link", "thesis" }));
}

struct Change
{
  std::string name;
  std::function<void(const fs::path &)> make; ///< in a folder of results
  std::string reason;
};

class ChangedResults : public testing::TestWithParam<Change>
{
};

TEST_P(ChangedResults, AreRefusedBeforeTheWorkAndBeforePublishing)
{
  const ScratchFolder scratch;
  scratch.write("elsewhere", "years of work");
  publish(scratch / "paper", "old");
  ResultsFolder folder(scratch / "paper"); // not changed yet
  write_results(folder.working_folder(), "new");

  GetParam().make(scratch / "paper");
  expect_refused(scratch / "paper", GetParam().reason);
  const auto before = test::all_files(scratch / "paper");
  EXPECT_THROW(folder.publish(), OutputFailure);
  EXPECT_EQ(test::all_files(scratch / "paper"), before);
  EXPECT_EQ(read_text(scratch / "elsewhere"), "years of work");
}

INSTANTIATE_TEST_SUITE_P(
  Kinds, ChangedResults,
  testing::Values(Change{ "file", [](const fs::path &p) { write_text_file(p / "note.txt", "mine"); },
                          "holds note.txt, which" },
                  Change{ "file_among_the_figures",
                          [](const fs::path &p) { write_text_file(p / "figures/note.txt", "mine"); },
                          "holds figures/note.txt, which is not a result" },
                  Change{ "folder", [](const fs::path &p) { fs::create_directory(p / "mine"); },
                          "holds mine, which" },
                  Change{ "changed_file", [](const fs::path &p) { write_text_file(p / "mark", "odd"); },
                          "holds mark, which has changed since" },
                  Change{ "changed_times",
                          [](const fs::path &p) { write_text_file(p / "timings.json", "{\"total\": 3}\n"); },
                          "holds timings.json, which has changed since" },
                  Change{ "link_in_place_of_a_file",
                          [](const fs::path &p)
                          {
                            fs::remove(p / "mark");
                            fs::create_symlink("../elsewhere", p / "mark");
                          },
                          "holds mark, which has changed since" },
                  Change{ "link_in_place_of_a_folder",
                          [](const fs::path &p)
                          {
                            fs::rename(p / "figures", p.parent_path() / "moved");
                            fs::create_directory_symlink("../moved", p / "figures");
                          },
                          "holds figures, which" },
                  Change{ "manifest_gone", [](const fs::path &p) { fs::remove(p / "manifest.json"); },
                          "which is not a result of Stemware" },
                  Change{ "manifest_that_lists_names_only",
                          [](const fs::path &p)
                          {
                            write_text_file(
                              p / "manifest.json",
                              R"({"program": "stemware", "files": {"mark": null, "timings.json": {}}})");
                          },
                          "holds figures, which" }),
  [](const auto &info) { return info.param.name; });

TEST(ResultsFolder, ASummaryMakesNoFolderReplaceable)
{
  const ScratchFolder scratch;
  fs::create_directory(scratch / "thesis");
  scratch.write("thesis/thesis.txt", "years of work");
  scratch.write("thesis/summary.json", R"({"schema":1,"files":["thesis.txt","summary.json"]})");
  expect_refused(scratch / "thesis", "which is not a result of Stemware");
  // What version 0.1 wrote: nobody can tell whether a file is as it was.
  scratch.write("thesis/summary.json",
                R"({"schema":1,"program":{"version":"0.1.0"},"files":["thesis.txt","summary.json"]})");
  expect_refused(scratch / "thesis",
                 "which is not a result of Stemware; move it away, or choose another folder "
                 "with --output.");
  EXPECT_EQ(read_text(scratch / "thesis/thesis.txt"), "years of work");
}

TEST(ResultsFolder, AManifestReachesNothingOutside)
{
  const ScratchFolder scratch;
  scratch.write("thesis.txt", "123456789");
  publish(scratch / "paper", "old");
  auto manifest = nlohmann::json::parse(read_text(scratch / "paper/manifest.json"));
  manifest["files"]["../thesis.txt"] = { { "bytes", 9 }, { "crc64", "995dc9bbdf1939fa" } };
  scratch.write("paper/manifest.json", manifest.dump());
  publish(scratch / "paper", "new");
  EXPECT_EQ(read_text(scratch / "thesis.txt"), "123456789");
}

/// What a process that is killed leaves of its work on `paper`.
void leave(const ScratchFolder &scratch, const std::string &name, const std::string &late_file = "")
{
  fs::create_directory(scratch / name);
  write_results(scratch / name, "half");
  write_manifest(scratch / name);
  if (!late_file.empty())
    scratch.write(name + "/" + late_file, "not listed");
}

TEST(ResultsFolder, RemovesWhatKilledProcessesLeft)
{
  const ScratchFolder scratch;
  for (const char *name :
       { ".paper.partial-1", ".paper.partial-2", ".paper.partial-3.replaced", ".other.partial-1" })
    leave(scratch, name);
  {
    const FolderClaim at_work(scratch / ".paper.partial-2");
    EXPECT_TRUE(at_work.held());
    const ResultsFolder folder(scratch / "paper");
    // The older results of a process that was killed in the midst of replacing them exist nowhere else.
    EXPECT_FALSE(fs::exists(scratch / ".paper.partial-1"));
    for (const char *name : { ".paper.partial-2", ".paper.partial-3.replaced", ".other.partial-1" })
      EXPECT_TRUE(fs::exists(scratch / name)) << name;
  }
  publish(scratch / "paper", "new");
  publish(scratch / "paper", "newer");
  EXPECT_EQ(names_in(scratch.path()), (Names{ ".other.partial-1", "paper" }));
}

TEST(ResultsFolder, RemovesNoLeftoverThatMayBeAUsers)
{
  const ScratchFolder scratch, elsewhere;
  leave(scratch, ".paper.partial-1", "note.txt");
  leave(scratch, ".paper.partial-2", "figures/note.svg");
  fs::create_directory(scratch / ".paper.partial-3");
  scratch.write(".paper.partial-3/chapter.tex", "years of work");
  leave(elsewhere, "results");
  fs::create_directory_symlink(elsewhere / "results", scratch / ".paper.partial-4");
  scratch.write(".paper.partial-5", "years of work");
  fs::create_directory(scratch / ".paper.partial-6");
  const auto before = test::all_files(scratch.path()), over_there = test::all_files(elsewhere.path());
  testing::internal::CaptureStdout();
  publish(scratch / "paper", "new");
  // Those that are Stemware's in part are named.
  const std::string said = testing::internal::GetCapturedStdout();
  EXPECT_NE(said.find(".paper.partial-1"), std::string::npos) << said;
  EXPECT_NE(said.find(".paper.partial-2"), std::string::npos) << said;
  EXPECT_EQ(said.find(".paper.partial-3"), std::string::npos) << said;
  publish(scratch / "paper", "newer");
  fs::remove_all(scratch / "paper");
  EXPECT_EQ(test::all_files(scratch.path()), before);
  EXPECT_EQ(test::all_files(elsewhere.path()), over_there);
  EXPECT_TRUE(fs::is_symlink(scratch / ".paper.partial-4"));
  EXPECT_TRUE(fs::exists(scratch / ".paper.partial-6"));
}

TEST(ResultsFolder, IsMadeWhereNothingIs)
{
  const ScratchFolder scratch;
  fs::create_directory_symlink(scratch.path(), scratch / "link");
  EXPECT_THROW(create_new_folder(scratch / "link"), fs::filesystem_error);
  fs::create_directory(scratch / "folder");
  EXPECT_THROW(create_new_folder(scratch / "folder"), fs::filesystem_error);
  EXPECT_FALSE(FolderClaim(scratch / "link").held());
  EXPECT_NE(unique_suffix(), unique_suffix());
}

TEST(ResultsFolder, TakesAnEmptyFolder)
{
  const ScratchFolder scratch;
  fs::create_directory(scratch / "empty");
  publish(scratch / "empty", "new");
  EXPECT_EQ(read_text(scratch / "empty/mark"), "new");
  // Of its own, also where a link says where that is.
  fs::create_directory(scratch / "other");
  fs::create_directory_symlink("other", scratch / "link");
  publish(scratch / "link", "new");
  EXPECT_EQ(read_text(scratch / "other/mark"), "new");
  EXPECT_EQ(names_in(scratch.path()), (Names{ "empty", "link", "other" }));
}

TEST(ResultsFolder, RefusesPlacesThatCannotBeWritten)
{
  const ScratchFolder scratch;
  scratch.write("file", "");
  EXPECT_THROW(ResultsFolder(scratch / "file/results"), OutputFailure);
  EXPECT_THROW(ResultsFolder("/proc/stemware"), OutputFailure);
  EXPECT_EQ(names_in(scratch.path()), Names{ "file" });
}

TEST(TextFile, TellsWhenItCannotBeWritten)
{
  EXPECT_THROW(write_text_file("/dev/full", "text"), OutputFailure);
  EXPECT_THROW(write_text_file("/proc/stemware", "text"), OutputFailure);
}

TEST(TextFile, ReplacesALinkAndNotWhatItPointsTo)
{
  const ScratchFolder scratch;
  scratch.write("thesis.txt", "years of work");
  fs::create_symlink("thesis.txt", scratch / "foot.msh");
  replace_text_file(scratch / "foot.msh", "a mesh");
  EXPECT_EQ(read_text(scratch / "foot.msh"), "a mesh");
  EXPECT_EQ(read_text(scratch / "thesis.txt"), "years of work");
  EXPECT_EQ(names_in(scratch.path()), (Names{ "foot.msh", "thesis.txt" }));
}

} // namespace
} // namespace stemware::pipeline
