#include "fem/pipeline/coupling/contact_report.h"

#include "fem/pipeline/coupling/balanced_load.h"
#include "fem/pipeline/coupling/elastic_foot.h"
#include "fem/pipeline/coupling/study_load.h"

namespace stemware::pipeline
{

namespace
{

/// The contact in balance at @p omega; that at rest where the load is the same at every spin.
fem::ContactState state_at(const ElasticFoot &foot, const BalancedLoad &load, const ring::Motion &motion,
                           double omega)
{
  const fem::ContactState &at_rest = *load.contact();
  if (!load.follows_spin())
    return at_rest;
  const ring::RingStack balanced = load.at(omega);
  const fem::FootOrientation &marks = at_rest.slip.orientation;
  return foot.solve(balanced.normal_force(), balanced.moment(),
                    { omega / motion.orbit_speed, { marks.glass, marks.table } });
}

FootReport describe_foot(const Study &study, ElasticFoot &foot, const BalancedLoad &load)
{
  const fem::ContactState &at_rest = *load.contact();
  FootReport report;
  report.foot = foot.body().description();
  report.friction_coupling = study.friction_deforms() ? "elastic" : "none";
  report.at_rest = at_rest;
  report.footprint = foot.body().pressure_map(at_rest);
  // The fields are those of the state solved last.
  if (foot.n_solutions() > 1)
  {
    const fem::LoadHarmonics &rest = at_rest.load;
    const fem::FootOrientation &marks = at_rest.slip.orientation;
    report.fields = foot.body().fields(
      foot.solve(rest.normal_force, { rest.moment_x, rest.moment_y }, { 0, { marks.glass, marks.table } }));
  }
  else
    report.fields = foot.body().fields(at_rest);
  return report;
}

} // namespace

ContactReport describe(const Study &study, const std::shared_ptr<ElasticFoot> &foot, const BalancedLoad &load,
                       double omega_terminal)
{
  ContactReport report = { load.report(), report_of(load.at(omega_terminal)), {}, 0, {}, {} };
  if (foot)
    report.load_at_terminal =
      report_of(state_at(*foot, load, study.motion.orbit, omega_terminal), foot->radius());
  if (foot)
    report.foot = describe_foot(study, *foot, load);
  report.coupling = load.statistics();
  return report;
}

} // namespace stemware::pipeline
