#include "fem/pipeline/app/study_work.h"

#include "fem/pipeline/app/options.h"
#include "ring_model/load/constants.h"

#include <cmath>
#include <fmt/format.h>
#include <string>

namespace stemware::pipeline
{

namespace
{

/// Reports the required resultants at rest and their source to @p progress.
void note_load_source(const Study &study, Progress &progress)
{
  if (study.load.source == LoadSource::file)
  {
    progress.note("Load", study.load.file);
    return;
  }
  const fem::Resultants demand = study.required_resultants();
  const double ratio = moment_ratio(demand, study.glass.profile.contact_radius);
  const double crest = std::atan2(demand.moment_x, -demand.moment_y) / (ring::pi / 180);
  const std::string origin =
    study.load.is_static() ? "given"
                           : "moment balance " + ring::to_string(study.motion.closure) + ", upright at rest";
  std::string text =
    fmt::format(FMT_STRING("{:.6g} N, moment ratio {:.4g} ({})"), demand.normal_force, ratio, origin);
  if (ratio > 0)
    text += fmt::format(FMT_STRING(", largest at {:.3g} deg"), crest);
  progress.note("Load", text);
}

} // namespace

StudyWork::StudyWork(const StudyOptions &options)
    : progress(stopwatch)
    , study(begin_study(options))
    , folder(options.results_place())
    , executor(cache, n_threads_of(options), progress)
{
  note_load_source(study, progress);
  stopwatch.finish("input");
}

} // namespace stemware::pipeline
