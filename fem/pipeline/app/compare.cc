#include "fem/pipeline/analysis/comparison.h"
#include "fem/pipeline/analysis/refinement/goal_mesh.h"
#include "fem/pipeline/app/options.h"
#include "fem/pipeline/app/study_work.h"
#include "fem/pipeline/report/comparison_results.h"
#include "fem/pipeline/report/publish.h"
#include "fem/pipeline/support/failures.h"

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
  StudyWork work(options, false, require_comparable);

  // 2. Every moment balance on every load.
  const Study study = mesh_for_goal(work.given, work.executor, work.progress).study;
  const Comparison comparison =
    compare_models(study, announced_foot(study, work.executor, work.progress), work.executor, work.progress);

  // 3. The answer, and the results, all at once.
  publish(options, study, tabulate(study, comparison), work.folder, work.stopwatch);
}

} // namespace

void add_compare_verb(CLI::App &program, Verb &chosen)
{
  add_study_verb(program, chosen, "compare",
                 "Moment balances, loads, harmonics side by side: what changes the spin", compare);
}

} // namespace stemware::pipeline
