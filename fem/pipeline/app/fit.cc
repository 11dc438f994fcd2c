#include "fem/pipeline/answer/study_answer.h"
#include "fem/pipeline/app/options.h"
#include "fem/pipeline/app/study_work.h"
#include "fem/pipeline/input/data_files.h"
#include "fem/pipeline/input/study_file.h"
#include "fem/pipeline/page/publish.h"
#include "fem/pipeline/report/fit_results.h"
#include "fem/pipeline/support/failures.h"

#include <CLI/CLI.hpp>
#include <boost/algorithm/string/predicate.hpp>

namespace stemware::pipeline
{

namespace
{

/// Options of `stemware fit`.
struct FitOptions : StudyOptions
{
  std::vector<std::string> data; ///< --data run.csv or run.csv:study.prm
  std::vector<std::string> free; ///< --free, see parse_free_entry()
  std::string gyroscope_zero;    ///< --gyroscope-zero, see parse_prior()
  std::string start;             ///< --start, see parse_start()
  bool quick = false;            ///< without profiles, next run and band
};

/// Reads the runs: each with @p study, or with the study that is named behind a colon.
std::vector<RunToFit> runs_of(const FitOptions &options, const Study &study)
{
  std::vector<RunToFit> runs;
  for (const std::string &data : options.data)
  {
    const auto colon = data.rfind(':');
    const bool has_study = boost::ends_with(data, ".prm") || boost::ends_with(data, ".json");
    ensure(!has_study || colon != data.npos,
           "--data " + data + " names no data before the study; write run.csv:study.prm.");
    const std::string file = data.substr(0, has_study ? colon : data.size());
    Study own = has_study ? read_study(data.substr(colon + 1), options.overrides) : study;
    runs.push_back({ file, own, read_measured_run(file, own.motion.measured_column, "--data ") });
    print_note("Data      ", file + ": " + runs.back().data.summary);
  }
  if (const std::string &file = study.motion.measured_spin_file; runs.empty() && !file.empty())
    runs.push_back({ file, study, read_measured_run(file, study.motion.measured_column) });
  return runs;
}

/// Fits entries to measured runs and writes the folder of the results. Throws as run().
void fit_verb(const FitOptions &options)
{
  FitQuestion question;
  std::vector<RunToFit> runs;
  StudyWork work(options, true,
                 [&](const Study &study)
                 {
                   question =
                     fit_question(options.free, options.gyroscope_zero, options.start, options.quick);
                   runs = runs_of(options, study);
                 });
  const FitResult found = fit_study(runs, question, work.executor, work.progress);
  publish(options, found.study, tabulate_fit(found), work.folder, work.stopwatch);
}

} // namespace

void add_fit_verb(CLI::App &program, Verb &chosen)
{
  const auto [verb, options] = add_study_verb(
    program, chosen, "fit", "Fit entries to measured runs, and tell what they leave open", fit_verb);
  verb->add_option("--data", options->data, "Measured run, with a study of its own if it needs one")
    ->type_name("FILE[:STUDY]")
    ->allow_extra_args(false);
  verb->add_option("--free", options->free, "Entry to be fitted, with what is known beforehand")
    ->type_name("\"Section/Entry[=value +- spread]\"")
    ->allow_extra_args(false);
  verb->add_option("--gyroscope-zero", options->gyroscope_zero, "Default 0 +- 0.01 rad/s; 0 for a film")
    ->type_name("\"value +- spread\"");
  verb->add_option("--start", options->start, "Time at which each glass begins to slide; default: any")
    ->type_name("\"value +- spread\"");
  verb->add_flag("--quick", options->quick, "Without profiles, next run and band of the discretisation");
}

} // namespace stemware::pipeline
