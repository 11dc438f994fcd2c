#include "fem/pipeline/app/run.h"

#include "fem/pipeline/analysis/refinement/refinement_study.h"
#include "fem/pipeline/analysis/solve_study.h"
#include "fem/pipeline/output/console_report.h"
#include "fem/pipeline/output/publish.h"
#include "fem/pipeline/output/result_tables.h"
#include "fem/pipeline/output/run_report.h"
#include "fem/pipeline/output/summary.h"

namespace stemware::pipeline
{

namespace fs = std::filesystem;

namespace
{

/// Fields of the contact at rest, where the body has some.
void write_fields(const FootContact &contact, const FootContactResult &result, SharedFolder &folder)
{
  const fs::path fields = folder.working_folder() / "fields";
  folder.write([&](ResultsFolder &) { fs::create_directory(fields); });
  if (!contact.write_fields(fields.string(), result))
    folder.write([&](ResultsFolder &) { fs::remove(fields); });
}

/// Shows on the terminal what happens, and keeps the fields and the times.
StudyObserver make_observer(SharedFolder &folder, Stopwatch &stopwatch)
{
  StudyObserver observer = progress_on_console(stopwatch);
  observer.contact_found = [&](const FootContact &contact, const FootContactResult &result)
  {
    write_fields(contact, result, folder);
    stopwatch.finish("fields");
  };
  return observer;
}

} // namespace

void run(const StudyOptions &options)
{
  // 1. What is asked for; everything that can be refused is refused here.
  Stopwatch stopwatch;
  const Study study = begin_study(options);
  SharedFolder folder(options.results_place());
  print_load_source(study);
  stopwatch.finish("input");

  // 2. The load on the table, and what it does to the ring.
  StudyResult result = solve_study(study, make_observer(folder, stopwatch));
  if (has_quick_error_bands(study))
    result.error_bands = estimate_error_bands(study, result.load, result.yaw.terminal.omega).figures;
  stopwatch.finish("error_bands");

  // 3. The answer, and the results, all at once.
  folder.write(
    [&](ResultsFolder &owned)
    {
      write_result_tables(result, owned.working_folder());
      stopwatch.finish("tables");
      write_report(run_report(study, result, owned.working_folder()), owned.working_folder());
      stopwatch.finish("report");
    });
  print_answer(study, result);
  publish(options, study, run_findings(study, result), folder, stopwatch);
}

} // namespace stemware::pipeline
