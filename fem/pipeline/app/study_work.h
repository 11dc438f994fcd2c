#pragma once

#include "fem/pipeline/analysis/solve.h"
#include "fem/pipeline/analysis/threaded_executor.h"
#include "fem/pipeline/app/console_progress.h"
#include "fem/pipeline/base/output.h"
#include "fem/pipeline/study/study_options.h"

namespace stemware::pipeline
{

/// Objects for the work of the verbs that solve one study. Collective over all ranks.
struct StudyWork
{
  /// Checks study and results folder by begin_study() and ResultsFolder, and reports the required resultants.
  explicit StudyWork(const StudyOptions &options);

  Stopwatch stopwatch;
  ConsoleProgress progress;
  Study study;
  ResultsFolder folder;
  fem::ComplianceCache cache;
  ThreadedExecutor executor;
};

} // namespace stemware::pipeline
