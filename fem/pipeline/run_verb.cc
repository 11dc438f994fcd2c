#include "fem/pipeline/run.h"
#include "fem/pipeline/verbs.h"

#include <CLI/CLI.hpp>

#include <memory>

namespace stemware::pipeline
{

void add_run_verb(CLI::App &program, Verb &chosen)
{
  const auto options = std::make_shared<RunOptions>();
  CLI::App *verb =
    program.add_subcommand("run", "Compute a study: contact, load harmonics, torque, spin, truncations");
  verb->add_option("STUDY", options->study_file, "Study file, .prm or .json")->required();
  verb
    ->add_option("--output", options->output,
                 "Folder of the results; default: results/<name of the study file>")
    ->type_name("DIR");
  verb->add_option("--set", options->overrides, "Replaces one entry of the study file; may be repeated")
    ->type_name("\"Section/Entry=value\"")
    ->allow_extra_args(false);
  verb->footer(R"(Examples:
  stemware run docs/cookbooks/paper.prm
  stemware run docs/cookbooks/lift_off.prm --output results/soft --set "Table/Foundation modulus=1e9"
  stemware run docs/cookbooks/paper.prm --set "Load/Source=first harmonic" --set "Motion/Closure=full"
  stemware run my_glass.prm --set "Contact/Mesh file=meshes/crowned_foot.msh"
  mpirun -n 4 stemware run my_glass.prm --set "Contact/Azimuthal cells=192"

The folder of results appears when all of it is there; older results of the same name are replaced.
  summary.json       load harmonics, torque, terminal spin, truncations, closures, and the parameters
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
