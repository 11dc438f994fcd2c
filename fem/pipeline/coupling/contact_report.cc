#include "fem/pipeline/coupling/contact_report.h"

#include "fem/contact/footprint.h"
#include "fem/pipeline/base/ranks.h"
#include "fem/pipeline/coupling/balanced_load.h"
#include "fem/pipeline/coupling/elastic_foot.h"
#include "fem/pipeline/coupling/make_foot.h"
#include "fem/pipeline/coupling/study_load.h"
#include "ring_model/load/constants.h"

namespace stemware::pipeline
{

namespace
{

/// Returns @p load with the contact width if @p footprint has more than one point across the contact.
LoadReport with_width(LoadReport load, const fem::PressureMap &footprint)
{
  if (!footprint.cuts.empty() && fem::has_cells(footprint))
    load.contact_width = fem::measures_of(footprint).widest;
  return load;
}

FootReport describe_foot(const ElasticFoot &foot, const fem::ContactState &at_rest,
                         const std::optional<fem::ContactState> &at_end)
{
  FootReport report;
  report.foot = foot.body().description();
  report.friction_coupling = foot.specification().study.friction_deforms() ? "elastic" : "none";
  report.at_rest = at_rest;
  report.footprint = foot.body().pressure_map(at_rest);
  if (is_first_rank())
    report.section = foot_section(foot.specification());
  if (at_end && at_end->slip.spin_per_speed != at_rest.slip.spin_per_speed && is_first_rank() &&
      !foot.body().capabilities().is_collective)
  {
    report.at_end = at_end;
    report.footprint_at_end = foot.body().pressure_map(*at_end);
  }
  return report;
}

} // namespace

FieldReport find_fields(const ElasticFoot &foot, const FootReport &report)
{
  FieldReport found;
  const bool is_collective = foot.body().capabilities().is_collective;
  // Unless the ranks solve together, all ranks have the same fields, and only the first rank writes them.
  if (is_first_rank() || is_collective)
    found.files = foot.body().fields(report.at_rest);
  if (is_collective || !is_first_rank())
    return found;
  // The section is on the side of the foot away from the centre of the orbit. On a counter-clockwise orbit,
  // the centre is to the left of the direction of travel.
  const double sense = foot.specification().study.motion.orbit.sense_sign();
  found.stressed_section = foot.body().section(report.at_rest, -sense * ring::pi / 2);
  if (report.at_end)
    for (fem::FieldFile file : foot.body().fields(*report.at_end))
    {
      file.name.insert(file.name.find('.'), "_at_terminal_spin");
      found.files.push_back(std::move(file));
    }
  return found;
}

ContactReport describe(const std::shared_ptr<ElasticFoot> &foot, const BalancedLoad &load, double last_spin)
{
  ContactReport report;
  const std::optional<fem::ContactState> at_rest = load.contact(0), at_end = load.contact(last_spin);
  if (at_rest)
    report.foot = describe_foot(*foot, *at_rest, at_end);
  report.load = report.foot ? with_width(load.report(), report.foot->footprint) : load.report();
  // pressure_map() is collective for a solid body, so all ranks call it.
  report.load_at_end = at_end
                         ? with_width(report_of(*at_end, foot->radius(), foot->specification().study.tilts()),
                                      foot->body().pressure_map(*at_end))
                         : report_of(load.at(last_spin));
  report.coupling = load.statistics();
  return report;
}

} // namespace stemware::pipeline
