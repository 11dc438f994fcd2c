#include "fem/pipeline/app/study_work.h"

#include "fem/pipeline/app/options.h"

namespace stemware::pipeline
{

namespace
{

Study begin(const StudyOptions &options, const std::function<void(const Study &)> &refuse)
{
  Study study = begin_study(options);
  if (refuse)
    refuse(study);
  return study;
}

} // namespace

StudyWork::StudyWork(const StudyOptions &options, bool notes_load,
                     const std::function<void(const Study &)> &refuse)
    : progress(stopwatch)
    , study(begin(options, refuse))
    , folder(options.results_place())
    , executor(cache, n_threads_of(options))
{
  if (notes_load)
    note_load_source(study, progress);
  stopwatch.finish("input");
}

} // namespace stemware::pipeline
