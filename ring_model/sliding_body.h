#pragma once

#include "ring_model/friction_functionals.h"

#include <functional>
#include <utility>
#include <vector>

namespace stemware::ring
{
/// Flat-bottomed body: a ring, an annulus or a disc of uniform pressure, or any pressure p(r).
class SlidingBody
{
public:
  /// Normal pressure p(r) >= 0 at all @p radii [m] at once, in any unit: only its shape counts.
  using Pressure = std::function<std::vector<double>(const std::vector<double> &radii)>;

  /// Returns one ring. Throws std::invalid_argument unless radius > 0 [m].
  static SlidingBody ring(double radius);

  /// Returns an annulus of uniform pressure [m]. Throws std::invalid_argument unless 0 <= inner < outer.
  static SlidingBody annulus(double inner_radius, double outer_radius);

  /// Returns a body with uniform pressure on a disc [m].
  static SlidingBody disc(double radius) { return annulus(0., radius); }

  /// Returns a body with @p pressure, smooth between two radii [m] at which it may vanish like a square root
  /// (Hertz). Throws std::invalid_argument unless 0 <= inner < outer and the pressure is finite, >= 0, and >
  /// 0 somewhere.
  static SlidingBody with_pressure(Pressure pressure, double inner_radius, double outer_radius);

  /// Returns the outer radius [m].
  double outer_radius() const { return outer; }

  /// Returns the mean of r^exponent, weighted with the normal force [m^exponent]. For exponent 2, the squared
  /// gyration radius if the mass is distributed like the normal force.
  double mean_power(double exponent) const;

  /// Returns the table's friction in the slip frame at the speed v >= 0 [m/s] and the spin omega [rad/s]. @p
  /// limit: mu N [N]. Throws std::invalid_argument if the body neither slides nor spins.
  Wrench friction(double limit, double speed, double omega) const;

private:
  SlidingBody(double inner_radius, double outer_radius);

  /// Returns radius [m] and weight (share of the normal force; all shares add up to 1) of rings at Gauss
  /// nodes that represent the body, clustered at its two radii and on both sides of @p still = v / |omega|
  /// [m], the radius of a point at rest, where friction is singular (x ln x). Integrals over an annulus are
  /// exact to rounding.
  std::vector<std::pair<double, double>> rings(double still) const;

  double inner, outer; ///< equal: one ring
  Pressure pressure = {};
  double unit = 1.; ///< weight per pressure and area
};
} // namespace stemware::ring
