#include "fem/pipeline/analysis/refinement/error_bands.h"
#include "fem/pipeline/analysis/refinement/goal_mesh.h"
#include "fem/pipeline/analysis/truncation.h"
#include "fem/pipeline/app/options.h"
#include "fem/pipeline/app/study_work.h"
#include "fem/pipeline/coupling/study_load.h"
#include "fem/pipeline/report/publish.h"
#include "fem/pipeline/report/truncation_results.h"

#include <CLI/CLI.hpp>

namespace stemware::pipeline
{

namespace
{

/// Options of `stemware truncate`.
struct TruncateOptions : StudyOptions
{
  std::vector<double> omega; ///< spins at which the torque is shown [rad/s]; empty: chosen by the study
};

/// Solves a study with fewer and fewer harmonics and writes the folder of its results. Collective over all
/// ranks. Throws as run().
void truncate(const TruncateOptions &options)
{
  // 1. What is asked for.
  StudyWork work(options, true, [&](const Study &given) { require_flat(given, options.verb); });

  // 2. The load of all harmonics, and the glass on fewer and fewer of them.
  const Study study = mesh_for_goal(work.given, work.executor, work.progress).study;
  const std::shared_ptr<ElasticFoot> foot = announced_foot(study, work.executor, work.progress);
  const SharedLoad load = find_load(study, foot, work.progress);
  TruncationStudy result = study_truncations(study, foot, *load, options.omega, work.executor, work.progress);
  work.stopwatch.finish("truncations");
  SpinRow &all = result.rows.back();
  const ErrorBands bands =
    estimate_bands(study, foot, all, result.rows.front().omega_terminal(), work.executor);
  all.band = band_of(bands, "omega_terminal");
  add_bands(all.band, band_of(bands, "omega_first_harmonic"), result.budget);
  work.stopwatch.finish("error_band");

  // 3. The answer, and the results, all at once.
  publish(options, study, tabulate(study, load->report(), result, bands), work.folder, work.stopwatch);
}

} // namespace

void add_truncate_verb(CLI::App &program, Verb &chosen)
{
  const auto [verb, options] =
    add_study_verb(program, chosen, "truncate", "How many harmonics of the load matter", truncate);
  add_spin_option(*verb, options->omega, "the terminal spin of all harmonics, and half of it");
}

} // namespace stemware::pipeline
