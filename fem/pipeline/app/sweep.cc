#include "fem/pipeline/analysis/sweep/sweep_case.h"
#include "fem/pipeline/analysis/sweep/sweep_findings.h"
#include "fem/pipeline/analysis/sweep/sweep_folder.h"
#include "fem/pipeline/analysis/sweep/sweep_plan.h"
#include "fem/pipeline/app/options.h"
#include "fem/pipeline/report/publish.h"
#include "fem/pipeline/report/sweep_results.h"
#include "fem/pipeline/study/study_checks.h"
#include "fem/pipeline/support/console.h"
#include "fem/pipeline/support/interruption.h"
#include "fem/pipeline/support/numbers.h"
#include "fem/pipeline/support/ranks.h"
#include "fem/pipeline/support/text.h"

#include <CLI/CLI.hpp>

#include <fmt/format.h>
#include <functional>
#include <memory>
#include <ostream>

namespace stemware::pipeline
{

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace
{

/// Options of `stemware sweep`.
struct SweepOptions : StudyOptions
{
  SweepRequest request;
  bool restart = false; ///< throws away the finished cases of an earlier sweep into the same place
};

/// Message of an interrupted sweep: how many cases are kept, and how to go on.
std::string interruption_message(const fs::path &folder, std::size_t n_cases)
{
  const std::size_t n_kept = LogCounter(folder).count().n_finished;
  if (n_kept == 0)
    return "interrupted; no results were written.";
  return fmt::format(
    FMT_STRING("interrupted; {} of {} cases are kept in {}, and the same command goes on from there."),
    n_kept, n_cases, folder.string());
}

/// Numbers of the cases that are not among those.
Json unfinished(const FinishedCases &finished, std::size_t n_cases)
{
  Json numbers = Json::array();
  for (std::size_t index = 0; index < n_cases; ++index)
    if (finished.count(index) == 0)
      numbers.push_back(index);
  return numbers;
}

/// The folder of finished cases as all ranks see it; the first one owns it.
class SharedCases
{
  std::shared_ptr<SweepFolder> owned; // before what is read from it

public:
  SharedCases(const SweepOptions &options, const SweepPlan &plan)
      : path(from_first_rank(
          [&]
          {
            const PostponedInterruption postponed;
            owned =
              std::make_shared<SweepFolder>(options.results_place(), identity_of(plan), options.restart);
            postponed->clean_up = [folder = owned] { folder->remove_if_empty(); };
            postponed->sentence = [folder = owned->path(), n_cases = plan.cases.size()]
            { return interruption_message(folder, n_cases); };
            return owned->path().string();
          }))
  {
    // Told by the first rank: the others may be late, and see cases that are finished after this.
    const std::string numbers =
      from_first_rank([&] { return unfinished(owned->finished_cases(), plan.cases.size()).dump(); });
    to_do = Json::parse(numbers).get<std::vector<std::size_t>>();
    n_before = plan.cases.size() - to_do.size();
  }

  /// All cases, on the first rank; nothing on the others.
  FinishedCases all() const { return owned ? owned->finished_cases() : FinishedCases(); }

  /// Removes the folder of the cases; to be called when the results are whole.
  void remove()
  {
    const PostponedInterruption postponed;
    postponed->sentence = {};
    if (owned)
      owned->remove();
  }

  const fs::path path;
  std::vector<std::size_t> to_do; ///< cases that are not finished yet
  std::size_t n_before = 0;       ///< cases that were finished by an earlier run
};

/// Every n_ranks()-th case: neighbours on a grid take about equally long, so that each rank gets its share of
/// the long ones.
std::vector<std::size_t> share_of_this_rank(const std::vector<std::size_t> &indices)
{
  std::vector<std::size_t> share;
  for (std::size_t i = this_rank(); i < indices.size(); i += n_ranks())
    share.push_back(indices[i]);
  return share;
}

/// Shows on the first rank how far all of them have come.
class SweepWatch
{
public:
  SweepWatch(const SharedCases &cases, std::size_t n_cases)
      : logs(cases.path)
      , progress(n_cases, cases.n_before)
  {
  }

  void operator()()
  {
    if (!is_first_rank())
      return;
    const CaseCount &cases = logs.count();
    progress.show(cases.n_finished, cases.n_failed);
  }

private:
  LogCounter logs;
  WorkProgress progress;
};

/// Cases that each rank solves by itself, and cases for all ranks together.
std::pair<std::vector<std::size_t>, std::vector<std::size_t>> split(const SweepPlan &plan,
                                                                    const std::vector<std::size_t> &indices)
{
  std::pair<std::vector<std::size_t>, std::vector<std::size_t>> parts;
  for (const std::size_t index : indices)
    (needs_all_ranks(plan, index) ? parts.second : parts.first).push_back(index);
  return parts;
}

void solve(const SweepPlan &plan, const SharedCases &cases, unsigned int n_threads)
{
  const auto [for_one, for_all] = split(plan, cases.to_do);
  const std::vector<std::size_t> share = share_of_this_rank(for_one);
  CaseLog log(SweepFolder::log_of(cases.path, this_rank()));
  SweepWatch watch(cases, plan.cases.size());
  on_every_rank([&] { solve_cases(plan, share, n_threads, false, log, std::ref(watch)); });
  solve_cases(plan, for_all, n_threads, true, log, std::ref(watch));
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
  plan.base = begin_study(options, true);
  on_first_rank([&] { require_replaceable(options.results_place()); });
  SharedCases cases(options, plan);
  const unsigned int n_threads = n_threads_of(options);
  console() << "Sweep     " << plan.cases.size() << " cases, " << n_threads * n_ranks() << " at a time\n";
  if (cases.n_before > 0)
    console() << "          " << cases.n_before << " of them are kept from an interrupted run" << std::endl;
  note_strange_cases(plan);
  stopwatch.finish("input");

  // 2. The cases.
  solve(plan, cases, n_threads);
  stopwatch.finish("cases");

  // 3. The results, all at once.
  ResultsFolder folder(options.results_place());
  const FinishedCases finished = reported(cases.all());
  const SweepFindings found = find_out(plan, finished);
  const Results results = is_first_rank() ? tabulate(plan, finished, found) : Results();
  publish(options, plan.base, results, folder, stopwatch);
  cases.remove();
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
