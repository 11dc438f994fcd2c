#include "fem/pipeline/app/verbs.h"
#include "fem/pipeline/base/console.h"
#include "fem/pipeline/study/study_file.h"

#include <CLI/CLI.hpp>

#include <memory>
#include <ostream>

namespace stemware::pipeline
{

void add_defaults_verb(CLI::App &program)
{
  const auto section = std::make_shared<std::string>();
  CLI::App *verb =
    add_verb(program, "defaults", "Print a study file with every entry, its meaning and its default",
             [section] { console() << commented_defaults(*section) << std::flush; });
  verb->add_option("SECTION", *section, "Motion, Glass, Table, Contact or Load; default: all of them");
}

} // namespace stemware::pipeline
