#pragma once

#include "fem/contact/foot.h"
#include "fem/pipeline/coupling/balanced_load.h"

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
  /// Contact at the end of the spin-up; none for a load independent of the spin and a collective foot.
  std::optional<fem::ContactState> at_end = {};
  fem::PressureMap footprint; ///< pressure at rest
  std::optional<fem::PressureMap> footprint_at_end = {};
  /// Meridional section of the foot with its cells; on the first rank only.
  std::vector<fem::SectionPolygon> section = {};
};

/// Fields of a foot at rest and at the end of the spin-up.
struct FieldReport
{
  std::vector<fem::FieldFile> files = {}; ///< written by this rank
  /// Section at rest through the orbit's centre, x > 0 away from the centre; empty if the foot has none.
  std::vector<fem::StressedPatch> stressed_section = {};
};

/// Contact results of a study at rest and at the end of the spin-up (terminal spin or spin of tipping).
struct ContactReport
{
  LoadReport load; ///< load at rest
  LoadReport load_at_end;
  std::optional<FootReport> foot;             ///< std::nullopt for a load without a contact
  std::optional<CouplingStatistics> coupling; ///< std::nullopt for a load independent of the spin
};

/// Returns the report on @p load, find_load() of @p foot (nullptr without a contact), at rest and at @p
/// last_spin, the end of the spin-up [rad/s]. May solve the contact at @p last_spin. Throws as @p load.
ContactReport describe(const std::shared_ptr<ElasticFoot> &foot, const BalancedLoad &load, double last_spin);

/// Returns the fields of the states in @p report. @p foot: the foot, or a clone() on another thread.
FieldReport find_fields(const ElasticFoot &foot, const FootReport &report);

} // namespace stemware::pipeline
