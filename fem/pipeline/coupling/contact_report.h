#pragma once

#include "fem/contact/foot.h"
#include "fem/geometry/section_view.h"
#include "fem/pipeline/study/study.h"
#include "ring_model/load/ring_stack.h"

#include <Eigen/Core>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// Load on the rings, with the resultants and the extent of the contact.
struct LoadReport
{
  ring::RingStack rings = ring::RingStack({ 1. }, { 0. }, 1.);
  double normal_force = 0;                          ///< N [N]
  Eigen::Vector2d moment = Eigen::Vector2d::Zero(); ///< M_N = (sum y f, -sum x f) [N m]
  double moment_ratio = 0;                          ///< |M_N| / (N R / 2), R the contact radius
  double mean_radius = 0;                           ///< sum f r / sum f [m]
  /// Share of the land's area under pressure (fem::ContactExtent); for a load without a contact the share of
  /// the azimuths with a positive load.
  double contact_fraction = 0;
  std::optional<double> azimuth_fraction = {}; ///< share of the azimuths under pressure; empty unless a ring
  Eigen::Vector2d tilt = Eigen::Vector2d::Zero(); ///< LeaningLoad::tilt [rad]
  double inner_radius = 0;                        ///< radii that enclose the load [m]
  double outer_radius = 0;
  double minimum = 0;                       ///< least pointwise load [N/rad]
  std::optional<double> peak_pressure = {}; ///< [Pa]; empty unless from a contact
  /// Largest width of the contact across the rim at any azimuth, fem::contact_width() [m]; empty unless from
  /// a contact that is resolved across the rim.
  std::optional<double> contact_width = {};
  std::vector<fem::AzimuthLoad>
    pointwise = {}; ///< lambda itself by azimuth in [0, 2 pi), sorted; empty unless from a contact

  double half_width() const { return (outer_radius - inner_radius) / 2; } ///< of the loaded band [m]
};

/// Finite-element results of a study.
struct FootReport
{
  fem::FootDescription foot;
  std::string friction_coupling; ///< "elastic" or "none"
  fem::ContactState at_rest;
  /// Contact at the end of the spin-up; std::nullopt if the load does not depend on the spin, and for a
  /// collective foot.
  std::optional<fem::ContactState> at_end = {};
  fem::PressureMap footprint; ///< at rest
  std::optional<fem::PressureMap> footprint_at_end = {};
  /// Section at rest along the line to the orbit's centre, x > 0 outside; empty if the foot has none.
  std::vector<fem::StressedPatch> stressed_section = {};
  std::vector<fem::FieldFile> fields = {};       ///< field files of both states to be written by this rank
  std::vector<fem::SectionPolygon> section = {}; ///< meridional section of the foot with its cells; on the
                                                 ///< first rank
};

/// Statistics of the solves of a load that is in balance with friction at every spin.
struct CouplingStatistics
{
  std::size_t n_balances = 0;          ///< spins at which contact, friction and moments are in balance
  std::size_t n_contact_solutions = 0; ///< contact solves for these balances
};

/// Contact results of a study at rest and at the end of the spin-up: the terminal spin, or the spin of
/// tipping.
struct ContactReport
{
  LoadReport load; ///< at rest
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
