#include "fem/pipeline/app/converge.h"
#include "fem/pipeline/app/verbs.h"

#include <CLI/CLI.hpp>

#include <memory>

namespace stemware::pipeline
{

void add_converge_verb(CLI::App &program, Verb &chosen)
{
  const auto options = std::make_shared<ConvergeOptions>();
  CLI::App *verb = program.add_subcommand("converge", "Refine a study: observed orders, limits, error bands");
  add_study_options(*verb, options->study);
  verb
    ->add_option("--levels", options->n_levels,
                 "Levels of each parameter; default 3, which an observed order needs")
    ->check(CLI::Range(2, 5))
    ->type_name("N");
  add_spin_option(*verb, options->spins, "half and one and a half times the terminal spin");
  verb->footer(R"(Examples:
  stemware converge docs/cookbooks/paper.prm
  stemware converge docs/cookbooks/lift_off.prm --levels 4 --at -5 --at -10
  stemware converge docs/cookbooks/paper.prm --set "Contact/Degree=3" --output cubic
  stemware converge my_glass.prm --quiet --json | jq .omega_terminal_band

One parameter at a time is varied round the study's own value. A body of revolution: halvings of the
meridional mesh, degree, elastic harmonics, azimuth lines. A solid body: cells round the rim, across
the land, through the foot, degree; that takes minutes.
  summary.json       values, orders, limits and bands of every quantity; the parameters
  report.html        the same for eyes
  converge_*.dat     one row a level
  error_bands.dat    values, half-widths of their bands, Richardson values)");
  verb->callback([&chosen, options] { chosen = [options] { converge(*options); }; });
}

} // namespace stemware::pipeline
