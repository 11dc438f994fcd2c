#pragma once

#include "fem/contact/contact_surface.h"
#include "fem/contact/pressure_map.h"

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace stemware::fem
{

/// Force, centre and shape of a pressure across the contact.
struct PressureMoments
{
  double azimuth = 0;  ///< azimuth of the cut [rad]
  double force = 0;    ///< int p dr [N/m]
  double middle = 0;   ///< mean radius of the force [m]
  double variance = 0; ///< variance of the radius, weighted by the pressure [m^2]
  double kurtosis = 0; ///< fourth central moment over the square of the variance
};

/// Pressure across a narrow contact, p = peak (1 - x^2)^exponent with x = (r - middle) / half_width: exponent
/// 1/2 is Hertz's line contact, 1 the contact of a crown on a layer that is thinner than the contact is wide.
struct PressureProfile
{
  /// Returns the profile of @p exponent with force, middle and variance of @p moments; peak 0 without a
  /// force.
  static PressureProfile with(const PressureMoments &moments, double exponent);
  /// Returns the exponent of the profile with @p kurtosis, between 9/5 (0, an even pressure) and 3.
  static double exponent_of(double kurtosis) { return (5 * kurtosis - 9) / (6 - 2 * kurtosis); }

  /// Returns the pressure at @p radius [Pa].
  double at(double radius) const;

  double azimuth = 0;    ///< azimuth of the cut [rad]
  double middle = 0;     ///< [m]
  double half_width = 0; ///< [m]
  double exponent = 0.5;
  double peak = 0; ///< [Pa]
};

/// Returns the moments of the pressure on each cut of @p surface with radial lines, sorted by azimuth, from
/// the penetration @p depths at the samples of each line [m] and a law @p pressure(penetration [m]) [Pa].
/// Empty without a load. Collective over all ranks.
std::vector<PressureMoments> moments_of_cuts(const ContactSurface &surface,
                                             const std::vector<Eigen::Vector3d> &depths,
                                             const std::function<double(double)> &pressure);

/// Returns a profile for each cut, with the force, the centre and the variance of its pressure and an
/// exponent in common, from the mean kurtosis, at least 1/2; arguments as for moments_of_cuts(). Empty
/// without a load, and if the pressure is not concentrated in the middle (a mean kurtosis outside 1.8
/// ... 2.3), as at the end of a land.
///
/// With a stiff spring that approximates a hard interface, the pressure oscillates from node to node, most
/// strongly next to the edges, where the exact pressure has a vertical tangent. The moments of the pressure
/// equal the moments of the nodal forces and do not oscillate.
std::vector<PressureProfile> profiles_of_cuts(const ContactSurface &surface,
                                              const std::vector<Eigen::Vector3d> &depths,
                                              const std::function<double(double)> &pressure);

/// Returns the pressure map of @p profiles, a grid. At least one profile must have a load.
PressureMap pressure_map_of(const std::vector<PressureProfile> &profiles);

} // namespace stemware::fem
