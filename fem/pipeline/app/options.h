#pragma once

#include "fem/pipeline/analysis/threaded_executor.h"
#include "fem/pipeline/app/console_progress.h"
#include "fem/pipeline/app/verbs.h"
#include "fem/pipeline/base/output.h"
#include "fem/pipeline/study/study.h"
#include "fem/pipeline/study/study_options.h"

#include <memory>
#include <string>
#include <utility>

namespace stemware::pipeline
{

/// Declares the argument STUDY, stored in @p options; @p role: purpose of the study in the help.
void add_study_option(CLI::App &verb, StudyOptions &options, const std::string &role = "");

/// Declares STUDY, --output, --set, --threads, --quiet and --json on @p verb, stored in @p options.
void add_study_options(CLI::App &verb, StudyOptions &options);

/// Adds a verb with add_verb() and add_study_options(), stored in Options (derived from StudyOptions).
/// Returns verb and options, for further options.
template <typename Options>
std::pair<CLI::App *, std::shared_ptr<Options>> add_study_verb(CLI::App &program, const std::string &name,
                                                               const std::string &words,
                                                               void (*work)(const Options &))
{
  const auto options = std::make_shared<Options>();
  CLI::App *verb = add_verb(program, name, words, [options, work] { work(*options); });
  add_study_options(*verb, *options);
  return { verb, options };
}

/// Declares --threads with the text @p help.
void add_threads_option(CLI::App &verb, StudyOptions &options,
                        const std::string &help = "Threads that share the work");

/// Returns the number of threads: --threads, else OMP_NUM_THREADS, else number of cores, or 1 with MPI.
unsigned int n_threads_of(const StudyOptions &options);

/// Declares --set.
void add_override_option(CLI::App &verb, StudyOptions &options);

/// Declares --quiet and --json.
void add_console_options(CLI::App &verb, StudyOptions &options);

/// Prints @p note on the console after @p label, unless it is empty.
void print_note(const std::string &label, const std::string &note);

/// Prints a @p warning like print_note(), with --quiet on standard error.
void print_warning(const std::string &label, const std::string &warning, const StudyOptions &options);

/// Directs the console, reads the study, prepares its foot, and makes all checks before the work. Throws
/// BadInput if a check fails.
Study begin_study(const StudyOptions &options);

/// Objects for the work of the verbs that solve one study. Collective over all ranks.
struct StudyWork
{
  /// Checks study and results folder by begin_study() and ResultsFolder, and reports the required resultants.
  explicit StudyWork(const StudyOptions &options);

  ConsoleProgress progress;
  Study study;
  ResultsFolder folder;
  fem::ComplianceCache cache;
  ThreadedExecutor executor;
};

} // namespace stemware::pipeline
