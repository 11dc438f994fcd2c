#include "fem/pipeline/analysis/sweep_case.h"
#include "fem/pipeline/app/console_progress.h"
#include "fem/pipeline/app/options.h"
#include "fem/pipeline/base/console.h"
#include "fem/pipeline/base/failures.h"
#include "fem/pipeline/base/numbers.h"
#include "fem/pipeline/base/ranks.h"
#include "fem/pipeline/page/publish.h"
#include "fem/pipeline/result/sweep_file.h"
#include "fem/pipeline/result/verb_results.h"
#include "fem/pipeline/study/study_checks.h"
#include "fem/pipeline/study/study_entries.h"

#include <CLI/CLI.hpp>

#include <fmt/format.h>
#include <ostream>

namespace stemware::pipeline
{

namespace
{

struct SweepOptions : StudyOptions
{
  std::vector<std::string> varied; ///< values of --vary, see cases_of_grid()
  std::string cases;               ///< file of --cases, see cases_from_file()
};

CaseList list_of(const SweepOptions &options)
{
  ensure(options.cases.empty() || options.varied.empty(),
         "--cases and --vary do not go together; write the cases of both into one table.");
  ensure(!options.cases.empty() || !options.varied.empty(),
         "The sweep has no cases; give --cases cases.csv, or --vary \"Section/Entry=first:last:number\".");
  return options.cases.empty() ? cases_of_grid(options.varied) : cases_from_file(options.cases);
}

void note_implausible_cases(const CaseList &list, const StudyOptions &options)
{
  for (std::size_t e = 0; e < list.entries.size(); ++e)
    for (const std::vector<std::string> &values : list.cases)
    {
      const auto number = list.entries[e].unit.empty() ? std::nullopt : parse_number(values[e]);
      const std::string note = number ? implausible_note(find_entry("", list.entries[e].path), *number) : "";
      print_warning("Check     ", note, options);
      if (!note.empty())
        break;
    }
}

void sweep(const SweepOptions &options)
{
  ConsoleProgress progress;
  ensure(n_ranks() == 1,
         "A sweep runs in one process and not under mpirun; docs/sweep.md shows a sweep on many machines "
         "(stemware.solve() in Python).");
  CaseList list = list_of(options);
  list.base = begin_study(options);
  SweepFile file(options.results_place(), list);
  const std::size_t n_cases = list.cases.size(), n_kept = file.finished().size();
  std::vector<std::size_t> wanted;
  for (std::size_t i = 0; i < n_cases; ++i)
    if (file.finished().count(i) == 0)
      wanted.push_back(i);
  const unsigned int n_threads = n_threads_of(options);
  console() << "Sweep     " << n_cases << " cases, " << n_threads << " at a time" << std::endl;
  if (n_kept > 0)
    console() << "          " << n_kept << " of them are in sweep.csv and kept" << std::endl;
  note_implausible_cases(list, options);
  progress.stopwatch.finish("input");

  if (!wanted.empty())
    progress.pieces_done("cases", n_kept, n_cases); // starts the interval before the first line
  std::size_t n_done = n_kept, n_failed = 0;
  solve_cases(list, wanted, n_threads,
              [&](std::size_t index, const CaseResult &result)
              {
                file.append(index, result);
                n_failed += result.status == "failed" ? 1 : 0;
                const std::string failed = fmt::format(FMT_STRING(", {} failed"), n_failed);
                progress.pieces_done("cases" + (n_failed > 0 ? failed : ""), ++n_done, n_cases);
              });
  progress.stopwatch.finish("cases");

  publish_in(options.results_place(), options, sweep_results(list, file.finished()), progress.stopwatch);
  for (const auto &[index, result] : file.finished())
    if (result.status != "failed")
      return;
  throw std::runtime_error(fmt::format(FMT_STRING("All {} cases failed, the first one because: {}"),
                                       file.finished().size(), file.finished().begin()->second.message));
}

} // namespace

void add_sweep_verb(CLI::App &program)
{
  const auto [verb, options] =
    add_study_verb(program, "sweep", "Compute a study many times: a list or a grid of cases", sweep);
  verb->add_option("--cases", options->cases, "Table of cases: a column for each entry, a row for each case")
    ->type_name("FILE");
  verb->add_option("--vary", options->varied, "Values of one entry: a range or a list; at most twice")
    ->type_name("\"Section/Entry=values\"")
    ->allow_extra_args(false);
}

} // namespace stemware::pipeline
