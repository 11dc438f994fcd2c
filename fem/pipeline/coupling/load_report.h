#pragma once

#include "fem/contact/contact_load.h"
#include "ring_model/load/ring_stack.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <vector>

namespace stemware::pipeline
{

/// Extremes over all sampled phases, at rest.
struct PhaseExtremes
{
  double least_load = 0;             ///< LoadReport::minimum
  double least_contact_fraction = 0; ///< LoadReport::contact_fraction
};

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
  Eigen::Vector2d tilt = Eigen::Vector2d::Zero(); ///< Sample::tilt [rad]
  double inner_radius = 0;                        ///< radii that enclose the load [m]
  double outer_radius = 0;
  double minimum = 0;                       ///< least pointwise load [N/rad]
  std::optional<double> peak_pressure = {}; ///< [Pa]; empty unless from a contact
  /// Largest width of the contact across the rim at any azimuth, fem::contact_width() [m]; empty unless from
  /// a contact that is resolved across the rim.
  std::optional<double> contact_width = {};
  std::vector<fem::AzimuthLoad>
    pointwise = {}; ///< lambda itself by azimuth in [0, 2 pi), sorted; empty unless from a contact
  std::optional<PhaseExtremes> over_phases = {}; ///< empty unless the load depends on the phase

  /// Half-width of the loaded range of radii [m].
  double half_width() const { return (outer_radius - inner_radius) / 2; }
};

/// Statistics of the solves of a load that is in balance with friction at every spin.
struct CouplingStatistics
{
  std::size_t n_balances = 0;          ///< spins at which contact, friction and moments are in balance
  std::size_t n_contact_solutions = 0; ///< contact solves for these balances
};

} // namespace stemware::pipeline
