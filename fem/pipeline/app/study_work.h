#pragma once

#include "fem/pipeline/analysis/solve.h"
#include "fem/pipeline/analysis/threaded_executor.h"
#include "fem/pipeline/app/console_progress.h"
#include "fem/pipeline/base/output.h"
#include "fem/pipeline/study/study_options.h"

namespace stemware::pipeline
{

/// Common beginning of the verbs that solve one study, with the objects that their work needs. Collective
/// over all ranks.
struct StudyWork
{
  /// Makes all checks before the work: begin_study(), and the folder of the results. Then reports the
  /// required resultants.
  explicit StudyWork(const StudyOptions &options);

  Stopwatch stopwatch;
  ConsoleProgress progress;
  Study study;
  ResultsFolder folder;
  fem::ComplianceCache cache;
  ThreadedExecutor executor;
};

} // namespace stemware::pipeline
