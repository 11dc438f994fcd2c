#include "fem/pipeline/analysis/sweep/sweep_folder.h"
#include "fem/pipeline/support/failures.h"
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

namespace stemware::pipeline
{
namespace
{

namespace fs = std::filesystem;
using test::names_in;
using test::read_text;
using test::ScratchFolder;
using Json = nlohmann::ordered_json;
using Names = std::vector<std::string>;

const Json one_sweep = { { "program", "1" }, { "files", Json::object() }, { "cases", 3 } };
const Json another_sweep = { { "program", "1" }, { "files", Json::object() }, { "cases", 4 } };

CaseResult failed_case()
{
  CaseResult result;
  result.message = "why it failed";
  return result;
}

/// Finishes one case of a sweep into `results`, and is interrupted.
void leave_one_case(const ScratchFolder &scratch)
{
  const SweepFolder folder(scratch / "results", one_sweep, false);
  CaseLog(SweepFolder::log_of(folder.path(), 0)).append(1, failed_case());
}

/// Sentence with which a sweep into `results` is refused; empty when it is not.
std::string refusal(const ScratchFolder &scratch, const Json &sweep = one_sweep, bool restart = false)
{
  try
  {
    const SweepFolder folder(scratch / "results", sweep, restart);
    return "";
  }
  catch (const OutputFailure &failure)
  {
    return failure.what();
  }
}

TEST(SweepFolder, KeepsFinishedCasesForTheSameSweep)
{
  const ScratchFolder scratch;
  leave_one_case(scratch);
  {
    SweepFolder again(scratch / "results", one_sweep, false);
    EXPECT_EQ(finished_cases(again.path()).count(1), 1u);
    EXPECT_NE(refusal(scratch).find("Another sweep is computing into"), std::string::npos);
  }
  EXPECT_NE(refusal(scratch, another_sweep).find("keeps 1 finished cases of another sweep"),
            std::string::npos);
  EXPECT_EQ(finished_cases(SweepFolder(scratch / "results", one_sweep, false).path()).size(), 1u);
  EXPECT_EQ(refusal(scratch, another_sweep, true), ""); // --restart
  EXPECT_EQ(names_in(scratch.path()), Names{});         // nothing was finished
}

TEST(SweepFolder, IsRemovedWithWhatItHolds)
{
  const ScratchFolder scratch;
  leave_one_case(scratch);
  EXPECT_EQ(names_in(scratch.path()), Names{ ".results.sweep" });
  SweepFolder(scratch / "results", one_sweep, false).remove();
  EXPECT_EQ(names_in(scratch.path()), Names{});
}

// What a program leaves that is killed while it writes the plan, the first one or another.
TEST(SweepFolder, TakesAnUnfinishedPlanForItsOwn)
{
  const char *unfinished = ".results.sweep/.plan.json.partial-4711-0123456789abcdef";
  const ScratchFolder fresh;
  fs::create_directory(fresh / ".results.sweep");
  fresh.write(unfinished, "{ \"what");
  EXPECT_EQ(refusal(fresh), "");
  EXPECT_EQ(names_in(fresh.path()), Names{});
  const ScratchFolder scratch;
  leave_one_case(scratch);
  scratch.write(unfinished, "{ \"what");
  EXPECT_EQ(finished_cases(SweepFolder(scratch / "results", one_sweep, false).path()).count(1), 1u);
  EXPECT_EQ(names_in(scratch / ".results.sweep"), (Names{ "cases-0.jsonl", "plan.json" }));
}

TEST(SweepFolder, IsNeverEnteredThroughALink)
{
  const ScratchFolder scratch, victim;
  victim.write("keep.txt", "precious");
  fs::create_directory(victim / "folder");
  fs::create_directory_symlink(victim.path(), scratch / ".results.sweep");
  for (const bool restart : { false, true })
    EXPECT_NE(refusal(scratch, one_sweep, restart).find("is not a folder of its own"), std::string::npos);
  // Not even one that leads to the cases of the same sweep.
  const ScratchFolder other;
  leave_one_case(other);
  fs::remove(scratch / ".results.sweep");
  fs::create_directory_symlink(other / ".results.sweep", scratch / ".results.sweep");
  EXPECT_NE(refusal(scratch, one_sweep, true).find("is not a folder of its own"), std::string::npos);
  EXPECT_EQ(names_in(victim.path()), (Names{ "folder", "keep.txt" }));
  EXPECT_EQ(names_in(other / ".results.sweep"), (Names{ "cases-0.jsonl", "plan.json" }));
}

TEST(SweepFolder, LeavesAUsersFilesAlone)
{
  for (const char *name : { "keep.txt", "plan.json", "cases-0.jsonl" })
  {
    const ScratchFolder scratch;
    fs::create_directory(scratch / ".results.sweep");
    scratch.write(std::string(".results.sweep/") + name, "precious");
    for (const bool restart : { false, true })
      EXPECT_NE(refusal(scratch, one_sweep, restart).find(std::string("holds ") + name), std::string::npos)
        << refusal(scratch);
    EXPECT_EQ(read_text(scratch / ".results.sweep" / name), "precious");
  }
  const ScratchFolder scratch;
  scratch.write(".results.sweep", "precious");
  EXPECT_NE(refusal(scratch, one_sweep, true).find("is not a folder of its own"), std::string::npos);
  EXPECT_EQ(read_text(scratch / ".results.sweep"), "precious");
}

TEST(SweepFolder, LeavesAUsersFilesBesideFinishedCasesAlone)
{
  const ScratchFolder scratch;
  leave_one_case(scratch);
  const auto files = test::all_files(scratch.path());
  scratch.write(".results.sweep/keep.txt", "precious");
  for (const bool restart : { false, true })
    EXPECT_NE(refusal(scratch, one_sweep, restart).find("holds keep.txt, which is not one of its files"),
              std::string::npos);
  fs::remove(scratch / ".results.sweep/keep.txt");
  scratch.write("elsewhere", "precious");
  fs::create_symlink("../elsewhere", scratch / ".results.sweep/cases-1.jsonl");
  EXPECT_NE(refusal(scratch, one_sweep, true).find("holds cases-1.jsonl"), std::string::npos);
  EXPECT_EQ(read_text(scratch / "elsewhere"), "precious");
  fs::remove(scratch / ".results.sweep/cases-1.jsonl");
  fs::remove(scratch / "elsewhere");
  EXPECT_EQ(test::all_files(scratch.path()), files);

  // Put there while the sweep ran: the folder stays, with it alone.
  {
    SweepFolder folder(scratch / "results", one_sweep, false);
    scratch.write(".results.sweep/keep.txt", "precious");
    folder.remove();
  }
  EXPECT_EQ(names_in(scratch / ".results.sweep"), Names{ "keep.txt" });
}

} // namespace
} // namespace stemware::pipeline
