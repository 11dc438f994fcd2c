#pragma once

#include "ring_model/friction_functionals.h"
#include "ring_model/load_model.h"
#include "ring_model/moment_balance.h"
#include "ring_model/motion.h"

#include <limits>
#include <memory>

namespace stemware::ring
{
/// All balances at one spin, in the slip frame.
struct RingEquilibrium
{
  RingStack load;             ///< normal load
  Wrench friction;            ///< T and tau_z of the table on the ring
  double moment_ratio;        ///< m = |M_N| / (N R / 2)
  double moment_residual;     ///< |required moment - moment of the load| / (N R)
  unsigned int n_evaluations; ///< loads computed on the way
};

/**
 * Ring whose load, friction and hand force satisfy all balances at once: T enters M_N, M_N enters lambda,
 * lambda enters T. Solved for M_N by Broyden's method, started from the balance of the first harmonic with
 * its Jacobian. docs/theory/closures.md.
 *
 * Truncated to n_max, only the kept harmonics exert friction. Normal force and M_N depend on the harmonics 0
 * and 1 only, so the truncated load still has them; the changed friction changes M_N and thereby the kept
 * harmonics. With n_max = 1 and a thin ring it is the formal first harmonic.
 */
class SelfConsistentRing
{
public:
  /// @throws std::invalid_argument if the motion is not allowed, there is no model, or @p n_max is 0: a load
  /// without a first harmonic has no moment.
  SelfConsistentRing(Closure closure, const Motion &motion, std::shared_ptr<const LoadModel> model,
                     unsigned int n_max = std::numeric_limits<unsigned int>::max());
  /// First harmonic on a ring of @p radius [m].
  SelfConsistentRing(Closure closure, const Motion &motion, double radius);

  /**
   * Returns the equilibrium at the spin @p omega [rad/s], converged to rounding.
   * @throws Tipping if the required moment exceeds the limit of the load model, std::runtime_error if the
   * iteration does not converge.
   */
  RingEquilibrium at(double omega) const;

  /// Yaw torque [N m] at the spin @p omega [rad/s]; throws as at().
  double torque(double omega) const { return at(omega).friction.torque; }

private:
  /// Residual of one Broyden step: required moment minus moment of the load, with the friction of the load of
  /// @p moment.
  struct Trial;
  Trial attempt(double omega, const Eigen::Vector2d &moment) const;
  Trial residual_of(RingStack load, double omega, const Eigen::Vector2d &moment) const;

  /// Returns the Jacobian of the residual for a first harmonic.
  Eigen::Matrix2d jacobian_of_first_harmonic(double omega) const;

  /// Returns @p moment, or the point closest to it on the line from @p from that the load model supports.
  Eigen::Vector2d within_limits(const Eigen::Vector2d &from, const Eigen::Vector2d &moment) const;

  /// Unit of moments, N R [N m].
  double moment_scale() const;

  /// Throws the exception of at() for an iteration that ended at @p moment with @p residual.
  [[noreturn]] void refuse(double omega, const Eigen::Vector2d &moment,
                           const Eigen::Vector2d &residual) const;

  /// m = |M_N| / (N R / 2).
  double moment_ratio(const Eigen::Vector2d &moment) const;

  Closure closure;
  Motion motion;
  std::shared_ptr<const LoadModel> model;
  unsigned int n_max;
};
} // namespace stemware::ring
