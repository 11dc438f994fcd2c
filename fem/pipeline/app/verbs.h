#pragma once

#include "fem/pipeline/support/failures.h"

#include <functional>
#include <optional>
#include <string>

// NOLINTNEXTLINE(readability-identifier-naming): the library's name
namespace CLI
{
class App;
}

namespace stemware::pipeline
{

/// The work of the verb that was chosen on the command line, its options included.
using Verb = std::function<void()>;

/// The examples and explanations help/@p name.txt that end the help of a verb.
std::string help_of(const std::string &name);

/// Adds a verb, with the examples and explanations that end its help. When it is chosen, @p chosen becomes
/// its
/// @p work.
CLI::App *add_verb(CLI::App &program, Verb &chosen, const std::string &name, const std::string &words,
                   const Verb &work);

/// Adds to the program the parts that all verbs share: version, exit codes, first examples.
void describe_program(CLI::App &program);

/// `stemware new`: a study file of a glass on a table to start from.
void add_new_verb(CLI::App &program, Verb &chosen);

/// `stemware run`: a study from its file to its results.
void add_run_verb(CLI::App &program, Verb &chosen);

/// `stemware truncate`: a study with fewer and fewer harmonics of its load.
void add_truncate_verb(CLI::App &program, Verb &chosen);

/// `stemware compare`: closures, loads and truncations side by side.
void add_compare_verb(CLI::App &program, Verb &chosen);

/// `stemware sweep`: a study many times, with other values each time.
void add_sweep_verb(CLI::App &program, Verb &chosen);

/// `stemware slide`: a glass, a ring or a disc that is pushed and let go.
void add_slide_verb(CLI::App &program, Verb &chosen);

/// `stemware explore`: a page that solves a study again at every move of a slider.
void add_explore_verb(CLI::App &program, Verb &chosen);

/// `stemware mesh`: a foot mesh, written or looked at.
void add_mesh_verb(CLI::App &program, Verb &chosen);

/// `stemware converge`: a study on ever finer levels; observed orders and error bands.
void add_converge_verb(CLI::App &program, Verb &chosen);

/// `stemware defaults`: a commented study file of all defaults, or of one section, on standard output.
void add_defaults_verb(CLI::App &program, Verb &chosen);

/// `stemware help`: the text of --help, of the program or of a verb.
void add_help_verb(CLI::App &program, Verb &chosen);

/// `stemware describe`, which --help does not list: manual page and completions of shells, for installing.
void add_describe_verb(CLI::App &program, Verb &chosen);

/// A sentence that says that there is no verb of that name, and which there are.
std::string why_no_verb(const CLI::App &program, const std::string &name);

/// Parses; an exit code when there is nothing left to do: after --help and --version, and after a usage
/// error, which is reported in one sentence.
std::optional<ExitCode> parse_command_line(CLI::App &program, int argc, char *argv[]);

} // namespace stemware::pipeline
