#include "fem/pipeline/app/verbs.h"
#include "fem/pipeline/study/study_file.h"
#include "fem/pipeline/support/console.h"

#include <CLI/CLI.hpp>

namespace stemware::pipeline
{

void add_defaults_verb(CLI::App &program, Verb &chosen)
{
  CLI::App *verb =
    program.add_subcommand("defaults", "Print a study file with every entry, its meaning and its default");
  verb->footer(R"(Examples:
  stemware defaults
  stemware defaults > my_glass.prm       then change what differs, and delete the rest
  stemware defaults | grep -A 3 radius)");
  verb->callback([&chosen] { chosen = [] { console() << commented_defaults() << std::flush; }; });
}

} // namespace stemware::pipeline
