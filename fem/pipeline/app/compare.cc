#include "fem/pipeline/analysis/refinement/goal_mesh.h"
#include "fem/pipeline/app/options.h"
#include "fem/pipeline/app/study_work.h"
#include "fem/pipeline/report/comparison_results.h"
#include "fem/pipeline/report/publish.h"
#include "fem/pipeline/support/failures.h"

namespace stemware::pipeline
{

namespace
{

/// A verb that solves variants of a study and shows them side by side, as the template NAME of report/ says.
struct ComparingVerb
{
  const char *name;
  const char *words; ///< of --help
  std::vector<Variant> (*variants)(const Study &study);
  /// Throws BadInput for what cannot be compared; nothing: all can.
  void (*refuse)(const Study &study) = nullptr;
  /// Adds to the rows what else the verb computes, collective over all ranks, and shows.
  decltype(&judge_models) judge = nullptr;
  ShownBeside show = nullptr;
};

/// `compare` chooses moment balances and loads itself.
void require_comparable(const Study &study)
{
  require(study.load.source != LoadSource::file,
          "Load/Source = file has one load, whatever the closure; set Load/Source = contact, or first "
          "harmonic to compare without an elastic foot.");
  require(!study.load.is_static(), "Load/Moment ratio is given, but closures differ in the moment that they "
                                   "ask for; leave Moment ratio at -1.");
  require_flat(study, "compare");
}

constexpr ComparingVerb comparing_verbs[] = {
  { "compare", "Moment balances, loads, harmonics side by side: what changes the spin", compared_models,
    require_comparable, judge_models, add_models },
};

/// Solves the variants of a study and writes the folder of the results. Collective over all ranks. Throws as
/// run().
void compare(const ComparingVerb &verb, const StudyOptions &options)
{
  // 1. What is asked for.
  StudyWork work(options, false, verb.refuse);

  // 2. Every variant.
  const Study study = mesh_for_goal(work.given, work.executor, work.progress).study;
  const std::shared_ptr<ElasticFoot> foot = announced_foot(study, work.executor, work.progress);
  Comparison comparison = compare_variants(study, verb.variants(study), foot, work.executor, work.progress);
  if (verb.judge)
  {
    verb.judge(study, foot, work.executor, comparison);
    work.progress.stage_done("error_bands");
  }

  // 3. The answer, and the results, all at once.
  publish(options, study, tabulate(verb.name, study, comparison, verb.show), work.folder, work.stopwatch);
}

} // namespace

void add_compare_verb(CLI::App &program, Verb &chosen)
{
  for (const ComparingVerb &verb : comparing_verbs)
  {
    const auto options = std::make_shared<StudyOptions>();
    add_study_options(
      *add_verb(program, chosen, verb.name, verb.words, [&verb, options] { compare(verb, *options); }),
      *options);
  }
}

} // namespace stemware::pipeline
