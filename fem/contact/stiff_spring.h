#pragma once

#include "fem/contact/contact_surface.h"
#include "fem/contact/interface_law.h"
#include "fem/contact/pressure_map.h"

#include <Eigen/Core>

#include <functional>
#include <memory>
#include <vector>

namespace stemware::fem
{

/// Returns a stiff Winkler interface of @p modulus [Pa/m] that approximates a hard interface. Its force and
/// moments across the rim are accurate, but its pressure at a point oscillates; on a crowned land, extent and
/// pressure map are therefore computed from the moments (PressureProfile).
std::shared_ptr<const InterfaceLaw> make_stiff_spring(double modulus);

/// Pressure across a narrow contact, p = peak (1 - x^2)^exponent with x = (r - middle) / half_width. Exponent
/// 1/2: Hertz's line contact; 1: crown on a layer much thinner than the contact is wide.
struct PressureProfile
{
  /// Returns the pressure at @p radius [Pa].
  double at(double radius) const;

  double azimuth = 0;    ///< azimuth of the cut [rad]
  double middle = 0;     ///< [m]
  double half_width = 0; ///< [m]
  double exponent = 0.5;
  double peak = 0; ///< [Pa]
};

/// Returns a profile for each cut of @p surface (radial lines) by azimuth, with the force, mean and variance
/// of the pressure and one exponent >= 1/2 from the mean kurtosis. @p depths: penetrations at the samples of
/// each line [m]. @p pressure: law p(penetration [m]) [Pa]. Empty without a load, and for a mean kurtosis
/// outside 1.8 ... 2.3, as of a pressure at the end of a land. The pressure of a stiff spring for a hard
/// interface oscillates from node to node; its moments, equal to the moments of the nodal forces, do not.
/// Collective.
std::vector<PressureProfile> profiles_of_cuts(const ContactSurface &surface,
                                              const std::vector<Eigen::Vector3d> &depths,
                                              const std::function<double(double)> &pressure);

/// Returns the pressure map of @p profiles, a grid. At least one profile must have a load.
PressureMap pressure_map_of(const std::vector<PressureProfile> &profiles);

} // namespace stemware::fem
