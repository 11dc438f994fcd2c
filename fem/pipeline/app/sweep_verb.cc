#include "fem/pipeline/app/sweep.h"
#include "fem/pipeline/app/verbs.h"

#include <CLI/CLI.hpp>

#include <memory>

namespace stemware::pipeline
{

void add_sweep_verb(CLI::App &program, Verb &chosen)
{
  const auto options = std::make_shared<SweepOptions>();
  CLI::App *verb =
    program.add_subcommand("sweep", "Compute a study many times: entries over a range, or random samples");
  add_study_options(*verb, *options);
  SweepRequest &request = options->request;
  verb->add_option("--vary", request.varied, "Values of one entry: a range or a list; at most twice")
    ->type_name("\"Section/Entry=values\"")
    ->allow_extra_args(false);
  verb->add_option("--random", request.random, "Spread of one entry; may be repeated")
    ->type_name("\"Section/Entry=spread\"")
    ->allow_extra_args(false);
  verb->add_option("--samples", request.n_samples, "Number of random samples; default: 200")->type_name("N");
  verb->add_option("--seed", request.seed, "Which random samples; default: 1")->type_name("S");
  verb
    ->add_option("--jobs", options->n_jobs,
                 "Cases that each process solves at a time; default: one for each core,\n"
                 "one under mpirun")
    ->type_name("N")
    ->check(CLI::Range(1, 1024).description(""));
  verb->add_flag("--restart", options->restart, "Throws away the cases kept from an interrupted sweep");
  verb->footer(R"(Values of --vary:
  "Load/Moment ratio=0.1:1.9:50"               50 values from 0.1 to 1.9, equal steps
  "Table/Foundation modulus=1e8:1e12:20:log"   20 values, equal factors
  "Motion/Closure=paper,hand,full"             these

Spreads of --random:
  "Motion/Friction coefficient=0.3+-0.03"      normal: mean and standard deviation
  "Motion/Mass=0.3+-5%"                        the same, as a share of the mean
  "Table/Foundation modulus=1e10*/2"           lognormal: median and factor
  "Glass/Crown radius=0.002..0.004"            uniform
  "Table/Foundation modulus=1e9..1e11:log"     uniform in the logarithm

Examples:
  stemware sweep docs/cookbooks/paper.prm --vary "Motion/Force offset=-0.08:-0.02:25"
  stemware sweep glass.prm --vary "Load/Moment ratio=0.1:1.9:50" \
                           --vary "Table/Foundation modulus=1e8:1e12:20:log"
  stemware sweep glass.prm --random "Motion/Friction coefficient=0.3+-10%" \
                           --random "Glass/Crown radius=0.002..0.004" --samples 500
  mpirun -n 8 stemware sweep glass.prm --vary "Load/Moment ratio=0:1.95:500"

Finished cases are kept as they come: interrupted by Ctrl-C, kill or a power cut, the same command
goes on where it was, and the table is the one of an unbroken run. A case that fails is listed with
its message and does not stop the others; the exit code is 0 unless all of them fail.

Under mpirun the ranks share the cases. Cases with Contact/Body = solid are solved one after
another, by all ranks together.

  sweep.csv          a row for every case: varied entries, load, torque, spin, outcome
  statistics.csv     bands and sensitivities of random samples
  sweep.json         how the cases came about
  summary.json       ranges, or bands and sensitivities, and the parameters of the base study
  parameters.prm     the base study
  report.html, figures/, timings.json)");
  verb->callback([&chosen, options] { chosen = [options] { sweep(*options); }; });
}

} // namespace stemware::pipeline
