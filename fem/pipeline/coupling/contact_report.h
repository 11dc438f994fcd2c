#pragma once

#include "fem/contact/foot.h"
#include "fem/pipeline/coupling/load_report.h"
#include "fem/pipeline/study/study.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// Finite-element results of a study.
struct FootReport
{
  fem::FootDescription foot;
  std::string friction_coupling; ///< "elastic" or "none"
  fem::ContactState at_rest;
  /// Contact at the end of the spin-up; std::nullopt if the load does not depend on the spin, and for a
  /// collective foot.
  std::optional<fem::ContactState> at_end = {};
  fem::PressureMap footprint; ///< pressure at rest
  std::optional<fem::PressureMap> footprint_at_end = {};
  /// Section at rest along the line to the orbit's centre, x > 0 outside; empty if the foot has none.
  std::vector<fem::StressedPatch> stressed_section = {};
  std::vector<fem::FieldFile> fields = {};       ///< field files of both states to be written by this rank
  std::vector<fem::SectionPolygon> section = {}; ///< meridional section of the foot with its cells; on the
                                                 ///< first rank
};

/// Contact results of a study at rest and at the end of the spin-up: the terminal spin, or the spin of
/// tipping.
struct ContactReport
{
  LoadReport load; ///< load at rest
  LoadReport load_at_end;
  std::optional<FootReport> foot;             ///< std::nullopt for a load without a contact
  std::optional<CouplingStatistics> coupling; ///< std::nullopt for a load that does not depend on the spin
};

class BalancedLoad;
class ElasticFoot;

/// Returns the report on the load of @p study at rest and at @p last_spin, the end of the spin-up [rad/s],
/// without the results of add_fields(). @p foot: study_foot(); @p load: find_load() of the foot. May solve
/// the contact at @p last_spin. Throws as the load.
ContactReport describe(const Study &study, const std::shared_ptr<ElasticFoot> &foot, const BalancedLoad &load,
                       double last_spin);

/// Adds fields and stressed section of both states to @p report. @p foot may be a clone of the foot of
/// describe(), so that both can work simultaneously.
void add_fields(const Study &study, const ElasticFoot &foot, FootReport &report);

} // namespace stemware::pipeline
