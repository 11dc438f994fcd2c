#pragma once

#include <functional>
#include <string>

// NOLINTNEXTLINE(readability-identifier-naming): the library's name
namespace CLI
{
class App;
}

namespace stemware::pipeline
{

/// Returns the text of help/@p name.txt, the end of a verb's help.
std::string help_of(const std::string &name);

/// Adds a verb with help_of() @p name. If the verb is chosen, @p work runs when the command line is parsed.
CLI::App *add_verb(CLI::App &program, const std::string &name, const std::string &words,
                   const std::function<void()> &work);

/// Verbs in the order of --help. Each has a function add_NAME_verb(), which adds its options and work.
#define STEMWARE_VERBS(VERB)                                                                                 \
  VERB(run)      /* a study from its file to its results */                                                  \
  VERB(new)      /* a study file of a glass on a table to start from */                                      \
  VERB(truncate) /* a study with fewer and fewer harmonics of its load */                                    \
  VERB(sweep)    /* a study many times, with other values each time */                                       \
  VERB(explore)  /* a page that solves a study again at every move of a slider */                            \
  VERB(mesh)     /* a foot mesh, written or looked at */                                                     \
  VERB(converge) /* a study on ever finer levels; observed orders and error bands */                         \
  VERB(defaults) /* a commented study file of all defaults, or of one section, on standard output */         \
  VERB(help)     /* the text of --help, of the program or of a verb */

#define STEMWARE_VERB(name) void add_##name##_verb(CLI::App &program);
STEMWARE_VERBS(STEMWARE_VERB)
#undef STEMWARE_VERB

/// Runs the program `stemware` (argv[0] is its name) and returns the exit code. Call once per process: it
/// takes over signals, MPI and the standard streams.
int run_program(int argc, char *argv[]);

} // namespace stemware::pipeline
