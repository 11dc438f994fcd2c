#pragma once

#include <functional>
#include <vector>

namespace stemware::ring
{
/// One ring of a stack.
struct WeightedRing
{
  double radius; ///< [m]
  double weight; ///< share of the normal force (and of the mass), positive; all shares add up to 1
};

/// Flat-bottomed body made of concentric rings: a ring, a stack of rings, an annulus or a disc of uniform
/// pressure, or any pressure p(r).
class SlidingBody
{
public:
  /// Normal pressure p(r) >= 0 at all @p radii [m] at once, in any unit: only its shape counts.
  using Pressure = std::function<std::vector<double>(const std::vector<double> &radii)>;

  /// One ring. @throws std::invalid_argument unless radius > 0 [m].
  static SlidingBody ring(double radius);

  /// Rings stacked by weight. @throws std::invalid_argument unless the weights are positive and add up to 1.
  static SlidingBody stack(std::vector<WeightedRing> rings);

  /// Uniform pressure between two radii [m]. @throws std::invalid_argument unless 0 <= inner < outer.
  static SlidingBody annulus(double inner_radius, double outer_radius);

  /// Uniform pressure on a disc [m].
  static SlidingBody disc(double radius) { return annulus(0., radius); }

  /// Any pressure between two radii [m], smooth between them. It may vanish at either radius like a square
  /// root, as Hertz's does. @throws std::invalid_argument unless 0 <= inner < outer, the pressure is finite,
  /// non-negative and not zero everywhere.
  static SlidingBody with_pressure(Pressure pressure, double inner_radius, double outer_radius);

  /**
   * Returns the rings that represent the body if the radius @p still = v / |omega| [m] contains a point at
   * rest. An annulus is represented by Gauss nodes on both sides of that radius, clustered there because
   * friction is singular (like x ln x); integrals over the annulus are then exact to rounding. For any other
   * pressure the nodes are clustered at its two radii too.
   */
  std::vector<WeightedRing> rings(double still) const;

  /// Outer radius [m].
  double outer_radius() const { return outer; }

  /// Mean of r^2 over the weight [m^2]: the gyration radius squared of a body whose mass is spread like its
  /// weight.
  double mean_square_radius() const { return mean_square; }

  /// Mean of r^exponent over the weight [m^exponent].
  double mean_power(double exponent) const;

private:
  SlidingBody(std::vector<WeightedRing> stacked, double inner_radius, double outer_radius);

  std::vector<WeightedRing> stacked; ///< empty for an annulus or a pressure
  double inner;
  double outer;
  Pressure pressure = {}; ///< empty: uniform
  double unit = 1.;       ///< weight per pressure and area
  double mean_square = 0.;
};
} // namespace stemware::ring
