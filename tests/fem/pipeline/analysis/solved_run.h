#pragma once

#include "fem/pipeline/analysis/error_bands.h"
#include "fem/pipeline/analysis/spin_study.h"
#include "fem/pipeline/analysis/threaded_executor.h"
#include "fem/pipeline/coupling/contact_report.h"
#include "fem/pipeline/coupling/make_foot.h"
#include "fem/pipeline/coupling/study_load.h"
#include "fem/pipeline/result/run_results.h"

#include <memory>

namespace stemware::test
{

/// Analysis and results of `run`, without writing files.
struct SolvedRun
{
  explicit SolvedRun(const pipeline::Study &given, const pipeline::Model &model = {})
      : study(given)
      , foot(pipeline::study_foot(study, cache, pipeline::silent_progress(), nullptr, {}, model))
  {
    const pipeline::ThreadedExecutor executor(cache);
    const pipeline::BalancedLoad load = pipeline::find_load(study, foot);
    spin = pipeline::study_spin(study, foot, load, executor);
    report = pipeline::describe(study, foot, load, spin.all().last_spin().value());
    bands = pipeline::estimate_bands(study, foot, spin.all(), spin.rows.front().omega_terminal(), executor,
                                     pipeline::silent_progress(),
                                     pipeline::reported_quantities(report.load, spin.budget));
    pipeline::add_bands(pipeline::band_of(bands, "omega_terminal"),
                        pipeline::band_of(bands, "omega_first_harmonic"), spin.budget.rows);
  }

  pipeline::Results results(const std::optional<pipeline::GoalOutcome> &goal = {}) const
  {
    return make_document(study, report, spin, bands, goal);
  }
  pipeline::Json summary() const { return results().findings.summary; }

  pipeline::Study study;
  fem::ComplianceCache cache;
  std::shared_ptr<pipeline::ElasticFoot> foot;
  pipeline::SpinStudy spin;
  pipeline::ContactReport report;
  pipeline::ErrorBands bands;
};

} // namespace stemware::test
