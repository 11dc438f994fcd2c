#include "fem/pipeline/base/program.h"

#include "fem/pipeline/app/verbs.h"
#include "fem/pipeline/base/console.h"
#include "fem/pipeline/base/failures.h"
#include "fem/pipeline/base/json.h"
#include "fem/pipeline/base/ranks.h"
#include "fem/pipeline/base/text.h"
#include "fem/pipeline/base/text_file.h"
#include "fem/pipeline/coupling/failure_sentence.h"

#include <deal.II/base/multithread_info.h>

#include <CLI/CLI.hpp>

#include <csignal>
#include <iostream>
#include <memory>
#include <optional>

namespace stemware::pipeline
{

/// Returns the files help/*.txt, which are compiled into the program.
const CompiledTexts &compiled_help();

namespace
{

std::vector<std::string> verbs_of(const CLI::App &program)
{
  std::vector<std::string> names;
  for (const CLI::App *verb : program.get_subcommands([](const CLI::App *) { return true; }))
    names.push_back(verb->get_name());
  return names;
}

std::vector<std::string> options_of(const CLI::App &verb)
{
  std::vector<std::string> names;
  for (const CLI::Option *option : verb.get_options())
    for (const std::string &name : option->get_lnames())
      names.push_back("--" + name);
  return names;
}

/// Returns the error message for an unknown @p word. It suggests a similar known word, if there is one, and
/// ends with "see"; the caller appends a reference.
std::string not_known(const std::string &word, const std::vector<std::string> &known,
                      const std::string &otherwise)
{
  const auto meant = closest_match(word, known);
  return "\"" + shortened(word) + "\" is " + otherwise +
         (meant ? "; did you mean " + *meant + "? See" : "; see");
}

std::string describe_error(const CLI::App &program, const CLI::ParseError &error)
{
  const auto chosen = program.get_subcommands();
  const CLI::App &verb = chosen.empty() ? program : *chosen.front();
  const std::vector<std::string> known = chosen.empty() ? verbs_of(program) : options_of(verb);
  const std::vector<std::string> rest = verb.remaining();
  if (!rest.empty())
    return not_known(rest.front(), known,
                     chosen.empty() ? "not one of the verbs " + listed(known, "and")
                                    : "not expected by " + verb.get_name());
  return chosen.empty() ? "say what to do: one of " + listed(known, "and") + "; see"
                        : shortened(error.what(), 160) + "; see";
}

/// Parses the command line and runs the chosen verb. Prints --help, --version and usage errors.
ExitCode run_verb(CLI::App &program, int argc, char *argv[])
{
  for (CLI::App *verb : program.get_subcommands([](CLI::App *) { return true; }))
    verb->group("Verbs");
  try
  {
    program.parse(argc, argv);
    return ExitCode::success;
  }
  catch (const CLI::Success &request)
  {
    program.exit(request);
    return ExitCode::success;
  }
  catch (const CLI::ParseError &error)
  {
    const auto verbs = program.get_subcommands();
    std::cerr << "stemware: " << describe_error(program, error) << " `stemware "
              << (verbs.empty() ? "" : verbs.front()->get_name() + " ") << "--help` for examples."
              << std::endl;
    return ExitCode::bad_input;
  }
}

/// Throws BadInput for arguments that are not UTF-8: arguments become part of the results, which are UTF-8.
void require_utf8(int argc, char *argv[])
{
  for (int i = 1; i < argc; ++i)
    ensure(is_utf8(argv[i]), "\"" + shortened(argv[i]) +
                               "\" on the command line is not in UTF-8; rename the file, or set a locale of "
                               "UTF-8 (LANG=C.UTF-8).");
}

} // namespace

std::string help_of(const std::string &name)
{
  const std::string &text = text_of(compiled_help(), name + ".txt");
  return text.substr(0, text.size() - 1); // CLI11 adds the final line break
}

CLI::App *add_verb(CLI::App &program, const std::string &name, const std::string &words,
                   const std::function<void()> &work)
{
  CLI::App *verb = program.add_subcommand(name, words);
  verb->footer(help_of(name));
  verb->callback(work);
  return verb;
}

void add_help_verb(CLI::App &program)
{
  const auto topic = std::make_shared<std::string>();
  const auto explain = [&program, topic]
  {
    const CLI::App *found = topic->empty() ? &program : nullptr;
    for (const CLI::App *candidate : program.get_subcommands([](const CLI::App *) { return true; }))
      if (candidate->get_name() == *topic)
        found = candidate;
    if (found == nullptr)
    {
      const std::vector<std::string> verbs = verbs_of(program);
      throw BadInput(not_known(*topic, verbs, "not one of the verbs " + listed(verbs, "and")) +
                     " `stemware --help` for examples.");
    }
    const std::string name = program.get_name() + (topic->empty() ? "" : ' ' + *topic);
    console() << found->get_formatter()->make_help(found, name, CLI::AppFormatMode::Normal) << std::flush;
  };
  add_verb(program, "help", "Print this text, or that of a verb", explain)
    ->add_option("VERB", *topic, "Verb to explain; default: a summary of all verbs");
}

int run_program(int argc, char *argv[])
{
  open_missing_streams();
  // deal.II's own threads would compete with the threads of the study, and the rounding of sums would depend
  // on the number of cores.
  dealii::MultithreadInfo::set_thread_limit(1);
  std::signal(SIGXFSZ, SIG_IGN); // a write beyond `ulimit -f` then fails instead of ending the program
  std::optional<MpiSession> mpi; // destroyed last, after all users of MPI
  try
  {
    mpi.emplace();
    require_utf8(argc, argv);
    CLI::App program("Stemware: the spin of a wine glass on a table, with an elastic foot.", "stemware");
    program.require_subcommand(1);
    program.get_formatter()->label("SUBCOMMAND", "VERB");
    program.set_version_flag("--version", "stemware " + program_version() + " (" + program_revision() + ")");
    program.set_help_flag("-h,--help", "Show this text, or that of a verb: stemware run --help");
    program.footer(help_of("stemware"));
#define STEMWARE_VERB(name) add_##name##_verb(program);
    STEMWARE_VERBS(STEMWARE_VERB)
    const ExitCode exit_code = run_verb(program, argc, argv);
    require_printed();
    return static_cast<int>(exit_code);
  }
  catch (...)
  {
    return static_cast<int>(report_failure());
  }
}

} // namespace stemware::pipeline
