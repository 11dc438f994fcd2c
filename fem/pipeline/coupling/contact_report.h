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

/// A load as the ring is given it and as the table carries it.
struct LoadReport
{
  ring::RingStack rings = ring::RingStack({ 1. }, { 0. }, 1.);
  double normal_force = 0;                          ///< N [N]
  Eigen::Vector2d moment = Eigen::Vector2d::Zero(); ///< M_N = (sum y f, -sum x f) [N m]
  double moment_ratio = 0;                          ///< |M_N| / (N R / 2), R the contact radius
  double mean_radius = 0;                           ///< sum f r / sum f [m]
  /// Share of the land's area under pressure (fem::ContactExtent); of a load without a contact the share of
  /// the azimuths with a positive load.
  double contact_fraction = 0;
  std::optional<double> azimuth_fraction = {}; ///< share of the azimuths under pressure; empty unless a ring
  Eigen::Vector2d tilt = Eigen::Vector2d::Zero(); ///< LeaningLoad::tilt [rad]
  double inner_radius = 0;                        ///< between which the load lies [m]
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

/// The finite-element side of a study.
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
  std::vector<fem::FieldFile> fields = {};       ///< of both states; those that this rank writes
  std::vector<fem::SectionPolygon> section = {}; ///< of the foot with its cells; on the first rank
};

/// Statistics of the solves of a load that is in balance with friction at every spin.
struct CouplingStatistics
{
  std::size_t n_balances = 0;          ///< spins at which contact, friction and moments are in balance
  std::size_t n_contact_solutions = 0; ///< that those took
};

/// Everything about the contact that a study reports, at rest and at the end of the spin-up: the terminal
/// spin, or that at which the glass falls over.
struct ContactReport
{
  LoadReport load; ///< at rest
  LoadReport load_at_end;
  std::optional<FootReport> foot;             ///< nothing where the load does not come from a contact
  std::optional<CouplingStatistics> coupling; ///< nothing where the load is the same at every spin
};

class BalancedLoad;
class ElasticFoot;

/// Describes the load of @p study at rest and at @p last_spin, at which the spin-up ends [rad/s], but for
/// what add_fields() adds. @p foot is study_foot(), @p load find_load() of it. May solve the contact there.
/// Throws as the load.
ContactReport describe(const Study &study, const std::shared_ptr<ElasticFoot> &foot, const BalancedLoad &load,
                       double last_spin);

/// Adds fields and stressed section in both states of @p report. Another @p foot than that of describe(), a
/// twin, may be asked for them while that one is at work.
void add_fields(const Study &study, const ElasticFoot &foot, FootReport &report);

} // namespace stemware::pipeline
