#include "fem/pipeline/analysis/study_answer.h"
#include "fem/pipeline/app/options.h"
#include "fem/pipeline/base/ranks.h"
#include "fem/pipeline/page/publish.h"
#include "fem/pipeline/result/verb_results.h"

#include <CLI/CLI.hpp>

#include <utility>

namespace stemware::pipeline
{

namespace
{

struct RunOptions : StudyOptions
{
  bool quick = false; ///< true: no budget and no error bands
};

void run(const RunOptions &options)
{
  const Depth depth = options.quick ? Depth::answer : Depth::full;
  StudyWork work(options); // throws for every input error that can be detected now
  StudyAnswer answer = answer_study(work.study, depth, work.executor, true);
  // Only the first rank has the load and the results. Each rank has the fields of its own cells.
  Results results = is_first_rank() ? run_results(answer) : Results();
  results.fields = std::move(answer.fields.files);
  publish(options, std::move(results), work.folder, work.progress.stopwatch);
}

} // namespace

void add_run_verb(CLI::App &program)
{
  const auto [verb, options] = add_study_verb(
    program, "run", "Compute a study: contact, torque, spin, and the size of each effect", run);
  verb->add_flag("--quick", options->quick, "The answer and its curves, no budget and no error bands");
}

} // namespace stemware::pipeline
