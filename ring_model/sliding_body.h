#pragma once

#include <vector>

namespace stemware::ring
{
/// One ring of a stack.
struct WeightedRing
{
  double radius; ///< [m]
  double weight; ///< share of the normal force (and of the mass), positive; all shares add up to 1
};

/// A flat-bottomed body made of concentric rings: a ring, a stack of rings, an annulus or a disc of uniform
/// pressure.
class SlidingBody
{
public:
  /// One ring. @throws std::invalid_argument unless radius > 0 [m].
  static SlidingBody ring(double radius);

  /// Rings stacked by weight. @throws std::invalid_argument unless the weights are positive and add up to 1.
  static SlidingBody stack(std::vector<WeightedRing> rings);

  /// Uniform pressure between two radii [m]. @throws std::invalid_argument unless 0 <= inner < outer.
  static SlidingBody annulus(double inner_radius, double outer_radius);

  /// Uniform pressure on a disc [m].
  static SlidingBody disc(double radius) { return annulus(0., radius); }

  /**
   * The rings that stand for the body when the radius @p still = v / |omega| [m] has a point at rest. For an
   * annulus they are the nodes of Gauss rules on both sides of that radius, clustered there because friction
   * is singular (like x ln x): integrals over the annulus are then exact to rounding.
   */
  std::vector<WeightedRing> rings(double still) const;

  /// Outer radius [m].
  double outer_radius() const { return outer; }

  /// Mean of r^2 over the weight [m^2]: the gyration radius squared of a body whose mass is spread like its
  /// weight.
  double mean_square_radius() const;

private:
  SlidingBody(std::vector<WeightedRing> stacked, double inner_radius, double outer_radius);

  std::vector<WeightedRing> stacked; ///< empty for an annulus
  double inner;
  double outer;
};
} // namespace stemware::ring
