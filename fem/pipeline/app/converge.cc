#include "fem/pipeline/analysis/refinement/goal_mesh.h"
#include "fem/pipeline/analysis/refinement/refinement_study.h"
#include "fem/pipeline/analysis/spin.h"
#include "fem/pipeline/app/options.h"
#include "fem/pipeline/app/study_work.h"
#include "fem/pipeline/coupling/study_load.h"
#include "fem/pipeline/report/convergence_results.h"
#include "fem/pipeline/report/publish.h"

#include <CLI/CLI.hpp>

#include <algorithm>

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
  std::vector<RefinementAxis> axes;
  StudyWork work(options, true, [&](const Study &given) { axes = refinement_axes(given, options.n_levels); });

  // 2. The study itself, then all other levels.
  const Study study = mesh_for_goal(work.given, work.executor, work.progress).study;
  if (study.contact.goal != Goal::none)
  {
    // Meshes of other cells have other cells to halve.
    axes = refinement_axes(study, options.n_levels);
    axes.erase(std::remove_if(axes.begin(), axes.end(),
                              [](const RefinementAxis &axis) { return axis.role == AxisRole::space; }),
               axes.end());
    axes.insert(axes.begin(), goal_axis(study, work.executor));
  }
  const std::shared_ptr<ElasticFoot> foot = announced_foot(study, work.executor, work.progress);
  const SharedLoad load = find_load(study, foot);
  const double omega_terminal = terminal_spin(*load, study.motion.orbit).spin.omega;
  const std::vector<double> spins = options.spins.empty() ? spins_of_interest(omega_terminal) : options.spins;
  const auto own = quantities_of_load(study, *load, spins, omega_terminal, foot.get());
  work.stopwatch.finish("study");
  const RefinementResult result = refine(own, spins, axes, work.executor, work.progress);
  work.stopwatch.finish("levels");

  // 3. Orders, limits and bands.
  publish(options, study, tabulate(study, result), work.folder, work.stopwatch);
}

} // namespace

void add_converge_verb(CLI::App &program, Verb &chosen)
{
  const auto [verb, options] = add_study_verb(
    program, chosen, "converge", "Refine a study: observed orders, limits, error bands", converge);
  verb
    ->add_option("--levels", options->n_levels,
                 "Levels of each parameter; default 3, which an observed order needs")
    ->check(CLI::Range(2, 5))
    ->type_name("N");
  add_spin_option(*verb, options->spins, "half and one and a half times the terminal spin");
}

} // namespace stemware::pipeline
