#pragma once

#include "fem/pipeline/app/console_progress.h"
#include "fem/pipeline/study/study_options.h"
#include "fem/pipeline/support/output.h"
#include "fem/pipeline/variants/solve.h"

#include <functional>

namespace stemware::pipeline
{

/// The beginning that verbs have in common which solve one study, and the means of their work. Collective
/// over all ranks.
struct StudyWork
{
  /// Everything that can be refused is refused here: by begin_study(), by @p refuse, which throws BadInput,
  /// and by the folder of the results. Then says, if it @p notes_load, what the table has to carry.
  StudyWork(const StudyOptions &options, bool notes_load,
            const std::function<void(const Study &)> &refuse = {});

  Stopwatch stopwatch;
  ConsoleProgress progress;
  Study given; ///< before its goal has chosen a mesh
  ResultsFolder folder;
  fem::ComplianceCache cache;
  Executor executor;
};

} // namespace stemware::pipeline
