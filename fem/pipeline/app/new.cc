#include "fem/pipeline/app/verbs.h"
#include "fem/pipeline/study/presets.h"
#include "fem/pipeline/support/console.h"
#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/ranks.h"
#include "fem/pipeline/support/text_file.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <ostream>

namespace stemware::pipeline
{

namespace
{

/// What `stemware new` was told.
struct NewOptions
{
  std::string file, glass = glass_presets().front().name, table = table_presets().front().name;
};

/// Writes the study file. Throws BadInput, and OutputFailure where there is one already.
void write_new_study(const NewOptions &options)
{
  const Preset &glass = preset_of(glass_presets(), "--glass", options.glass);
  const Preset &table = preset_of(table_presets(), "--table", options.table);
  require(options.file.find_first_not_of(" \t") != std::string::npos,
          "The name of the study file is empty; write stemware new my_glass.prm.");
  require(std::filesystem::path(options.file).extension() == ".prm",
          "A study file ends in .prm, but " + shortened_path(options.file) +
            " does not; write stemware new my_glass.prm.");
  on_first_rank([&] { create_text_file(options.file, new_study_text(glass, table, options.file)); });
  console() << "Written   " << options.file << ": " << glass.name << " on " << table.name
            << "\nNext      stemware run " << options.file << std::endl;
}

std::string list_of(const std::vector<Preset> &presets)
{
  std::string lines;
  for (const Preset &preset : presets)
    lines += fmt::format(FMT_STRING("  {:<14} {}\n"), preset.name, preset.words);
  return lines;
}

} // namespace

void add_new_verb(CLI::App &program, Verb &chosen)
{
  const auto options = std::make_shared<NewOptions>();
  CLI::App *verb = program.add_subcommand("new", "Write a study file of twelve entries to start from");
  verb->add_option("FILE", options->file, "Study file to write, .prm; one that exists is not overwritten")
    ->required();
  verb->add_option("--glass", options->glass, "Which glass; default: " + options->glass)->type_name("GLASS");
  verb->add_option("--table", options->table, "Which table; default: " + options->table)->type_name("TABLE");
  verb->footer(R"(Examples:
  stemware new my_glass.prm                                   the default study, to be changed
  stemware new bordeaux.prm --glass Bordeaux --table oak
  stemware new flute.prm --glass champagne --table "cork mat"

Glasses:
)" + list_of(glass_presets()) +
               "\nTables:\n" + list_of(table_presets()) +
               "\nSizes and moduli are typical ones; docs/presets.md says where each comes from.");
  verb->callback([&chosen, options] { chosen = [options] { write_new_study(*options); }; });
}

} // namespace stemware::pipeline
