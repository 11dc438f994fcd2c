#include "fem/pipeline/app/converge.h"

#include "fem/pipeline/analysis/refinement/refinement_study.h"
#include "fem/pipeline/analysis/solve_study.h"
#include "fem/pipeline/output/console_report.h"
#include "fem/pipeline/output/converge_report.h"
#include "fem/pipeline/output/converge_results.h"
#include "fem/pipeline/output/render/report.h"
#include "fem/pipeline/support/console.h"
#include "fem/pipeline/support/ranks.h"
#include "fem/pipeline/support/text_layout.h"

#include <algorithm>
#include <thread>

namespace stemware::pipeline
{

void converge(const ConvergeOptions &options)
{
  // 1. What is asked for, and which levels that makes.
  Stopwatch stopwatch;
  const Study study = begin_study(options.study);
  const std::vector<RefinementAxis> axes = refinement_axes(study, options.n_levels);
  SharedFolder folder(options.study.results_place());
  print_load_source(study);
  stopwatch.finish("input");

  // 2. The study itself, then all other levels.
  StudyObserver observer;
  observer.foot_made = progress_on_console(stopwatch).foot_made;
  const RingLoad own_load = find_load(study, observer).load;
  const YawStudy yaw = study_yaw(own_load.at_spin, study.motion.orbit);
  const std::vector<double> spins =
    options.spins.empty() ? followed_spins(yaw.terminal.omega) : options.spins;
  const auto own = figures_of_load(study, own_load, spins, yaw.terminal.omega);
  stopwatch.finish("study");
  const RefinementResult result =
    refine(study, own, spins, axes, std::max(1u, std::thread::hardware_concurrency()),
           [](std::size_t n_done, std::size_t n_all)
           { console() << formatted("  level %zu of %zu solved", n_done, n_all) << std::endl; });
  stopwatch.finish("levels");

  // 3. Orders, limits and bands.
  console() << refinement_tables(result) << '\n' << wrapped(refinement_answer(result)) << "\n\n";
  folder.write(
    [&](ResultsFolder &owned)
    {
      write_refinement_tables(result, owned.working_folder());
      write_report(converge_report(options.study, result), owned.working_folder());
    });
  publish(options.study, study, refinement_findings(result), folder, stopwatch);
}

} // namespace stemware::pipeline
