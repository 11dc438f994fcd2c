#include "fem/pipeline/analysis/comparison.h"
#include "fem/pipeline/analysis/refinement/goal_mesh.h"
#include "fem/pipeline/app/console_progress.h"
#include "fem/pipeline/app/options.h"
#include "fem/pipeline/app/verbs.h"
#include "fem/pipeline/output/comparison_results.h"
#include "fem/pipeline/output/publish.h"
#include "fem/pipeline/support/failures.h"

#include <CLI/CLI.hpp>

#include <memory>

namespace stemware::pipeline
{

namespace
{

/// A comparison chooses moment balances and loads itself.
void require_comparable(const Study &study)
{
  require(study.load.source != LoadSource::file,
          "Load/Source = file has one load, whatever the closure; set Load/Source = contact, or first "
          "harmonic to compare without an elastic foot.");
  require(!study.load.is_static(), "Load/Moment ratio is given, but closures differ in the moment that they "
                                   "ask for; leave Moment ratio at -1.");
  require_flat(study, "compare");
}

/// Solves the study's glass under several moment balances on several loads and writes the folder of the
/// results. Collective over all ranks. Throws as run().
void compare(const StudyOptions &options)
{
  // 1. What is asked for.
  Stopwatch stopwatch;
  ConsoleProgress progress(stopwatch);
  const Study given = begin_study(options);
  require_comparable(given);
  ResultsFolder folder(options.results_place());
  stopwatch.finish("input");

  // 2. Every moment balance on every load.
  fem::ComplianceCache cache;
  const Executor executor(cache, n_threads_of(options));
  const Study study = mesh_for_goal(given, executor, progress).study;
  const Comparison comparison =
    compare_models(study, announced_foot(study, executor, progress), executor, progress);

  // 3. The answer, and the results, all at once.
  publish(options, study, tabulate(study, comparison), folder, stopwatch);
}

} // namespace

void add_compare_verb(CLI::App &program, Verb &chosen)
{
  const auto options = std::make_shared<StudyOptions>();
  CLI::App *verb = program.add_subcommand(
    "compare", "Moment balances, loads, harmonics side by side: what changes the spin");
  add_study_options(*verb, *options);
  verb->footer(R"(Examples:
  stemware compare my_glass.prm
  stemware compare my_glass.prm --set "Table/Foundation modulus=1e9"
  stemware compare my_glass.prm --set "Load/Source=first harmonic"    # no elastic foot

The glass of the study under the moment balances (Motion/Closure) paper, hand and full, on six kinds
of load: the paper's first harmonic; a rigid rim, flat and round, on a mat that only pushes; a rigid
foot on the study's table, unless that is rigid too; and the elastic foot, one-way (the load of the
glass that does not spin yet) and two-way (in balance with friction at every spin; a solid body with
Load/Coupling = two-way only). Each with 1, 2, 3 and all harmonics, and the terminal spin step by
step from the paper's model to the study's. A row without a result says why: tips, no balance, no
terminal spin. A load is "formal" where it is negative somewhere: the table would have to pull.

  compare.csv        one row for each closure, load and number of harmonics
  report.html, figures/, summary.json, parameters.prm, timings.json)");
  verb->callback([&chosen, options] { chosen = [options] { compare(*options); }; });
}

} // namespace stemware::pipeline
