#include "fem/pipeline/truncate/truncate.h"
#include "fem/pipeline/verbs.h"

#include <CLI/CLI.hpp>

#include <cmath>
#include <memory>

namespace stemware::pipeline
{

namespace
{

/// A spin that is a number.
std::string why_no_spin(const std::string &text)
{
  double omega = 0;
  return CLI::detail::lexical_cast(text, omega) && std::abs(omega) <= 1e6
           ? ""
           : "\"" + text + "\" is not a spin; give a number between -1e6 and 1e6, in rad/s";
}

} // namespace

void add_truncate_verb(CLI::App &program, Verb &chosen)
{
  const auto options = std::make_shared<TruncateOptions>();
  CLI::App *verb = program.add_subcommand(
    "truncate", "How many harmonics of the load matter, with and without their friction");
  add_study_options(*verb, options->study);
  verb
    ->add_option("--at", options->omega,
                 "Spin at which the torque is shown (rad/s), may be repeated;\n"
                 "default: the terminal spin of all harmonics, and half of it")
    ->type_name("OMEGA")
    ->check(why_no_spin)
    ->allow_extra_args(false);
  verb->footer(R"(Examples:
  stemware truncate docs/cookbooks/paper.prm
  stemware truncate docs/cookbooks/lift_off.prm --at -5 --at -20
  stemware truncate my_glass.prm --set "Motion/Closure=full" --set "Load/Coupling=exact"

The load is cut off after 1, 2, 3, 4, 6, 8, 12 ... harmonics in two ways: frozen, where the load of
all harmonics loses some and nothing answers to that; and self-consistent, where the friction of what
is left enters the balance of moments, the moment enters the contact, and the contact's load is cut
off again.

  truncation.dat, truncation_self_consistent.dat   torque, terminal spin, deviations, bounds
  spin_up.dat, spin_up_self_consistent.dat         the spin against time
  harmonics.dat                                    the load at rest; Load/File reads it
  report.html, figures/, summary.json, parameters.prm, timings.json)");
  verb->callback([&chosen, options] { chosen = [options] { truncate(*options); }; });
}

} // namespace stemware::pipeline
