#include "fem/pipeline/analysis/refinement/error_bands.h"
#include "fem/pipeline/analysis/refinement/goal_mesh.h"
#include "fem/pipeline/analysis/spin_study.h"
#include "fem/pipeline/app/options.h"
#include "fem/pipeline/app/study_work.h"
#include "fem/pipeline/coupling/contact_report.h"
#include "fem/pipeline/coupling/study_load.h"
#include "fem/pipeline/report/publish.h"
#include "fem/pipeline/report/run_results.h"
#include "fem/pipeline/support/ranks.h"

#include <CLI/CLI.hpp>

#include <utility>

namespace stemware::pipeline
{

namespace
{

/// Options of `stemware run`.
struct RunOptions : StudyOptions
{
  bool quick = false; ///< the answer and its curves alone
};

/// Solves a study and writes the folder of its results. Collective over all ranks. Throws BadInput,
/// OutputFailure, fem::ContactFailure, and std::runtime_error where there is no balance or no terminal spin.
void run(const RunOptions &options)
{
  const Depth depth = options.quick ? Depth::answer : Depth::full;

  // 1. What is asked for; everything that can be refused is refused here.
  StudyWork work(options, true);

  // 2. The load on the table, and what it does to the ring.
  const auto [study, goal] = mesh_for_goal(work.given, work.executor, work.progress);
  const std::shared_ptr<ElasticFoot> foot = announced_foot(study, work.executor, work.progress);
  const SharedLoad load = find_load(study, foot, work.progress);
  SpinStudy spin = study_spin(study, foot, *load, work.executor, work.progress, depth);
  const double last_spin = spin.all().last_spin().value();
  work.stopwatch.finish("ring");
  ContactReport report = describe(study, foot, *load, last_spin);
  work.stopwatch.finish("report_of_contact");

  // 3. Fields, and meanwhile what the discretisation leaves open.
  ErrorBands bands;
  const std::shared_ptr<const ElasticFoot> of_fields = foot ? foot->twin() : nullptr;
  const auto find = [&](std::size_t i)
  {
    if (i == 0 && report.foot)
      add_fields(study, *of_fields, *report.foot);
    if (i == 1)
      bands = estimate_bands(study, foot, spin.all(), spin.rows.front().omega_terminal(), work.executor,
                             work.progress);
  };
  work.executor.for_each(depth == Depth::full ? 2 : 1, find, is_collective(study));
  if (depth == Depth::full)
  {
    take_reported_numbers(report.load, spin.budget, bands);
    add_bands(band_of(bands, "omega_terminal"), band_of(bands, "omega_first_harmonic"), spin.budget.rows);
  }
  work.stopwatch.finish("bands_and_fields");
  if (report.coupling)
    report.coupling->interpolation_error = spin.curve_error;

  // 4. The answer, and the results, all at once.
  // Only the first rank knows where the foot presses; each has the fields of its own cells.
  Results results = is_first_rank() ? tabulate(study, report, spin, bands, goal) : Results();
  if (report.foot)
    results.fields = std::move(report.foot->fields);
  publish(options, study, std::move(results), work.folder, work.stopwatch);
}

} // namespace

void add_run_verb(CLI::App &program, Verb &chosen)
{
  const auto [verb, options] = add_study_verb(
    program, chosen, "run", "Compute a study: contact, torque, spin, and how large each effect is", run);
  verb->add_flag("--quick", options->quick, "The answer and its curves, no budget and no error bands");
}

} // namespace stemware::pipeline
