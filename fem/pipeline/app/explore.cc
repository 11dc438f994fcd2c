#include "fem/pipeline/app/options.h"
#include "fem/pipeline/app/verbs.h"
#include "fem/pipeline/base/console.h"
#include "fem/pipeline/base/output.h"
#include "fem/pipeline/base/ranks.h"
#include "fem/pipeline/page/explore_page.h"

#include <CLI/CLI.hpp>

#include <fmt/format.h>
#include <memory>
#include <ostream>

namespace stemware::pipeline
{

namespace
{

struct ExploreOptions
{
  StudyOptions study;
  std::vector<std::string> glasses, tables;
  std::string file = "explore.html";
  unsigned int max_nodes = 0;
};

/// Preset of a rigid table, for pages only: a study file can set the two entries directly.
const Preset rigid_table = { "rigid",
                             "a table that yields nothing",
                             {},
                             "subsection Table\n  set Interface = hard\n  set Substrate = rigid\nend\n" };

void explore(const ExploreOptions &options)
{
  PageOptions wish;
  wish.study = begin_study(options.study);
  on_first_rank([&] { require_writable(options.file); });
  wish.n_threads = n_threads_of(options.study);
  wish.max_nodes = options.max_nodes;
  for (const std::string &name : options.glasses)
    wish.glasses.push_back(preset_of(glass_presets(), "--glass", name));
  for (const std::string &name : options.tables)
    wish.tables.push_back(name == rigid_table.name ? rigid_table
                                                   : preset_of(table_presets(), "--table", name));
  fem::ComplianceCache cache;
  ConsoleProgress progress;
  const std::string page = explore_page(wish, cache, progress);
  on_first_rank([&] { write_output_file(options.file, page); });
  console() << fmt::format(FMT_STRING("Written   {}, {:.0f} kB: open it in a browser\n"), options.file,
                           static_cast<double>(page.size()) / 1e3)
            << std::flush;
}

} // namespace

void add_explore_verb(CLI::App &program)
{
  const auto options = std::make_shared<ExploreOptions>();
  CLI::App *verb =
    add_verb(program, "explore", "Write a page that solves a study live, at every move of a slider",
             [options] { explore(*options); });
  options->study.verb = verb->get_name();
  add_study_option(*verb, options->study);
  verb->add_option("--glass", options->glasses, "Selectable glass of the page; may be repeated")
    ->type_name("GLASS")
    ->allow_extra_args(false);
  verb->add_option("--table", options->tables, "Selectable table of the page; may be repeated")
    ->type_name("TABLE")
    ->allow_extra_args(false);
  verb->add_option("--nodes", options->max_nodes, "Upper bound of the nodes across the rim on hard tables")
    ->type_name("N")
    ->check(CLI::Range(9, 10000).description(""));
  verb->add_option("--output", options->file, "The page; default: explore.html")->type_name("FILE");
  add_override_option(*verb, options->study);
  add_threads_option(*verb, options->study, "Threads that share the pairs");
  add_console_options(*verb, options->study);
}

} // namespace stemware::pipeline
