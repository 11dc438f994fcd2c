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

/// The work of the verb that was chosen on the command line, its options included.
using Verb = std::function<void()>;

/// The examples and explanations help/@p name.txt that end the help of a verb.
std::string help_of(const std::string &name);

/// Adds a verb, with the examples and explanations that end its help. When it is chosen, @p chosen becomes
/// its @p work.
CLI::App *add_verb(CLI::App &program, Verb &chosen, const std::string &name, const std::string &words,
                   const Verb &work);

/// The verbs in the order of --help. Each has a function add_NAME_verb(), which adds its options and work.
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

#define STEMWARE_VERB(name) void add_##name##_verb(CLI::App &program, Verb &chosen);
STEMWARE_VERBS(STEMWARE_VERB)
#undef STEMWARE_VERB

} // namespace stemware::pipeline
