#include "fem/pipeline/app/truncate.h"

#include "fem/pipeline/analysis/refinement/refinement_study.h"
#include "fem/pipeline/coupling/load_file.h"
#include "fem/pipeline/output/console_report.h"
#include "fem/pipeline/output/publish.h"
#include "fem/pipeline/output/truncation_report.h"
#include "fem/pipeline/output/truncation_tables.h"
#include "fem/pipeline/study/study.h"
#include "fem/pipeline/support/console.h"
#include "fem/pipeline/support/text.h"
#include "fem/pipeline/support/text_file.h"
#include "fem/pipeline/support/work_progress.h"

#include <ostream>

namespace stemware::pipeline
{

namespace
{

/// Truncations, with a bar that shows how far they have come.
TruncationStudy truncations_with_progress(const Study &study, const StudyLoad &load,
                                          const std::vector<double> &omega)
{
  std::optional<WorkProgress> bar;
  return study_truncations(study, load, omega,
                           [&bar](std::size_t n_done, std::size_t n_all)
                           {
                             if (!bar)
                               bar.emplace(n_all, 0, "truncations");
                             bar->show(n_done);
                           });
}

void write_tables(const RingLoad &load, const TruncationStudy &result, const std::filesystem::path &folder)
{
  write_text_file(folder / "harmonics.dat", load_file_text(load.at_rest));
  write_text_file(folder / "truncation.dat", truncation_data(result, result.frozen));
  write_text_file(folder / "spin_up.dat", spin_up_data(result, result.frozen));
  if (!result.self_consistent)
    return;
  write_text_file(folder / "truncation_self_consistent.dat",
                  truncation_data(result, *result.self_consistent));
  write_text_file(folder / "spin_up_self_consistent.dat", spin_up_data(result, *result.self_consistent));
}

} // namespace

void truncate(const TruncateOptions &options)
{
  // 1. What is asked for.
  Stopwatch stopwatch;
  const Study study = begin_study(options.study);
  require_flat(study, options.study.verb);
  SharedFolder folder(options.study.results_place());
  print_load_source(study);
  stopwatch.finish("input");

  // 2. The load of all harmonics, and the glass on fewer and fewer of them.
  StudyObserver observer = progress_on_console(stopwatch);
  observer.balance_found = {}; // the bar shows how far it has come
  const StudyLoad load = find_load(study, observer);
  TruncationStudy result = truncations_with_progress(study, load, options.omega);
  stopwatch.finish("truncations");
  result.spin_band = terminal_spin_band(study, load.load, *result.frozen.all().omega_terminal);
  stopwatch.finish("error_band");

  // 3. The answer, and the results, all at once.
  folder.write(
    [&](ResultsFolder &owned)
    {
      write_tables(load.load, result, owned.working_folder());
      stopwatch.finish("tables");
      write_report(truncation_report(study, load, result), owned.working_folder());
      stopwatch.finish("report");
    });
  console() << '\n'
            << wrapped(truncation_answer(study, result)) << "\n\n"
            << truncation_text(result) << std::endl;
  publish(options.study, study, truncation_findings(study, load.load, result), folder, stopwatch);
}

} // namespace stemware::pipeline
