#include "fem/pipeline/app/study_work.h"

#include "fem/pipeline/app/options.h"

namespace stemware::pipeline
{

StudyWork::StudyWork(const StudyOptions &options)
    : progress(stopwatch)
    , study(begin_study(options))
    , folder(options.results_place())
    , executor(cache, n_threads_of(options), progress)
{
  note_load_source(study, progress);
  stopwatch.finish("input");
}

} // namespace stemware::pipeline
