#pragma once

#include "fem/pipeline/app/verbs.h"
#include "fem/pipeline/study/study.h"
#include "fem/pipeline/study/study_options.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace stemware::pipeline
{

/// Declares STUDY alone, to be stored in @p options; @p role says what the study is for.
void add_study_option(CLI::App &verb, StudyOptions &options, const std::string &role = "");

/// Declares --output alone, with that help.
void add_output_option(CLI::App &verb, StudyOptions &options, const std::string &help);

/// Declares STUDY, --output, --set, --threads, --quiet and --json on @p verb, to be
/// stored in @p options.
void add_study_options(CLI::App &verb, StudyOptions &options);

/// Adds a verb that works on studies, as add_verb(): with add_study_options(), stored in Options, which are
/// derived from StudyOptions. The verb and its options come back, for those of its own.
template <typename Options>
std::pair<CLI::App *, std::shared_ptr<Options>>
add_study_verb(CLI::App &program, Verb &chosen, const std::string &name, const std::string &words,
               void (*work)(const Options &))
{
  const auto options = std::make_shared<Options>();
  CLI::App *verb = add_verb(program, chosen, name, words, [options, work] { work(*options); });
  add_study_options(*verb, *options);
  return { verb, options };
}

/// Declares --threads alone, with that help.
void add_threads_option(CLI::App &verb, StudyOptions &options,
                        const std::string &help = "Threads that share the work");

/// Number of threads: the option --threads, else the variable OMP_NUM_THREADS, else the number of cores, or 1
/// with MPI.
unsigned int n_threads_of(const StudyOptions &options);

/// Declares --set alone.
void add_override_option(CLI::App &verb, StudyOptions &options);

/// Declares --quiet and --json alone.
void add_console_options(CLI::App &verb, StudyOptions &options);

/// Says @p note on the console behind @p label; nothing where it is empty.
void print_note(const std::string &label, const std::string &note);

/// Begins a verb: directs the console, reads and checks the study, and loads the modules of its foot. Refuses
/// everything that can be refused before the work; throws BadInput.
Study begin_study(const StudyOptions &options);

} // namespace stemware::pipeline
