#include "fem/pipeline/answer/case_list.h"
#include "fem/pipeline/answer/sweep_case.h"
#include "fem/pipeline/app/options.h"
#include "fem/pipeline/document/sweep_file.h"
#include "fem/pipeline/page/publish.h"
#include "fem/pipeline/report/sweep_results.h"
#include "fem/pipeline/study/study_checks.h"
#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/numbers.h"
#include "fem/pipeline/support/text.h"
#include "fem/pipeline/system/console.h"
#include "fem/pipeline/system/ranks.h"

#include <CLI/CLI.hpp>

#include <fmt/format.h>
#include <ostream>

namespace stemware::pipeline
{

namespace
{

/// Options of `stemware sweep`.
struct SweepOptions : StudyOptions
{
  std::vector<std::string> varied; ///< --vary, see cases_of_grid()
  std::string cases;               ///< --cases, see cases_from_file()
  std::string rows;                ///< --rows FIRST:LAST, counted from 1; empty: all
};

/// Rows of a list of cases, from 0; the last one is included.
struct RowRange
{
  std::size_t first = 0, last = 0;
};

RowRange rows_of(const SweepOptions &options, std::size_t n_cases)
{
  if (options.rows.empty())
    return { 0, n_cases - 1 };
  const auto colon = std::min(options.rows.find(':'), options.rows.size());
  const auto first = parse_count(options.rows.substr(0, colon)),
             last = colon < options.rows.size() ? parse_count(options.rows.substr(colon + 1)) : first;
  ensure(first && last && 1 <= *first && *first <= *last && *last <= n_cases,
         fmt::format(FMT_STRING("--rows {} is not a part of the {} cases; give the first and the last one, "
                                "--rows 1:{}."),
                     shortened(options.rows), n_cases, n_cases));
  return { *first - 1, *last - 1 };
}

CaseList list_of(const SweepOptions &options)
{
  ensure(options.cases.empty() || options.varied.empty(),
         "--cases and --vary do not go together; write the cases of both into one table.");
  ensure(!options.cases.empty() || !options.varied.empty(),
         "The sweep has no cases; give --cases cases.csv, or --vary \"Section/Entry=first:last:number\".");
  return options.cases.empty() ? cases_of_grid(options.varied) : cases_from_file(options.cases);
}

/// Names implausible values of the cases, the first one of each entry.
void note_implausible_cases(const CaseList &list)
{
  for (std::size_t e = 0; e < list.entries.size(); ++e)
    for (const std::vector<std::string> &values : list.cases)
    {
      const auto number = list.entries[e].unit.empty() ? std::nullopt : parse_number(values[e]);
      const std::string note = number ? implausible_note(list.entries[e].path, *number) : "";
      print_note("Check     ", note);
      if (!note.empty())
        break;
    }
}

/// Options with the folder of the results: a part of the cases has a folder of its own by default.
StudyOptions with_place(const SweepOptions &options, const RowRange &rows)
{
  StudyOptions placed = options;
  placed.output = options.results_place().string();
  if (options.output.empty() && !options.rows.empty())
    placed.output += fmt::format(FMT_STRING("-rows-{}-{}"), rows.first + 1, rows.last + 1);
  return placed;
}

/// Solves the cases of a sweep that are not finished in the folder of its results. Throws BadInput,
/// OutputFailure, and std::runtime_error if all cases fail.
void sweep(const SweepOptions &options)
{
  // 1. Everything that can be refused is refused here.
  Stopwatch stopwatch;
  ensure(n_ranks() == 1,
         "A sweep runs in one process and not under mpirun; split its cases into processes with "
         "--rows 1:100, --rows 101:200 and so on.");
  CaseList list = list_of(options);
  const RowRange rows = rows_of(options, list.cases.size());
  const StudyOptions placed = with_place(options, rows);
  list.base = begin_study(options);
  SweepFile file(placed.results_place(), list);
  std::vector<std::size_t> wanted;
  for (std::size_t i = rows.first; i <= rows.last; ++i)
    if (file.finished().count(i) == 0)
      wanted.push_back(i);
  const unsigned int n_threads = n_threads_of(options);
  const std::size_t n_rows = rows.last - rows.first + 1;
  console() << "Sweep     " << n_rows << " cases, " << n_threads << " at a time" << std::endl;
  if (wanted.size() < n_rows)
    console() << "          " << n_rows - wanted.size() << " of them are finished" << std::endl;
  note_implausible_cases(list);
  stopwatch.finish("input");

  // 2. The cases.
  WorkProgress progress(n_rows, n_rows - wanted.size());
  std::size_t n_done = n_rows - wanted.size(), n_failed = 0;
  solve_cases(list, wanted, n_threads,
              [&](std::size_t index, const CaseResult &result)
              {
                file.append(index, result);
                n_failed += result.is_solved() ? 0 : 1;
                progress.show(++n_done, n_failed);
              });
  file.sort();
  stopwatch.finish("cases");

  // 3. What they say together.
  publish_in(placed.results_place(), placed, list.base, sweep_results(list, file.finished()), stopwatch);
  for (const auto &[index, result] : file.finished())
    if (result.is_solved())
      return;
  throw std::runtime_error(fmt::format(FMT_STRING("All {} cases failed, the first one because: {}"),
                                       file.finished().size(), file.finished().begin()->second.message));
}

} // namespace

void add_sweep_verb(CLI::App &program, Verb &chosen)
{
  const auto [verb, options] =
    add_study_verb(program, chosen, "sweep", "Compute a study many times: a list or a grid of cases", sweep);
  verb->add_option("--cases", options->cases, "Table of cases: a column for each entry, a row for each case")
    ->type_name("FILE");
  verb->add_option("--vary", options->varied, "Values of one entry: a range or a list; at most twice")
    ->type_name("\"Section/Entry=values\"")
    ->allow_extra_args(false);
  verb->add_option("--rows", options->rows, "Solves these cases only, counted from 1")
    ->type_name("FIRST:LAST");
}

} // namespace stemware::pipeline
