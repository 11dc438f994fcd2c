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

/// Pressure across a narrow contact, p = peak (1 - x^2)^exponent with x = (r - middle) / half_width. Exponent
/// 1/2: Hertz's line contact; 1: crown on a layer much thinner than the contact is wide.
struct PressureProfile
{
  /// Returns the profile with @p exponent and force, middle, variance of @p moments; peak 0 without a force.
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

/// Returns the pressure moments of each cut of @p surface (radial lines) by azimuth, from the penetration @p
/// depths [m] at the samples of each line and the law @p pressure(penetration [m]) [Pa]. Empty without load.
/// Collective.
std::vector<PressureMoments> moments_of_cuts(const ContactSurface &surface,
                                             const std::vector<Eigen::Vector3d> &depths,
                                             const std::function<double(double)> &pressure);

/// Returns a profile for each of moments_of_cuts(), with one exponent >= 1/2 from the mean kurtosis. Empty
/// without a load, and for a mean kurtosis outside 1.8 ... 2.3, as of a pressure at the end of a land. The
/// pressure of a stiff spring for a hard interface oscillates from node to node; its moments, equal to the
/// moments of the nodal forces, do not.
std::vector<PressureProfile> profiles_of_cuts(const ContactSurface &surface,
                                              const std::vector<Eigen::Vector3d> &depths,
                                              const std::function<double(double)> &pressure);

/// Returns the pressure map of @p profiles, a grid. At least one profile must have a load.
PressureMap pressure_map_of(const std::vector<PressureProfile> &profiles);

} // namespace stemware::fem
