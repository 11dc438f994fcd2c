#include "fem/pipeline/app/verbs.h"
#include "fem/pipeline/report/filled_text.h"
#include "fem/pipeline/study/presets.h"
#include "fem/pipeline/study/study_entries.h"
#include "fem/pipeline/support/console.h"
#include "fem/pipeline/support/program.h"
#include "fem/pipeline/support/shared_files.h"

#include <CLI/CLI.hpp>
#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/join.hpp>
#include <boost/algorithm/string/replace.hpp>

#include <memory>
#include <ostream>

namespace stemware::pipeline
{

/// The files of completions/.
const CompiledTexts &compiled_completions();

namespace
{

using Json = nlohmann::ordered_json;
using Words = std::vector<std::string>;

/// Text as troff shows it as it stands.
std::string roff(std::string text)
{
  boost::replace_all(text, "\\", "\\e");
  boost::replace_all(text, "-", "\\-");
  boost::replace_all(text, "\n", "\n\\&"); // a line that begins with a dot is none of troff's
  return "\\&" + text;
}

/// The text of --help for a section of the manual page.
Json man_section(const std::string &heading, const CLI::App &app, const std::string &name)
{
  return { { "heading", heading },
           { "text", roff(app.get_formatter()->make_help(&app, name, CLI::AppFormatMode::Normal)) } };
}

/// A word as a shell takes it.
std::string shell_word(const std::string &word)
{
  return "'" + boost::replace_all_copy(word, "'", "'\\''") + "'";
}

/// Several, in one line.
std::string shell_words(Words words)
{
  for (std::string &word : words)
    word = shell_word(word);
  return boost::algorithm::join(words, " ");
}

/// A word and its meaning for zsh's _describe.
std::string zsh_item(const std::string &word, const std::string &meaning)
{
  return shell_word(boost::replace_all_copy(word, ":", "\\:") + ":" + meaning) + " ";
}

/// Facts for the templates in completions/: words for bash, items for zsh, sections of the manual page.
Json description_of(const CLI::App &program)
{
  Study study;
  const std::vector<StudyEntry> all = study_entries(study);
  Words entries, verb_names;
  for (const StudyEntry &entry : all)
    entries.push_back(entry.path());
  Json verbs = Json::array(), sections = Json::array();
  sections.push_back(man_section("DESCRIPTION", program, "stemware"));
  const auto is_listed = [](const CLI::App *verb) { return !verb->get_group().empty(); };
  for (const CLI::App *verb : program.get_subcommands(is_listed))
  {
    const std::string name = verb->get_name();
    verb_names.push_back(name);
    Words option_names;
    std::string option_items;
    for (const CLI::Option *option : verb->get_options())
      for (const std::string &option_name : option->get_lnames())
      {
        option_names.push_back("--" + option_name);
        option_items +=
          zsh_item(option_names.back(), boost::replace_all_copy(option->get_description(), "\n", " "));
      }
    verbs.push_back({ { "name", name },
                      { "word", shell_word(name) },
                      { "item", zsh_item(name, verb->get_description()) },
                      { "option_words", shell_words(option_names) },
                      { "option_items", option_items } });
    sections.push_back(man_section("STEMWARE " + boost::to_upper_copy(name), *verb, "stemware " + name));
  }
  // Options by their names, "--one | --other".
  const auto after_options = [](const std::string &options, const Words &values, bool are_entries = false) {
    return Json{ { "options", options }, { "values", shell_words(values) }, { "are_entries", are_entries } };
  };
  const auto after_verb = [](const std::string &verb, const Words &values) {
    return Json{ { "verb", verb }, { "values", shell_words(values) } };
  };
  return { { "version", program_version() },
           { "man_sections", sections },
           { "verbs", verbs },
           { "option_values", Json::array({ after_options("--set | --vary", entries, true),
                                            after_options("--glass", names_of(glass_presets())),
                                            after_options("--table", names_of(table_presets())),
                                            after_options("--cookbook", cookbook_names()) }) },
           { "verb_values",
             Json::array({ after_verb("help", verb_names), after_verb("defaults", sections_of(all)) }) } };
}

} // namespace

void add_describe_verb(CLI::App &program, Verb &chosen)
{
  const auto format = std::make_shared<std::string>();
  CLI::App *verb = program.add_subcommand("describe", "Print the manual page, or completions for a shell");
  verb->group(""); // for those who install the program
  verb->add_option("FORMAT", *format, "man, bash or zsh")
    ->required()
    ->check([](const std::string &text)
            { return text == "man" || text == "bash" || text == "zsh" ? "" : "give man, bash or zsh"; });
  verb->footer(help_of("describe"));
  verb->callback(
    [&program, &chosen, format]
    {
      chosen = [&program, format]
      {
        const std::string &text = text_of(compiled_completions(), *format + ".txt");
        console() << filled(text, description_of(program), nullptr, *format) << std::flush;
      };
    });
}

} // namespace stemware::pipeline
