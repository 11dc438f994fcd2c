#pragma once

#include "ring_model/load/require.h"
#include "ring_model/load/ring_stack.h"
#include "ring_model/no_balance.h"

#include <Eigen/Core>

#include <limits>

namespace stemware::ring
{
/// Response of a ring to the normal force and the moment of equilibrium.
class LoadModel
{
public:
  virtual ~LoadModel() = default;

  /**
   * Returns the load with the resultants N = @p normal_force [N] and M_N = @p moment [N m] in the slip frame.
   * @throws Tipping if no compressive load has the moment, std::invalid_argument for values that
   * are not finite or not allowed.
   */
  virtual RingStack rings(double normal_force, const Eigen::Vector2d &moment) const = 0;

  /// Nominal contact radius R [m], which defines the moment ratio m = |M_N| / (N R / 2).
  virtual double radius() const = 0;

  /// Moment ratio below which rings() has a solution.
  virtual double moment_ratio_limit() const { return 2.; }
};

/// First harmonic: exact for a linear support in full contact, formal (negative load) for m > 1.
class FirstHarmonicModel : public LoadModel
{
public:
  /// @param radius R > 0 [m]. @throws std::invalid_argument otherwise.
  explicit FirstHarmonicModel(double radius)
      : ring_radius(radius)
  {
    require_positive(radius, "the ring radius", "m");
  }

  RingStack rings(double normal_force, const Eigen::Vector2d &moment) const override
  {
    return RingStack::first_harmonic(normal_force, moment, ring_radius);
  }
  double radius() const override { return ring_radius; }
  double moment_ratio_limit() const override { return std::numeric_limits<double>::infinity(); }

private:
  double ring_radius;
};
} // namespace stemware::ring
