#include "fem/pipeline/analysis/refinement/error_bands.h"
#include "fem/pipeline/analysis/refinement/goal_mesh.h"
#include "fem/pipeline/analysis/spin_study.h"
#include "fem/pipeline/app/console_progress.h"
#include "fem/pipeline/app/options.h"
#include "fem/pipeline/app/verbs.h"
#include "fem/pipeline/coupling/contact_report.h"
#include "fem/pipeline/coupling/study_load.h"
#include "fem/pipeline/output/publish.h"
#include "fem/pipeline/output/run_results.h"
#include "fem/pipeline/support/ranks.h"

#include <CLI/CLI.hpp>

#include <memory>

namespace stemware::pipeline
{

namespace
{

/// What `run` is told.
struct RunOptions
{
  StudyOptions study;
  bool quick = false; ///< the answer and its curves alone
};

/// Solves a study and writes the folder of its results. Collective over all ranks. Throws BadInput,
/// OutputFailure, fem::ContactFailure, and std::runtime_error where there is no balance or no terminal spin.
void run(const RunOptions &run_options)
{
  const StudyOptions &options = run_options.study;
  const Depth depth = run_options.quick ? Depth::answer : Depth::full;

  // 1. What is asked for; everything that can be refused is refused here.
  Stopwatch stopwatch;
  ConsoleProgress progress(stopwatch);
  const Study given = begin_study(options);
  ResultsFolder folder(options.results_place());
  note_load_source(given, progress);
  stopwatch.finish("input");

  // 2. The load on the table, and what it does to the ring.
  fem::ComplianceCache cache;
  const Executor executor(cache, n_threads_of(options));
  const auto [study, goal] = mesh_for_goal(given, executor, progress);
  const std::shared_ptr<ElasticFoot> foot = announced_foot(study, executor, progress);
  const SharedLoad load = find_load(study, foot, progress);
  SpinStudy spin = study_spin(study, foot, *load, executor, progress, depth);
  const double last_spin = spin.all().last_spin().value();
  stopwatch.finish("ring");
  ContactReport report;
  executor.for_each(
    1, [&](std::size_t) { report = describe(study, foot, *load, last_spin); }, is_collective(study));
  if (report.coupling)
    report.coupling->interpolation_error = spin.curve_error;
  stopwatch.finish("report_of_contact");
  ErrorBands bands;
  if (depth == Depth::full)
  {
    bands = estimate_bands(study, foot, spin.all(), spin.rows.front().omega_terminal(), executor, progress);
    take_reported_numbers(report.load, spin.budget, bands);
    add_bands(band_of(bands, "omega_terminal"), band_of(bands, "omega_first_harmonic"), spin.budget.rows);
    spin.profile_scatter = profile_scatter(study, spin.all(), executor, progress);
    stopwatch.finish("error_bands");
  }

  // 3. The answer, and the results, all at once.
  // Only the first rank knows where the foot presses.
  publish(options, study, is_first_rank() ? tabulate(study, report, spin, bands, goal) : own_fields(report),
          folder, stopwatch);
}

} // namespace

void add_run_verb(CLI::App &program, Verb &chosen)
{
  const auto options = std::make_shared<RunOptions>();
  CLI::App *verb =
    program.add_subcommand("run", "Compute a study: contact, torque, spin, and how large each effect is");
  add_study_options(*verb, options->study);
  verb->add_flag("--quick", options->quick, "The answer and its curves, no budget and no error bands");
  verb->footer(R"(Examples:
  stemware run                                                the default study
  stemware new --cookbook lift_off                            writes lift_off.prm, to be changed
  stemware run lift_off.prm --output soft --set "Table/Foundation modulus=1e9"
  stemware run my_glass.prm --set "Load/Source=first harmonic" --set "Motion/Closure=full"
  stemware run my_glass.prm --set "Motion/Mass=250 g" --set "Glass/Contact radius=31 mm"
  stemware new --cookbook oval_foot                           a study of a mesh, and the mesh
  stemware run oval_foot.prm
  stemware run my_glass.prm --quick
  stemware run my_glass.prm --quiet --json | jq .omega_terminal
  stemware defaults Glass | stemware run - --output results/piped     from standard input
  mpirun -n 4 stemware run --set Contact/Body=solid --set "Contact/Azimuthal cells=96"

Results are written to a temporary folder and renamed at the end; older results of the same name
are replaced.
  report.html        the answer, its pictures and what is behind it, for a browser
  figures/           the pictures as SVG and PDF, with gnuplot scripts and data
  summary.json       load, torque, terminal spin, budget, error bands, the parameters (schema 2)
  parameters.prm     the study as it was run
  budget.dat         the terminal spin from the paper's model to the study's, step by step, and
                     without one thing at a time
  load.dat           lambda(theta), the sum of the rings and each ring
  harmonics.dat      Fourier coefficients of the sum; may be read again through Load/File
  rings.dat          Fourier coefficients ring by ring
  torque.dat         tau_z, T_x, T_y against the spin
  spin_up.dat        the spin against time
  truncation.dat     the answer after 1, 2, 3, 4, 6, 8 ... harmonics
  contact_history.dat, timings.json
  fields/contact.vtu displacement, stress and pressure for ParaView; of a solid body under mpirun
                     contact.pvtu and a contact_0.vtu, contact_1.vtu ... of each rank)");
  verb->callback([&chosen, options] { chosen = [options] { run(*options); }; });
}

} // namespace stemware::pipeline
