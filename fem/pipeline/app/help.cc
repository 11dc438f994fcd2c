#include "fem/pipeline/app/verbs.h"
#include "fem/pipeline/support/console.h"

#include <CLI/CLI.hpp>

#include <memory>
#include <ostream>

namespace stemware::pipeline
{

void add_help_verb(CLI::App &program, Verb &chosen)
{
  const auto topic = std::make_shared<std::string>();
  CLI::App *verb = program.add_subcommand("help", "Print this text, or that of a verb");
  verb->add_option("VERB", *topic, "Verb to be explained; default: all of them in short");
  verb->footer(help_of("help"));
  verb->callback(
    [&program, &chosen, topic]
    {
      const CLI::App *found = topic->empty() ? &program : nullptr;
      for (const CLI::App *candidate : program.get_subcommands([](const CLI::App *) { return true; }))
        if (candidate->get_name() == *topic)
          found = candidate;
      if (found == nullptr)
        throw BadInput(why_no_verb(program, *topic));
      const std::string name = program.get_name() + (topic->empty() ? "" : ' ' + *topic);
      chosen = [found, name] {
        console() << found->get_formatter()->make_help(found, name, CLI::AppFormatMode::Normal) << std::flush;
      };
    });
}

} // namespace stemware::pipeline
