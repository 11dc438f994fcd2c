#pragma once

#include "ring_model/no_balance.h"
#include "ring_model/ring_stack.h"
#include "ring_model/slip.h"

#include <Eigen/Core>

#include <limits>

namespace stemware::ring
{
/// How a ring answers to the normal force and the moment that equilibrium demands of it.
class LoadModel
{
public:
  virtual ~LoadModel() = default;

  /**
   * The load with the resultants N = @p normal_force [N] and M_N = @p moment [N m] in the slip frame, at @p
   * slip: models without friction coupling and waviness do not depend on that.
   * @throws Tipping if no load that only pushes can carry the moment, std::invalid_argument for values that
   * are not finite or not allowed.
   */
  virtual RingStack rings(double normal_force, const Eigen::Vector2d &moment,
                          const Slip &slip = {}) const = 0;

  /// Nominal contact radius R [m], which defines the moment ratio m = |M_N| / (N R / 2).
  virtual double radius() const = 0;

  /// Moment ratio above which a part of the ring carries no load (or a negative one, where the model is
  /// formal).
  virtual double lift_off_ratio() const = 0;

  /// Moment ratios up to which (not including it) rings() has an answer.
  virtual double moment_ratio_limit() const { return 2.; }

  /// Relative accuracy of rings() where that is not rounding: a balance is not asked to be better.
  virtual double accuracy() const { return 0.; }

  /// Whether rings() takes so long that curves of thousands of loads should be interpolated.
  virtual bool is_costly() const { return false; }

  /// Whether rings() follows the moment it is given; a frozen load does not.
  virtual bool follows_moment() const { return true; }
};

/// The first harmonic: exact for a linear support that holds the whole ring, formal (negative load) for m
/// > 1.
class FirstHarmonicModel : public LoadModel
{
public:
  /// @param radius R > 0 [m]. @throws std::invalid_argument otherwise.
  explicit FirstHarmonicModel(double radius);

  RingStack rings(double normal_force, const Eigen::Vector2d &moment, const Slip &slip = {}) const override;
  double radius() const override { return ring_radius; }
  double lift_off_ratio() const override { return 1.; }
  double moment_ratio_limit() const override { return std::numeric_limits<double>::infinity(); }

private:
  double ring_radius;
};

/// A load that stays what it is, whatever is asked of it: a contact solution kept frozen while the spin
/// changes.
class FixedLoad : public LoadModel
{
public:
  explicit FixedLoad(RingStack load)
      : fixed(std::move(load))
  {
  }

  /// The fixed load; the resultants asked for do not matter.
  RingStack rings(double normal_force, const Eigen::Vector2d &moment, const Slip &slip = {}) const override;
  double radius() const override { return fixed.radius(); }

  /// Zero if the load is negative somewhere, infinite otherwise.
  double lift_off_ratio() const override;
  double moment_ratio_limit() const override { return std::numeric_limits<double>::infinity(); }
  bool follows_moment() const override { return false; }

private:
  RingStack fixed;
};
} // namespace stemware::ring
