#pragma once

#include "fem/contact/contact_load.h"
#include "ring_model/load/ring_stack.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <vector>

namespace stemware::pipeline
{

/// Load on the rings, with resultants and extent of the contact.
struct LoadReport
{
  ring::RingStack rings = ring::RingStack({ 1. }, { 0. }, 1.);
  double normal_force = 0;                          ///< N [N]
  Eigen::Vector2d moment = Eigen::Vector2d::Zero(); ///< M_N = (sum y f, -sum x f) [N m]
  double moment_ratio = 0;                          ///< |M_N| / (N R / 2), R the contact radius
  double mean_radius = 0;                           ///< sum f r / sum f [m]
  /// Share of the land's area under pressure; without a contact, of the azimuths with a positive load.
  double contact_fraction = 0;
  std::optional<double> azimuth_fraction = {};    ///< share of azimuths under pressure; empty unless a ring
  Eigen::Vector2d tilt = Eigen::Vector2d::Zero(); ///< Sample::tilt [rad]
  double inner_radius = 0;                        ///< radii that enclose the load [m]
  double outer_radius = 0;
  double minimum = 0;                       ///< least pointwise load [N/rad]
  std::optional<double> peak_pressure = {}; ///< [Pa]; empty without a contact
  /// Largest width of the contact across the rim, fem::contact_width() [m]; empty if the mesh is too coarse.
  std::optional<double> contact_width = {};
  /// Load on the contact's lines, sorted by azimuth in [0, 2 pi); empty without a contact.
  std::vector<fem::AzimuthValue> pointwise = {};
  /// Minimum of contact_fraction over the sampled phases; empty for a load independent of the phase.
  std::optional<double> least_contact_fraction = {};

  /// Returns the half-width of the loaded range of radii [m].
  double half_width() const { return (outer_radius - inner_radius) / 2; }
};

/// Statistics of a load that is in balance with friction at every spin.
struct CouplingStatistics
{
  std::size_t n_balances = 0;          ///< spins with a balance of contact, friction and moments
  std::size_t n_contact_solutions = 0; ///< contact solves for these balances
};

} // namespace stemware::pipeline
