#include "fem/pipeline/app/truncate.h"
#include "fem/pipeline/app/verbs.h"

#include <CLI/CLI.hpp>

#include <memory>

namespace stemware::pipeline
{

void add_truncate_verb(CLI::App &program, Verb &chosen)
{
  const auto options = std::make_shared<TruncateOptions>();
  CLI::App *verb = program.add_subcommand(
    "truncate", "How many harmonics of the load matter, with and without their friction");
  add_study_options(*verb, options->study);
  add_spin_option(*verb, options->omega, "the terminal spin of all harmonics, and half of it");
  verb->footer(R"(Examples:
  stemware truncate docs/cookbooks/paper.prm
  stemware truncate docs/cookbooks/lift_off.prm --at -5 --at -20
  stemware truncate my_glass.prm --set "Motion/Closure=full" --set "Load/Coupling=exact"

The load is cut off after 1, 2, 3, 4, 6, 8, 12 ... harmonics in two ways: frozen, where the load of
all harmonics loses some and nothing answers to that; and self-consistent, where the friction of
what is left enters the balance of moments, the moment enters the contact, and the contact's load is
cut off again.

  truncation.dat, truncation_self_consistent.dat   torque, terminal spin, deviations, bounds
  spin_up.dat, spin_up_self_consistent.dat         the spin against time
  harmonics.dat                                    the load at rest; Load/File reads it
  report.html, figures/, summary.json, parameters.prm, timings.json)");
  verb->callback([&chosen, options] { chosen = [options] { truncate(*options); }; });
}

} // namespace stemware::pipeline
