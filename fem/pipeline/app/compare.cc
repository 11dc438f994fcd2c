#include "fem/pipeline/app/compare.h"

#include "fem/pipeline/output/comparison_report.h"
#include "fem/pipeline/output/comparison_tables.h"
#include "fem/pipeline/output/console_report.h"
#include "fem/pipeline/output/publish.h"
#include "fem/pipeline/study/study.h"
#include "fem/pipeline/support/console.h"
#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/text.h"
#include "fem/pipeline/support/text_file.h"
#include "fem/pipeline/support/work_progress.h"

#include <ostream>

namespace stemware::pipeline
{

namespace
{

/// A comparison chooses closures and loads itself.
void require_comparable(const Study &study)
{
  if (study.load.source == LoadSource::file)
    throw BadInput("Load/Source = file has one load, whatever the closure; set Load/Source = contact, or "
                   "first harmonic to compare without an elastic foot.");
  if (study.load.is_static())
    throw BadInput("Load/Moment ratio is given, but closures differ in the moment that they ask for; leave "
                   "Moment ratio at -1.");
  require_flat(study, "compare");
}

/// The study's elastic foot, with a word on the terminal about it.
std::shared_ptr<FootContact> make_foot(const Study &study, const StudyObserver &observer)
{
  fem::ComplianceStore store;
  const std::shared_ptr<FootContact> foot = make_foot_contact(study, store);
  observer.foot_made(*foot);
  if (const std::string note = friction_note(study); !note.empty())
    observer.note("Friction", note);
  observer.stage_done("mesh_and_stiffness");
  return foot;
}

/// Kinds of loads from the simplest to the study's own.
std::vector<LoadKind> kinds_of(const Study &study, const StudyObserver &observer)
{
  std::vector<LoadKind> kinds = { first_harmonic_kind(study), rigid_ring_kind(study, 1.),
                                  rigid_ring_kind(study, 1.5) };
  if (study.load.source != LoadSource::contact)
    return kinds;
  const std::shared_ptr<FootContact> foot = make_foot(study, observer);
  kinds.push_back(resting_foot_kind(study, foot));
  if (study.contact.body == BodyKind::revolution || study.load.coupling == LoadCoupling::exact)
    kinds.push_back(balanced_foot_kind(study, foot));
  return kinds;
}

Comparison compare_with_progress(const Study &study, const std::vector<LoadKind> &kinds)
{
  WorkProgress bar(n_rows(kinds), 0, "rows");
  return compare_models(study, kinds, [&bar](std::size_t n_done) { bar.show(n_done); });
}

} // namespace

void compare(const StudyOptions &options)
{
  // 1. What is asked for.
  Stopwatch stopwatch;
  const Study study = begin_study(options);
  require_comparable(study);
  SharedFolder folder(options.results_place());
  stopwatch.finish("input");

  // 2. Every closure on every kind of load.
  Comparison comparison = compare_with_progress(study, kinds_of(study, progress_on_console(stopwatch)));
  stopwatch.finish("comparison");
  add_error_bands(study, comparison);
  stopwatch.finish("error_bands");

  // 3. The answer, and the results, all at once.
  folder.write(
    [&](ResultsFolder &owned)
    {
      write_text_file(owned.working_folder() / "compare.csv", comparison_csv(comparison));
      stopwatch.finish("tables");
      write_report(comparison_report(study, comparison), owned.working_folder());
      stopwatch.finish("report");
    });
  console() << '\n'
            << wrapped(comparison_answer(comparison)) << "\n\n"
            << comparison_text(comparison) << std::endl;
  publish(options, study, comparison_findings(comparison), folder, stopwatch);
}

} // namespace stemware::pipeline
