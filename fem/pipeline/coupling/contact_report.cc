#include "fem/pipeline/coupling/contact_report.h"

#include "fem/pipeline/coupling/balanced_load.h"
#include "fem/pipeline/coupling/elastic_foot.h"
#include "fem/pipeline/coupling/make_foot.h"
#include "fem/pipeline/coupling/study_load.h"
#include "fem/pipeline/support/ranks.h"

namespace stemware::pipeline
{

namespace
{

/// The contact @p state once more, so that it is the last one.
fem::ContactState solved_again(const ElasticFoot &foot, const fem::ContactState &state)
{
  const fem::FootOrientation &marks = state.slip.orientation;
  const fem::LoadHarmonics &load = state.load;
  return foot.solve({ load.normal_force, load.moment_x, load.moment_y },
                    { state.slip.spin_per_speed, { marks.glass, marks.table } });
}

FootReport describe_foot(const Study &study, ElasticFoot &foot, const BalancedLoad &load)
{
  const fem::ContactState &at_rest = *load.contact();
  FootReport report;
  report.foot = foot.body().description();
  report.friction_coupling = study.friction_deforms() ? "elastic" : "none";
  report.at_rest = at_rest;
  report.footprint = foot.body().pressure_map(at_rest);
  // The fields are those of the state solved last; every rank solves, so that every rank knows of a failure.
  const fem::ContactState last = foot.n_solutions() > 1 ? solved_again(foot, at_rest) : at_rest;
  // A foot that every rank has is written by the first.
  if (is_first_rank() || foot.body().capabilities().is_collective)
    report.fields = foot.body().fields(last);
  if (is_first_rank())
    report.section = foot_section(study);
  return report;
}

} // namespace

ContactReport describe(const Study &study, const std::shared_ptr<ElasticFoot> &foot, const BalancedLoad &load,
                       double last_spin)
{
  ContactReport report;
  report.load = load.report();
  report.load_at_end = report_of(load.at(last_spin));
  if (load.contact_at())
    report.load_at_end = report_of(load.contact_at()(last_spin), foot->radius(), study.tilts());
  else if (load.contact())
    report.load_at_end = report.load;
  report.tilt = report.load_at_end.tilt;
  if (foot)
    report.foot = describe_foot(study, *foot, load);
  report.coupling = load.statistics();
  return report;
}

} // namespace stemware::pipeline
