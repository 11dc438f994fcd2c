#include "fem/pipeline/app/compare.h"
#include "fem/pipeline/app/verbs.h"

#include <CLI/CLI.hpp>

#include <memory>

namespace stemware::pipeline
{

void add_compare_verb(CLI::App &program, Verb &chosen)
{
  const auto options = std::make_shared<StudyOptions>();
  CLI::App *verb =
    program.add_subcommand("compare", "Closures, loads and truncations side by side: what changes the spin");
  add_study_options(*verb, *options);
  verb->footer(R"(Examples:
  stemware compare docs/cookbooks/paper.prm
  stemware compare my_glass.prm --set "Table/Foundation modulus=1e9"
  stemware compare my_glass.prm --set "Load/Source=first harmonic"    # no elastic foot

The glass of the study under the closures paper, hand and full, on five kinds of load: the paper's
first harmonic; a rigid rim, flat and round, on a soft mat; and the elastic foot, with its load at
rest and in balance with friction at every spin (a solid body with Load/Coupling = exact only). Each
with 1, 2, 3 and all harmonics. A row that does not exist says why: tips, no balance, no terminal
spin. "formal" loads would have to pull on the table.

  compare.csv        one row for each closure, load and number of harmonics
  report.html, figures/, summary.json, parameters.prm, timings.json)");
  verb->callback([&chosen, options] { chosen = [options] { compare(*options); }; });
}

} // namespace stemware::pipeline
