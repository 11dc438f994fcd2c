#include "fem/pipeline/app/run.h"
#include "fem/pipeline/app/verbs.h"

#include <CLI/CLI.hpp>

#include <memory>

namespace stemware::pipeline
{

void add_run_verb(CLI::App &program, Verb &chosen)
{
  const auto options = std::make_shared<StudyOptions>();
  CLI::App *verb =
    program.add_subcommand("run", "Compute a study: contact, load harmonics, torque, spin, truncations");
  add_study_options(*verb, *options);
  verb->footer(R"(Examples:
  stemware run docs/cookbooks/paper.prm
  stemware run docs/cookbooks/lift_off.prm --output soft --set "Table/Foundation modulus=1e9"
  stemware run my_glass.prm --set "Load/Source=first harmonic" --set "Motion/Closure=full"
  stemware run my_glass.prm --set "Contact/Mesh file=meshes/crowned_foot.msh"
  stemware run my_glass.prm --quiet --json | jq .omega_terminal
  mpirun -n 4 stemware run my_glass.prm --set "Contact/Azimuthal cells=192"

The folder of results appears when all of it is there; older results of the same name are replaced.
  report.html        the answer, its figures and what is behind it, for a browser
  figures/           the figures as SVG and PDF, with gnuplot scripts and data
  summary.json       load harmonics, torque, terminal spin, truncations, closures, the parameters
  parameters.prm     the study as it was run
  load.dat           lambda(theta)
  harmonics.dat      its Fourier coefficients; may be read again through Load/File
  torque.dat         tau_z, T_x, T_y against the spin
  spin_up.dat        the spin against time
  truncation.dat     the answer after 1, 2, 3, 4, 6, 8 ... harmonics
  contact_history.dat, fields/contact.vtu, timings.json)");
  verb->callback([&chosen, options] { chosen = [options] { run(*options); }; });
}

} // namespace stemware::pipeline
