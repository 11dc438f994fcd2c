// Finished cases outlive the program, to the last digit; half-written ones do not.
#include "fem/pipeline/analysis/sweep/sweep_folder.h"
#include "fem/pipeline/support/failures.h"
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

namespace stemware::pipeline
{
namespace
{

namespace fs = std::filesystem;
using test::ScratchFolder;

CaseResult solved(double value)
{
  CaseResult result;
  result.outcome = "converged";
  result.values.assign(sweep_quantities().size(), value);
  result.values.back() = std::nullopt;
  return result;
}

CaseResult tipped(const std::string &message)
{
  CaseResult result;
  result.outcome = "tipping";
  result.message = message;
  return result;
}

TEST(CaseLog, GivesBackEveryDigit)
{
  const ScratchFolder scratch;
  const std::vector<double> numbers = { 0.1, 1. / 3, -6.02214076e23, 5e-324, 1e308, std::nextafter(1., 2.) };
  {
    CaseLog log(scratch / "cases.jsonl");
    for (std::size_t i = 0; i < numbers.size(); ++i)
      log.append(10 - i, solved(numbers[i]));
    log.append(0, tipped("a \"message\", with commas\nand lines, größer"));
  }
  const FinishedCases cases = recover_cases(scratch / "cases.jsonl");
  ASSERT_EQ(cases.size(), numbers.size() + 1);
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    EXPECT_EQ(cases.at(10 - i).values, solved(numbers[i]).values);
    EXPECT_EQ(cases.at(10 - i).outcome, "converged");
    EXPECT_TRUE(cases.at(10 - i).is_solved());
  }
  EXPECT_FALSE(cases.at(0).is_solved());
  EXPECT_EQ(cases.at(0).message, "a \"message\", with commas\nand lines, größer");
  EXPECT_EQ(cases.at(0).outcome, "tipping");
}

TEST(CaseLog, AHalfWrittenLineIsCutOffWhereverItEnds)
{
  const ScratchFolder scratch;
  const fs::path file = scratch / "cases.jsonl";
  {
    CaseLog log(file);
    log.append(0, solved(1));
    log.append(1, solved(2));
  }
  const std::string whole = test::read_text(file);
  const std::size_t first_line = whole.find('\n') + 1;
  for (std::size_t length = first_line; length < whole.size(); length += 7)
  {
    scratch.write("cases.jsonl", whole.substr(0, length));
    EXPECT_EQ(recover_cases(file).size(), 1u) << length;
    EXPECT_EQ(fs::file_size(file), first_line) << length;
    CaseLog(file).append(1, solved(2));
    EXPECT_EQ(test::read_text(file), whole) << length;
  }
}

TEST(CaseLog, WhatAPowerCutLeavesIsCutOff)
{
  const ScratchFolder scratch;
  const fs::path file = scratch / "cases.jsonl";
  CaseLog(file).append(3, solved(1));
  const std::string whole = test::read_text(file);
  for (const std::string &rest :
       { std::string(5, '\0') + "\n", std::string("{\"case\":4}\n"), std::string("[]\n"), std::string("\n"),
         std::string("{\"case\":4,\"outcome\":\"\",\"message\":\"\","
                     "\"values\":[1,2]}\n") })
  {
    scratch.write("cases.jsonl", whole + rest + whole);
    EXPECT_EQ(recover_cases(file).size(), 1u) << rest;
    EXPECT_EQ(test::read_text(file), whole) << rest;
  }
  EXPECT_TRUE(recover_cases(scratch / "nothing.jsonl").empty());
}

TEST(CaseLog, CasesAreCountedAsTheyCome)
{
  const ScratchFolder scratch;
  const fs::path file = SweepFolder::log_of(scratch.path(), 0);
  LogCounter counter(scratch.path());
  EXPECT_EQ(counter.count().n_finished, 0u);
  CaseLog log(file);
  log.append(0, solved(1));
  EXPECT_EQ(counter.count().n_finished, 1u);
  EXPECT_EQ(counter.count().n_finished, 1u);
  log.append(1, solved(1));
  log.append(2, tipped("the text \"message\":\"\", itself"));
  std::ofstream(file, std::ios::app) << "{\"case\":3,\"outcome\":\"";
  EXPECT_EQ(counter.count().n_finished, 3u);
  EXPECT_EQ(counter.count().n_failed, 1u);
}

TEST(SweepFolder, KeepsCasesForTheSameSweepOnly)
{
  const ScratchFolder scratch;
  const nlohmann::ordered_json plan = { { "program", "1" }, { "files", "" }, { "sweep", 1 } };
  nlohmann::ordered_json other = plan, newer = plan;
  other["sweep"] = 2;
  newer["program"] = "2";
  {
    const SweepFolder folder(scratch / "results", plan, false);
    CaseLog(SweepFolder::log_of(folder.path(), 0)).append(0, solved(1));
    CaseLog(SweepFolder::log_of(folder.path(), 3)).append(7, solved(2));
  }
  EXPECT_EQ(finished_cases(SweepFolder(scratch / "results", plan, false).path()).size(), 2u);
  for (const auto &[identity, expected] :
       { std::pair(other, "another sweep"), std::pair(newer, "another version") })
    try
    {
      const SweepFolder folder(scratch / "results", identity, false);
      FAIL() << "cases of another sweep were taken over";
    }
    catch (const OutputFailure &refusal)
    {
      const std::string sentence = refusal.what();
      EXPECT_NE(sentence.find("keeps 2 finished cases of"), std::string::npos) << sentence;
      EXPECT_NE(sentence.find(expected), std::string::npos) << sentence;
      EXPECT_NE(sentence.find("--restart"), std::string::npos) << sentence;
    }
  EXPECT_EQ(finished_cases(SweepFolder(scratch / "results", plan, false).path()).size(), 2u);
  EXPECT_TRUE(finished_cases(SweepFolder(scratch / "results", other, true).path()).empty());
  EXPECT_TRUE(test::names_in(scratch.path()).empty()); // nothing finished, nothing kept
}

TEST(SweepFolder, HasOneUserAtATime)
{
  const ScratchFolder scratch;
  const nlohmann::ordered_json plan = { { "program", "1" }, { "files", "" } };
  {
    const SweepFolder folder(scratch / "results", plan, false);
    try
    {
      const SweepFolder second(scratch / "results", plan, true);
      FAIL() << "two sweeps into one place";
    }
    catch (const OutputFailure &refusal)
    {
      EXPECT_NE(std::string(refusal.what()).find("Another sweep is computing into"), std::string::npos)
        << refusal.what();
    }
    EXPECT_TRUE(fs::exists(folder.path()));
    EXPECT_NO_THROW(SweepFolder(scratch / "elsewhere", plan, false));
  }
  EXPECT_NO_THROW(SweepFolder(scratch / "results", plan, false));
}

TEST(SweepFolder, LeavesNoEmptyFoldersBehind)
{
  const ScratchFolder scratch;
  const nlohmann::ordered_json plan = { { "program", "1" }, { "files", "" } };
  {
    SweepFolder folder(scratch / "some/where/results", plan, false);
    EXPECT_TRUE(fs::exists(folder.path()));
  }
  EXPECT_TRUE(test::names_in(scratch.path()).empty());
  {
    SweepFolder folder(scratch / "some/where/results", plan, false);
    CaseLog(SweepFolder::log_of(folder.path(), 0)).append(0, solved(1));
  }
  SweepFolder(scratch / "some/where/results", plan, false).remove();
  EXPECT_TRUE(test::names_in(scratch / "some/where").empty());
}

} // namespace
} // namespace stemware::pipeline
