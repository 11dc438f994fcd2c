#include "fem/pipeline/run.h"

#include "fem/pipeline/contact_demand.h"
#include "fem/pipeline/interruption.h"
#include "fem/pipeline/program.h"
#include "fem/pipeline/ranks.h"
#include "fem/pipeline/result_tables.h"
#include "fem/pipeline/results_folder.h"
#include "fem/pipeline/solve_study.h"
#include "fem/pipeline/stopwatch.h"
#include "fem/pipeline/study_file.h"
#include "fem/pipeline/summary.h"
#include "fem/pipeline/terminal_report.h"
#include "fem/pipeline/text_file.h"

#include <filesystem>

namespace stemware::pipeline
{

namespace fs = std::filesystem;

namespace
{

/// The results folder as all ranks see it; the first one owns it.
class SharedFolder
{
public:
  explicit SharedFolder(const fs::path &target)
      : partial(on_first_rank(
          [&]
          {
            owned = std::make_unique<ResultsFolder>(target);
            return owned->working_folder().string();
          }))
  {
  }

  const fs::path &working_folder() const { return partial; }

  /// Runs @p work on the first rank.
  void write(const std::function<void(ResultsFolder &)> &work)
  {
    on_first_rank(
      [&]
      {
        work(*owned);
        return std::string();
      });
  }

private:
  std::unique_ptr<ResultsFolder> owned;
  const fs::path partial;
};

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
  StudyObserver observer;
  observer.foot_made = print_mesh;
  observer.newton_step = [progress = std::make_shared<ProgressTable>()](
                           const fem::ContactIteration &iteration) { progress->add(iteration); };
  observer.contact_found = [&](const FootContact &contact, const FootContactResult &result)
  {
    write_fields(contact, result, folder);
    stopwatch.finish("fields");
  };
  observer.balance_found = print_balance;
  observer.stage_done = [&](const std::string &stage) { stopwatch.finish(stage); };
  return observer;
}

void write_results(const Study &study, const StudyResult &result, Stopwatch &stopwatch, ResultsFolder &folder)
{
  const fs::path &place = folder.working_folder();
  const Study echo = with_paths_from(folder.final_folder(), study);
  write_text_file(place / "parameters.prm", study_as_prm(echo));
  write_result_tables(result, place);
  std::vector<std::string> files = folder.contents();
  files.insert(files.end(), { "summary.json", "timings.json" });
  std::sort(files.begin(), files.end());
  write_text_file(place / "summary.json", summary(echo, result, files).dump(2) + "\n");
  stopwatch.finish("tables");
  write_text_file(place / "timings.json", stopwatch.times().dump(2) + "\n");
  folder.publish();
}

} // namespace

void run(const RunOptions &options)
{
  // 1. What is asked for; everything that can be refused is refused here.
  Stopwatch stopwatch;
  const Study study = read_study(options.study_file, options.overrides);
  const fem::ContactLoad demand = demanded_load(study);
  if (study.load.source == LoadSource::contact)
    start_mpi();
  watch_for_interruption(); // after MPI, which puts handlers of its own in place
  const fs::path output = options.output.empty() ? fs::path("results") / fs::path(options.study_file).stem()
                                                 : fs::path(options.output);
  SharedFolder folder(output);
  console() << "Stemware  " << program_version() << " (" << program_revision() << ")\n"
            << "Study     " << options.study_file << std::endl;
  if (study.load.source == LoadSource::file)
    console() << "Load      " << study.load.file << std::endl;
  else
    print_demand(study, demand);
  stopwatch.finish("input");

  // 2. The load on the table, and what it does to the ring.
  const StudyResult result = solve_study(study, make_observer(folder, stopwatch));

  // 3. The results, all at once, and the answer.
  folder.write([&](ResultsFolder &results) { write_results(study, result, stopwatch, results); });
  print_answer(study, result);
  console() << "Results   " << output.string() << std::endl;
}

} // namespace stemware::pipeline
