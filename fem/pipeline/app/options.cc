#include "fem/pipeline/app/options.h"

#include "fem/pipeline/base/console.h"
#include "fem/pipeline/base/memory_left.h"
#include "fem/pipeline/base/numbers.h"
#include "fem/pipeline/base/program.h"
#include "fem/pipeline/base/ranks.h"
#include "fem/pipeline/base/text.h"
#include "fem/pipeline/coupling/make_foot.h"
#include "fem/pipeline/study/data_files.h"
#include "fem/pipeline/study/study.h"
#include "fem/pipeline/study/study_checks.h"
#include "fem/pipeline/study/study_file.h"
#include "fem/pipeline/study/study_size.h"
#include "ring_model/load/constants.h"

#include <CLI/CLI.hpp>
#include <boost/algorithm/string/join.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <iostream>
#include <thread>

namespace stemware::pipeline
{

namespace
{

/// Returns a check for names that consist of the characters @p blanks only (usually an unset shell variable),
/// with the error message @p message.
auto not_blank(const char *blanks, const char *message)
{
  return [=](const std::string &text)
  { return text.find_first_not_of(blanks) == std::string::npos ? std::string(message) : ""; };
}

/// Throws if the limits of the process leave less memory than a study needs for its contact. Libraries would
/// otherwise wait for memory indefinitely or end the program.
void require_memory_for(const StudySize &size, unsigned int n_threads)
{
  constexpr double buffers = 2e8, // for BLAS and written fields [bytes]
    stack_and_heap_of_thread = 8e7;
  const double needed = size.memory - memory_of_the_program;
  require_memory_left(needed, needed / n_ranks() + buffers + (n_threads - 1) * stack_and_heap_of_thread);
}

/// Reports the required resultants at rest and their source to @p progress.
void note_load_source(const Study &study, Progress &progress)
{
  if (study.load.source == LoadSource::file)
  {
    progress.note("Load", study.load.file);
    return;
  }
  const fem::Resultants demand = study.required_resultants();
  const double ratio = moment_ratio(demand, study.glass.profile.contact_radius);
  const double crest = std::atan2(demand.moment_x, -demand.moment_y) / (ring::pi / 180);
  const std::string origin =
    study.load.is_static() ? "given"
                           : "moment balance " + ring::to_string(study.motion.closure) + ", upright at rest";
  std::string text =
    fmt::format(FMT_STRING("{:.6g} N, moment ratio {:.4g} ({})"), demand.normal_force, ratio, origin);
  if (ratio > 0)
    text += fmt::format(FMT_STRING(", largest at {:.3g} deg"), crest);
  progress.note("Load", text);
}

} // namespace

void print_note(const std::string &label, const std::string &note)
{
  if (!note.empty())
    console() << wrapped(note, label) << std::endl;
}

void print_warning(const std::string &label, const std::string &warning, const StudyOptions &options)
{
  if (options.quiet && !warning.empty() && is_first_rank())
    std::cerr << "stemware: " << warning << std::endl;
  else
    print_note(label, warning);
}

void add_study_option(CLI::App &verb, StudyOptions &options, const std::string &role)
{
  verb
    .add_option("STUDY", options.study_file,
                "Study file, .prm or .json, - for standard input" + (role.empty() ? "" : ", " + role) +
                  ";\ndefault: the default study")
    ->check(not_blank("", "the name of the study is empty; give the path of a .prm file, or omit it for the "
                          "default study"));
}

void add_study_options(CLI::App &verb, StudyOptions &options)
{
  options.verb = verb.get_name();
  add_study_option(verb, options);
  verb
    .add_option("--output", options.output,
                "Folder of the results; default: results/<name of the study>" +
                  std::string(options.verb == "run" ? "" : "-" + options.verb))
    ->type_name("DIR")
    ->check(not_blank(" \t\r\n", "the name of the folder is empty; give a path, or omit --output for the "
                                 "default"));
  add_override_option(verb, options);
  add_threads_option(verb, options);
  add_console_options(verb, options);
}

void add_threads_option(CLI::App &verb, StudyOptions &options, const std::string &help)
{
  verb
    .add_option("--threads", options.n_threads,
                help + ";\ndefault: OMP_NUM_THREADS, else one for each core, one under mpirun")
    ->type_name("N")
    ->check(CLI::Range(1, 1024).description(""));
}

unsigned int n_threads_of(const StudyOptions &options)
{
  if (options.n_threads > 0)
    return options.n_threads;
  const char *variable = std::getenv("OMP_NUM_THREADS");
  const auto asked = variable ? parse_number(variable) : std::nullopt;
  if (asked && *asked >= 1 && *asked <= 1024)
    return static_cast<unsigned int>(*asked);
  return n_ranks() > 1 ? 1 : std::max(1u, std::thread::hardware_concurrency());
}

void add_override_option(CLI::App &verb, StudyOptions &options)
{
  verb.add_option("--set", options.overrides, "Replaces one entry of the study file; may be repeated")
    ->type_name("\"Section/Entry=value\"")
    ->allow_extra_args(false);
}

void add_console_options(CLI::App &verb, StudyOptions &options)
{
  verb.add_flag("--quiet", options.quiet, "Print warnings and errors only");
  verb.add_flag("--json", options.json,
                "Print one JSON object on standard output, with paths and key figures;\n"
                "the other text goes to standard error");
}

Study begin_study(const StudyOptions &options)
{
  direct_console(options.quiet, options.json);
  Study study = read_study(options.study_file, options.overrides);
  study.name = options.study_name();
  console() << "Stemware  " << program_version() << " (" << program_revision() << ")\n"
            << "Study     "
            << (options.study_file.empty()  ? "default"
                : options.study_file == "-" ? "standard input"
                                            : options.study_file)
            << std::endl;
  for (const std::string &note : implausible_notes(entries_of(study)))
    print_warning("Check     ", note, options);
  print_note("Profile   ", profile_note(study.glass));
  if (options.verb != "sweep") // in a sweep, each case has its own study
  {
    require_no_tipping_at_rest(study);
    const std::vector<std::string> unused = unused_entries(entries_of(study));
    if (!unused.empty())
      print_warning("Unused    ",
                    boost::join(unused, ", ") + (unused.size() == 1 ? " has" : " have") +
                      " no effect in this study.",
                    options);
    if (const StudySize size = size_of(study); size.memory > 1e9)
      print_note("Memory    ", fmt::format(FMT_STRING("about {:.2g} GB for {:.2g} unknowns"),
                                           size.memory / 1e9, size.unknowns));
  }
  if (!study.load.is_from_contact())
    return study;
  // Also checked before MPI starts, because MPI prints its own messages if it lacks memory.
  require_memory_for(size_of(study), n_threads_of(options));
  prepare_body(study.contact.body);
  require_memory_for(size_of(study), n_threads_of(options));
  return study;
}

StudyWork::StudyWork(const StudyOptions &options)
    : study(begin_study(options))
    , folder(options.results_place())
    , executor(cache, n_threads_of(options), progress)
{
  note_load_source(study, progress);
  progress.stopwatch.finish("input");
}

} // namespace stemware::pipeline
