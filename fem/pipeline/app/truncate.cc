#include "fem/pipeline/analysis/study_answer.h"
#include "fem/pipeline/app/options.h"
#include "fem/pipeline/page/publish.h"
#include "fem/pipeline/result/verb_results.h"

namespace stemware::pipeline
{

namespace
{

void truncate(const StudyOptions &options)
{
  StudyWork work(options);
  const StudyAnswer answer = answer_study(work.study, Depth::rows, work.executor, false);
  publish(options, truncation_results(answer), work.folder, work.progress.stopwatch);
}

} // namespace

void add_truncate_verb(CLI::App &program)
{
  add_study_verb(program, "truncate", "Find how many harmonics of the load matter", truncate);
}

} // namespace stemware::pipeline
