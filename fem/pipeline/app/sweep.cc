#include "fem/pipeline/analysis/sweep/sweep_case.h"
#include "fem/pipeline/analysis/sweep/sweep_findings.h"
#include "fem/pipeline/analysis/sweep/sweep_folder.h"
#include "fem/pipeline/analysis/sweep/sweep_plan.h"
#include "fem/pipeline/app/options.h"
#include "fem/pipeline/report/publish.h"
#include "fem/pipeline/report/sweep_results.h"
#include "fem/pipeline/study/study_checks.h"
#include "fem/pipeline/support/console.h"
#include "fem/pipeline/support/numbers.h"
#include "fem/pipeline/support/ranks.h"
#include "fem/pipeline/support/text.h"

#include <CLI/CLI.hpp>

#include <fmt/format.h>
#include <memory>
#include <ostream>

namespace stemware::pipeline
{

namespace fs = std::filesystem;

namespace
{

/// Options of `stemware sweep`.
struct SweepOptions : StudyOptions
{
  SweepRequest request;
  bool restart = false; ///< throws away the finished cases of an earlier sweep into the same place
};

/// Takes the folder of finished cases, on the first rank, which owns it: nothing on the others.
std::shared_ptr<SweepFolder> take_folder(const SweepOptions &options, const SweepPlan &plan)
{
  std::shared_ptr<SweepFolder> folder;
  on_first_rank(
    [&]
    { folder = std::make_shared<SweepFolder>(options.results_place(), identity_of(plan), options.restart); });
  return folder;
}

/// Solves the cases that are not @p finished, and shows on the first rank how far all of them have come.
void solve(const SweepPlan &plan, const FinishedCases &finished, const fs::path &folder,
           unsigned int n_threads)
{
  CaseLog log(SweepFolder::log_of(folder, this_rank()));
  LogCounter logs(folder);
  WorkProgress progress(plan.cases.size(), finished.size());
  const auto watch = [&]
  {
    if (!is_first_rank())
      return;
    const CaseCount &cases = logs.count();
    progress.show(cases.n_finished, cases.n_failed);
  };
  solve_cases(plan, finished, n_threads, log, watch);
}

/// A sweep without a single answer has failed.
void require_one_solved(const FinishedCases &cases, const SweepFindings &findings)
{
  const std::string trouble = from_first_rank(
    [&] { return findings.n_failed < findings.n_cases ? "" : cases.at(*findings.first_failure).message; });
  if (!trouble.empty())
    throw std::runtime_error(
      fmt::format(FMT_STRING("All {} cases failed, the first one because: {}"), findings.n_cases, trouble));
}

/// Names values of the cases that no glass has: the first of each entry.
void note_strange_cases(const SweepPlan &plan)
{
  for (std::size_t i = 0; i < plan.entries.size(); ++i)
    for (const std::vector<std::string> &values : plan.cases)
    {
      const auto number = plan.entries[i].unit.empty() ? std::nullopt : parse_number(values[i]);
      const std::string note = number ? implausible_note(plan.entries[i].path, *number) : "";
      if (note.empty())
        continue;
      console() << wrapped(note, "Check     ") << std::endl;
      break;
    }
}

/// Solves the cases of a sweep, from the study's file to the folder of its results, and goes on where the
/// same sweep was interrupted. Collective over all ranks, which share the cases. Throws BadInput,
/// OutputFailure, and std::runtime_error when not a single case could be solved.
void sweep(const SweepOptions &options)
{
  // 1. What is asked for; everything that can be refused is refused here.
  Stopwatch stopwatch;
  SweepPlan plan = make_plan(options.request);
  plan.base = begin_study(options);
  on_first_rank([&] { require_replaceable(resolved_output(options.results_place())); });
  const std::shared_ptr<SweepFolder> owned = take_folder(options, plan);
  const fs::path cases = from_first_rank([&] { return owned->path().string(); });
  FinishedCases finished;
  on_every_rank([&] { finished = finished_cases(cases); }); // before any of them goes on
  const unsigned int n_threads = n_threads_of(options);
  console() << "Sweep     " << plan.cases.size() << " cases, " << n_threads * n_ranks() << " at a time\n";
  if (!finished.empty())
    console() << "          " << finished.size() << " of them are kept from an interrupted run" << std::endl;
  note_strange_cases(plan);
  stopwatch.finish("input");

  // 2. The cases.
  solve(plan, finished, cases, n_threads);
  stopwatch.finish("cases");

  // 3. The results, all at once.
  ResultsFolder folder(options.results_place());
  if (owned)
    finished = reported(finished_cases(cases));
  const SweepFindings found = find_out(plan, finished);
  const Results results = is_first_rank() ? tabulate(plan, finished, found) : Results();
  publish(options, plan.base, results, folder, stopwatch);
  if (owned)
    owned->remove();
  require_one_solved(finished, found);
}

} // namespace

void add_sweep_verb(CLI::App &program, Verb &chosen)
{
  const auto [verb, options] = add_study_verb(
    program, chosen, "sweep", "Compute a study many times: entries over a range, or random samples", sweep);
  SweepRequest &request = options->request;
  verb->add_option("--vary", request.varied, "Values of one entry: a range or a list; at most twice")
    ->type_name("\"Section/Entry=values\"")
    ->allow_extra_args(false);
  verb->add_option("--random", request.random, "Spread of one entry; may be repeated")
    ->type_name("\"Section/Entry=spread\"")
    ->allow_extra_args(false);
  verb->add_option("--samples", request.n_samples, "Number of random samples; default: 200")->type_name("N");
  verb->add_option("--seed", request.seed, "Which random samples; default: 1")->type_name("S");
  verb
    ->add_option("--most-cases", request.most_cases,
                 "Refuses a sweep of more cases, before the work; default: 10000")
    ->type_name("N");
  verb->add_flag("--restart", options->restart, "Throws away the cases kept from an interrupted sweep");
}

} // namespace stemware::pipeline
