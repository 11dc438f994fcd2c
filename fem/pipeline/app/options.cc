#include "fem/pipeline/app/options.h"

#include "fem/pipeline/feet/make_foot.h"
#include "fem/pipeline/input/data_files.h"
#include "fem/pipeline/input/profile_file.h"
#include "fem/pipeline/input/study_file.h"
#include "fem/pipeline/input/study_size.h"
#include "fem/pipeline/study/study.h"
#include "fem/pipeline/study/study_checks.h"
#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/numbers.h"
#include "fem/pipeline/support/text.h"
#include "fem/pipeline/system/console.h"
#include "fem/pipeline/system/program.h"
#include "fem/pipeline/system/ranks.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <thread>

namespace stemware::pipeline
{

namespace
{

/// An empty name is a mistake (a variable that is not set), not the wish for the default study.
std::string why_no_study(const std::string &text)
{
  return text.empty()
           ? "the name of the study is empty; give the path of a .prm file, or omit it for the default study"
           : "";
}

/// An empty name of a folder is a mistake too, and so are blanks, which no listing would show.
std::string why_no_folder(const std::string &text)
{
  return text.find_first_not_of(" \t\r\n") == std::string::npos
           ? "the name of the folder is empty; give a path, or omit --output for the default"
           : "";
}

} // namespace

void print_note(const std::string &label, const std::string &note)
{
  if (!note.empty())
    console() << wrapped(note, label) << std::endl;
}

void add_study_option(CLI::App &verb, StudyOptions &options, const std::string &role)
{
  verb
    .add_option("STUDY", options.study_file,
                "Study file, .prm or .json, - for standard input" + (role.empty() ? "" : ", " + role) +
                  ";\ndefault: the default study")
    ->check(why_no_study);
}

void add_output_option(CLI::App &verb, StudyOptions &options, const std::string &help)
{
  verb.add_option("--output", options.output, help)->type_name("DIR")->check(why_no_folder);
}

void add_study_options(CLI::App &verb, StudyOptions &options)
{
  options.verb = verb.get_name();
  add_study_option(verb, options);
  add_output_option(verb, options,
                    "Folder of the results; default: results/<name of the study>" +
                      std::string(options.verb == "run" ? "" : "-" + options.verb));
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
  verb.add_flag("--quiet", options.quiet, "Print nothing unless something is wrong");
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
  for (const std::string &note : implausible_notes(study)) // a slip of a unit is behind most of them
    print_note("Check     ", note);
  require_no_tipping_at_rest(study);
  print_note("Profile   ", profile_note(study));
  const std::string &spins = study.motion.measured_spin_file;
  print_note("Measured  ",
             spins.empty() ? "" : read_measured_run(spins, study.motion.measured_column).summary);
  if (options.verb != "sweep") // its cases have studies of their own
  {
    print_note("Unused    ", unused_entries_note(unused_entries(study)));
    print_note("Memory    ", memory_note(study));
  }
  load_modules_of(study);
  return study;
}

} // namespace stemware::pipeline
