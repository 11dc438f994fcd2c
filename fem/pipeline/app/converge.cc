#include "fem/pipeline/analysis/study_answer.h"
#include "fem/pipeline/app/options.h"
#include "fem/pipeline/page/publish.h"
#include "fem/pipeline/result/verb_results.h"

#include <CLI/CLI.hpp>

namespace stemware::pipeline
{

namespace
{

struct ConvergeOptions : StudyOptions
{
  unsigned int n_levels = 3;
};

void converge(const ConvergeOptions &options)
{
  StudyWork work(options);
  std::vector<RefinementAxis> axes = refinement_axes(work.study, options.n_levels);
  const ErrorBands bands = converge_study(work.study, axes, work.executor);
  publish(options, convergence_results(work.study, axes, bands), work.folder, work.progress.stopwatch);
}

} // namespace

void add_converge_verb(CLI::App &program)
{
  const auto [verb, options] =
    add_study_verb(program, "converge", "Refine a study: observed orders, limits, error bands", converge);
  verb
    ->add_option("--levels", options->n_levels,
                 "Levels of each parameter; default 3, which an observed order needs")
    ->check(CLI::Range(2, 5))
    ->type_name("N");
}

} // namespace stemware::pipeline
