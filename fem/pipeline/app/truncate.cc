#include "fem/pipeline/analysis/refinement/goal_mesh.h"
#include "fem/pipeline/analysis/study_rows.h"
#include "fem/pipeline/app/options.h"
#include "fem/pipeline/app/study_work.h"
#include "fem/pipeline/coupling/study_load.h"
#include "fem/pipeline/report/publish.h"
#include "fem/pipeline/report/truncation_results.h"
#include "ring_model/no_balance.h"

namespace stemware::pipeline
{

namespace
{

/// Solves a study with fewer and fewer harmonics, as `run` does, and writes the folder of its results.
/// Collective over all ranks. Throws as run().
void truncate(const StudyOptions &options)
{
  // 1. What is asked for.
  StudyWork work(options, true);

  // 2. The load of all harmonics, and the glass on fewer and fewer of them.
  const Study study = mesh_for_goal(work.given, work.executor, work.progress).study;
  const std::shared_ptr<ElasticFoot> foot = announced_foot(study, work.executor, work.progress);
  const SharedLoad load = find_load(study, foot, work.progress);
  std::vector<SpinRow> rows;
  for (const LoadedRow &answer :
       rows_by_harmonics(study, foot, *load, spin_question(study), work.executor, work.progress))
    rows.push_back(answer.row);
  if (!rows.back().terminal)
    throw ring::NoBalance(rows.back().reason + ": no terminal spin to compare with; stemware run shows it");
  work.stopwatch.finish("truncations");

  // 3. The answer, and the results, all at once.
  publish(options, study, tabulate_truncations(study, load->report(), rows), work.folder, work.stopwatch);
}

} // namespace

void add_truncate_verb(CLI::App &program, Verb &chosen)
{
  add_study_verb(program, chosen, "truncate", "How many harmonics of the load matter", truncate);
}

} // namespace stemware::pipeline
