#include "fem/pipeline/app/verbs.h"
#include "fem/pipeline/base/console.h"
#include "fem/pipeline/base/failures.h"
#include "fem/pipeline/base/output.h"
#include "fem/pipeline/base/ranks.h"
#include "fem/pipeline/base/text.h"
#include "fem/pipeline/study/presets.h"

#include <CLI/CLI.hpp>
#include <boost/algorithm/string/join.hpp>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <ostream>

namespace stemware::pipeline
{

namespace
{

struct NewOptions
{
  std::string file, glass = glass_presets().front().name, table = table_presets().front().name, cookbook;
};

/// Writes the study @p file (the first of @p parts: paths and texts) and the files that the study reads.
/// Writes nothing and throws OutputFailure if a file already exists.
void write_study(const std::string &file,
                 const std::vector<std::pair<std::filesystem::path, std::string>> &parts,
                 const std::string &words)
{
  ensure(file.find_first_not_of(" \t") != std::string::npos,
         "The name of the study file is empty; write stemware new my_glass.prm.");
  const auto is_control = [](unsigned char letter) { return std::iscntrl(letter); };
  ensure(
    std::none_of(file.begin(), file.end(), is_control),
    "The name of the study file has a line end or another control character, which the file's first comment "
    "cannot have; write stemware new my_glass.prm.");
  ensure(std::filesystem::path(file).extension() == ".prm", "A study file ends in .prm, but " +
                                                              shortened_path(file) +
                                                              " does not; write stemware new my_glass.prm.");
  on_first_rank(
    [&parts]
    {
      for (const auto &part : parts)
        require_writable(part.first);
      for (const auto &[path, text] : parts)
        write_output_file(path, text);
    });
  console() << "Written   " << file << words;
  for (std::size_t i = 1; i < parts.size(); ++i)
    console() << (i == 1 ? ", and what it reads: " : ", ") << parts[i].first.string();
  console() << "\nNext      stemware run " << file << std::endl;
}

std::string list_of(const std::vector<Preset> &presets)
{
  std::string lines;
  for (const Preset &preset : presets)
    lines += fmt::format(FMT_STRING("  {:<14} {}\n"), preset.name, preset.words);
  return lines;
}

} // namespace

void add_new_verb(CLI::App &program)
{
  const auto options = std::make_shared<NewOptions>();
  CLI::App *verb = program.add_subcommand("new", "Write a study file of twelve entries to start from");
  const CLI::Option *file = verb->add_option(
    "FILE", options->file,
    "Study file to write, .prm; one that exists is not overwritten.\nOf a cookbook, default: its name");
  CLI::Option *glass = verb->add_option("--glass", options->glass, "Which glass; default: " + options->glass)
                         ->type_name("GLASS");
  CLI::Option *table = verb->add_option("--table", options->table, "Which table; default: " + options->table)
                         ->type_name("TABLE");
  const CLI::Option *cookbook =
    verb
      ->add_option("--cookbook", options->cookbook,
                   "The study of a cookbook instead, with the files that it reads")
      ->type_name("NAME")
      ->excludes(glass)
      ->excludes(table);
  verb->footer(""); // clears the footer that the verb inherits from the program
  // The footer is created only for --help, because reading the folder of cookbooks takes time.
  verb->footer(
    []
    {
      const std::vector<std::string> names = cookbook_names();
      const std::string cookbooks =
        names.empty() ? "" : "\n\nCookbooks:\n" + wrapped(boost::algorithm::join(names, ", "), "  ");
      return filled(help_of("new"), { list_of(glass_presets()), list_of(table_presets()), cookbooks });
    });
  verb->callback(
    [options, file, cookbook]
    {
      const bool is_cookbook = cookbook->count() > 0;
      if (file->count() == 0 && !is_cookbook)
        throw CLI::RequiredError("FILE");
      const auto &[given, glass, table, recipe] = *options;
      const std::string name = given.empty() && is_cookbook ? recipe + ".prm" : given;
      if (is_cookbook)
        return write_study(name, cookbook_parts(recipe, name), ", the study of the cookbook " + recipe);
      const Preset &of_glass = preset_of(glass_presets(), "--glass", glass);
      const Preset &of_table = preset_of(table_presets(), "--table", table);
      write_study(name, { { name, new_study_text(of_glass, of_table, name) } },
                  ": " + of_glass.name + " on " + of_table.name);
    });
}

} // namespace stemware::pipeline
