#include "fem/pipeline/app/verbs.h"
#include "fem/pipeline/study/presets.h"
#include "fem/pipeline/study/study_entries.h"
#include "fem/pipeline/support/console.h"
#include "fem/pipeline/support/program.h"

#include <CLI/CLI.hpp>
#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/join.hpp>
#include <boost/algorithm/string/replace.hpp>

#include <memory>
#include <ostream>

namespace stemware::pipeline
{

namespace
{

using Words = std::vector<std::string>;

/// The verbs that --help lists.
std::vector<const CLI::App *> shown_verbs(const CLI::App &program)
{
  return program.get_subcommands([](const CLI::App *verb) { return !verb->get_group().empty(); });
}

/// Text as troff shows it as it stands.
std::string roff(std::string text)
{
  boost::replace_all(text, "\\", "\\e");
  boost::replace_all(text, "-", "\\-");
  boost::replace_all(text, "\n", "\n\\&"); // a line that begins with a dot is none of troff's
  return "\\&" + text;
}

/// The text of --help under a heading of its own.
std::string man_section(const std::string &heading, const CLI::App &app, const std::string &name)
{
  return ".SH " + heading + "\n.in 2n\n.nf\n" +
         roff(app.get_formatter()->make_help(&app, name, CLI::AppFormatMode::Normal)) + "\n.fi\n.in\n";
}

/// The manual page: what --help says of the program and of every verb.
std::string man_page(const CLI::App &program)
{
  std::string page =
    ".TH STEMWARE 1 \"\" \"stemware " + program_version() +
    "\" \"Stemware\"\n.SH NAME\nstemware \\- spin of a wine glass on its elastic foot\n.SH SYNOPSIS\n"
    "\\fBstemware\\fR \\fIVERB\\fR [\\fIOPTIONS\\fR]\n" +
    man_section("DESCRIPTION", program, "stemware");
  for (const CLI::App *verb : shown_verbs(program))
    page += man_section("STEMWARE " + boost::to_upper_copy(verb->get_name()), *verb,
                        "stemware " + verb->get_name());
  return page;
}

/// Words that may follow some options, which are named as "--one | --other".
std::vector<std::pair<std::string, Words>> option_values()
{
  Study study;
  Words entries;
  for (const StudyEntry &entry : study_entries(study))
    entries.push_back(entry.path());
  return { { "--set | --vary | --random", entries },
           { "--glass", names_of(glass_presets()) },
           { "--table", names_of(table_presets()) },
           { "--cookbook", cookbook_names() } };
}

/// Words that may follow some verbs, but for options and files.
std::vector<std::pair<std::string, Words>> verb_values(const CLI::App &program)
{
  Study study;
  Words verbs;
  for (const CLI::App *verb : shown_verbs(program))
    verbs.push_back(verb->get_name());
  return { { "help", verbs }, { "defaults", sections_of(study_entries(study)) } };
}

/// Names of the options of @p app and what they mean, in one line each.
std::vector<std::pair<std::string, std::string>> described_options(const CLI::App &app)
{
  std::vector<std::pair<std::string, std::string>> options;
  for (const CLI::Option *option : app.get_options())
    for (const std::string &name : option->get_lnames())
      options.emplace_back("--" + name, boost::replace_all_copy(option->get_description(), "\n", " "));
  return options;
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

std::string bash_completion(const CLI::App &program)
{
  std::string text = R"(# Completion of stemware for bash, written by `stemware describe bash`.
_stemware()
{
  local word=${2//\\/} candidate
  local -a candidates=()
  case $3 in
)";
  for (const auto &[options, values] : option_values())
    text += "  " + options + ")\n    compopt -o filenames\n    candidates=(" + shell_words(values) + ") ;;\n";
  text += "  *)\n    case $COMP_CWORD:${COMP_WORDS[1]}:$word in\n    1:*) candidates=(";
  for (const CLI::App *verb : shown_verbs(program))
    text += shell_word(verb->get_name()) + " ";
  text += "'--help' '--version') ;;\n";
  for (const CLI::App *verb : shown_verbs(program))
  {
    Words names;
    for (const auto &[name, description] : described_options(*verb))
      names.push_back(name);
    text += "    *:" + verb->get_name() + ":-*) candidates=(" + shell_words(names) + ") ;;\n";
  }
  for (const auto &[verb, values] : verb_values(program))
    text += "    *:" + verb + ":*) candidates=(" + shell_words(values) + ") ;;\n";
  return text + R"(    esac ;;
  esac
  # Of entries, Section/Entry, the section first.
  for candidate in "${candidates[@]}"; do
    [[ $candidate == "$word"* ]] || continue
    [[ $word == */* || $candidate != */* ]] || candidate=${candidate%%/*}/
    COMPREPLY+=("$candidate")
  done
  [[ ${COMPREPLY[*]} != */* ]] || compopt -o nospace
}
complete -o default -F _stemware stemware
)";
}

/// A word and its meaning for zsh's _describe.
std::string zsh_item(const std::string &word, const std::string &meaning)
{
  return shell_word(boost::replace_all_copy(word, ":", "\\:") + ":" + meaning) + " ";
}

std::string zsh_completion(const CLI::App &program)
{
  std::string text = R"(#compdef stemware
# Completion of stemware for zsh, written by `stemware describe zsh`.
local -a verbs options
case $words[CURRENT-1] in
)";
  for (const auto &[options, values] : option_values())
    text += "(" + options + ")\n  compadd " + (options == "--set | --vary | --random" ? "-S = " : "") +
            "-- " + shell_words(values) + "\n  return ;;\n";
  text += "esac\nif ((CURRENT == 2)); then\n  verbs=(";
  for (const CLI::App *verb : shown_verbs(program))
    text += zsh_item(verb->get_name(), verb->get_description());
  text += ")\n  _describe verb verbs\n  return\nfi\ncase $words[2] in\n";
  for (const auto &[verb, values] : verb_values(program))
    text += "(" + verb + ")\n  compadd -- " + shell_words(values) + "\n  return ;;\n";
  for (const CLI::App *verb : shown_verbs(program))
  {
    text += "(" + verb->get_name() + ")\n  options=(";
    for (const auto &[name, meaning] : described_options(*verb))
      text += zsh_item(name, meaning);
    text += ") ;;\n";
  }
  return text + R"(esac
if [[ $PREFIX == -* ]]; then
  _describe -o option options
else
  _files
fi
)";
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
        console() << (*format == "man"    ? man_page(program)
                      : *format == "bash" ? bash_completion(program)
                                          : zsh_completion(program))
                  << std::flush;
      };
    });
}

} // namespace stemware::pipeline
