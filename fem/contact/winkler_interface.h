#pragma once

#include "fem/contact/pressure_law.h"

#include <cmath>
#include <utility>

namespace stemware::fem
{

/// Winkler's interface: pressure p = k d for a penetration d > 0, else 0. Integrated along contact lines
/// exactly, between the roots of the penetration.
struct WinklerInterface : PressureInterface<WinklerInterface>
{
  explicit WinklerInterface(double modulus = 1e10)
      : modulus(modulus)
  {
  }

  double stiffness_at(double) const override { return modulus; }
  /// Returns the half-width b [m] of the pressure k (b^2 - x^2) / (2 rho), crown radius rho.
  double half_width(double line_load, double crown_radius) const override
  {
    return std::cbrt(1.5 * line_load * crown_radius / modulus);
  }
  double penetration_at(double pressure) const override { return pressure / modulus; }
  std::shared_ptr<const InterfaceLaw> softened(double factor) const override
  {
    return std::make_shared<WinklerInterface>(modulus / factor);
  }

  double modulus; ///< k [Pa/m]

  double pressure(double depth) const { return depth > 0 ? modulus * depth : 0; }
  std::pair<double, double> pressure_and_stiffness(double depth) const
  {
    return { pressure(depth), modulus };
  }
  double cutoff_depth(double) const { return 0; }

  template <typename Visitor>
  void integrate(const AreaElement &area, const Eigen::Vector3d &depth, const Visitor &visit) const
  {
    for_each_loaded_point(area, depth, visit);
  }

  void validate() const
  {
    require_positive("Foundation modulus", modulus, "Pa/m", "cork about 1e9, lacquered wood about 1e11");
  }
};

} // namespace stemware::fem
