#include "fem/pipeline/analysis/refinement/goal_mesh.h"
#include "fem/pipeline/analysis/refinement/refinement_study.h"
#include "fem/pipeline/analysis/spin.h"
#include "fem/pipeline/app/console_progress.h"
#include "fem/pipeline/app/options.h"
#include "fem/pipeline/app/verbs.h"
#include "fem/pipeline/coupling/study_load.h"
#include "fem/pipeline/report/convergence_results.h"
#include "fem/pipeline/report/publish.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>

namespace stemware::pipeline
{

namespace
{

/// Options of `stemware converge`.
struct ConvergeOptions : StudyOptions
{
  unsigned int n_levels = 3;
  std::vector<double> spins; ///< at which the torque is followed [rad/s]; empty: spins_of_interest()
};

/// Solves a study on finer and coarser levels of each of its numerical parameters and writes observed orders,
/// limits and error bands. Collective over all ranks. Throws as run().
void converge(const ConvergeOptions &options)
{
  // 1. What is asked for, and which levels that makes.
  Stopwatch stopwatch;
  ConsoleProgress progress(stopwatch);
  const Study given = begin_study(options);
  std::vector<RefinementAxis> axes = refinement_axes(given, options.n_levels);
  ResultsFolder folder(options.results_place());
  note_load_source(given, progress);
  stopwatch.finish("input");

  // 2. The study itself, then all other levels.
  fem::ComplianceCache cache;
  const Executor executor(cache, n_threads_of(options));
  const Study study = mesh_for_goal(given, executor, progress).study;
  if (study.contact.goal != Goal::none)
  {
    // Meshes of other cells have other cells to halve.
    axes = refinement_axes(study, options.n_levels);
    axes.erase(std::remove_if(axes.begin(), axes.end(),
                              [](const RefinementAxis &axis) { return axis.role == AxisRole::space; }),
               axes.end());
    axes.insert(axes.begin(), goal_axis(study, executor));
  }
  const std::shared_ptr<ElasticFoot> foot = announced_foot(study, executor, progress);
  const SharedLoad load = find_load(study, foot);
  const double omega_terminal = terminal_spin(*load, study.motion.orbit).spin.omega;
  const std::vector<double> spins = options.spins.empty() ? spins_of_interest(omega_terminal) : options.spins;
  const auto own = quantities_of_load(study, *load, spins, omega_terminal, foot.get());
  stopwatch.finish("study");
  const RefinementResult result = refine(own, spins, axes, executor, progress);
  stopwatch.finish("levels");

  // 3. Orders, limits and bands.
  publish(options, study, tabulate(study, result), folder, stopwatch);
}

} // namespace

void add_converge_verb(CLI::App &program, Verb &chosen)
{
  const auto options = std::make_shared<ConvergeOptions>();
  CLI::App *verb = program.add_subcommand("converge", "Refine a study: observed orders, limits, error bands");
  add_study_options(*verb, *options);
  verb
    ->add_option("--levels", options->n_levels,
                 "Levels of each parameter; default 3, which an observed order needs")
    ->check(CLI::Range(2, 5))
    ->type_name("N");
  add_spin_option(*verb, options->spins, "half and one and a half times the terminal spin");
  verb->footer(help_of("converge"));
  verb->callback([&chosen, options] { chosen = [options] { converge(*options); }; });
}

} // namespace stemware::pipeline
