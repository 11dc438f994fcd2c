#pragma once

#include "fem/contact/contact_load.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>

namespace stemware::pipeline
{

/// Load on the rings, with resultants and extent of the contact. Without a contact, `contact_fraction` is the
/// share of the azimuths with a positive load, `peak_pressure` is 0, and `pointwise` is empty.
struct LoadReport : fem::ContactLoad
{
  double moment_ratio = 0;                        ///< |M_N| / (N R / 2), R the contact radius
  Eigen::Vector2d tilt = Eigen::Vector2d::Zero(); ///< Sample::tilt [rad]
  double inner_radius = 0;                        ///< radii that enclose the load [m]
  double outer_radius = 0;
  /// Largest width of the contact across the rim, fem::contact_width() [m]; empty if the mesh is too coarse.
  std::optional<double> contact_width = {};
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
