#pragma once

#include "ring_model/coulomb_ring.h"
#include "ring_model/load_model.h"
#include "ring_model/moment_balance.h"
#include "ring_model/motion.h"
#include "ring_model/terminal_spin.h"

#include <memory>
#include <string>
#include <vector>

namespace stemware::ring
{
/// How the ring stands on the table.
enum class ContactState
{
  full_contact, ///< every point carries load
  lift_off,     ///< a part of the ring carries none (a formal load is negative there)
  tipping       ///< m >= 2: only a formal load can do that, a real one throws Tipping
};

/// "full contact", "lift-off" or "tipping".
std::string to_string(ContactState state);

/// Where the search for a balance begins, and what it leaves for a balance nearby.
struct BalanceStart
{
  Eigen::Vector2d moment;   ///< M_N [N m]
  Eigen::Matrix2d jacobian; ///< of required minus carried moment with respect to M_N
};

/// All balances at one spin, in the slip frame.
struct RingEquilibrium
{
  RingStack load;             ///< normal load
  Wrench friction;            ///< T and tau_z of the table on the ring
  Eigen::Vector2d hand_force; ///< F = m a - T [N]
  double moment_ratio;        ///< m = |M_N| / (N R / 2)
  double moment_residual;     ///< |required - carried moment| / (N R); large only for a fixed load
  ContactState contact;       ///< from the moment ratio
  unsigned int n_evaluations; ///< loads computed on the way
  BalanceStart balance;       ///< to start from at a spin nearby
};

/**
 * The ring whose load, friction and hand force satisfy all balances at once: T enters M_N, M_N enters lambda,
 * lambda enters T. Solved for M_N by Broyden's method, started from the closed form of the first harmonic and
 * its Jacobian, so that a first-harmonic load takes one step, or from what is known of spins nearby.
 * docs/theory/closures.md.
 */
class SelfConsistentRing
{
public:
  /// @throws std::invalid_argument if the motion is not allowed or there is no model.
  SelfConsistentRing(Closure closure, const Motion &motion, std::shared_ptr<const LoadModel> model);

  /**
   * The equilibrium at the spin @p omega [rad/s] with the marks of glass and table at @p orientation,
   * searched from @p start if given; where that fails, and without it, from first_harmonic_start(). Sought to
   * rounding or to the load model's accuracy.
   * @throws Tipping if the required moment is more than the ring can carry, std::runtime_error if the
   * iteration does not converge.
   */
  RingEquilibrium at(double omega, const BalanceStart *start = nullptr,
                     const Orientation &orientation = {}) const;

  /// Moment and Jacobian of the first harmonic in balance at @p omega, in closed form.
  BalanceStart first_harmonic_start(double omega) const;

  /// Yaw torque [N m] at the spin @p omega [rad/s]; throws as at().
  double torque(double omega) const { return at(omega).friction.torque; }

  /// The terminal spin reached from rest; throws as at() and ring::terminal_spin().
  TerminalSpin terminal_spin() const;

  /// All terminal spins in [@p lower, @p upper] [rad/s]; throws as at() and ring::all_terminal_spins().
  std::vector<TerminalSpin> terminal_spins(double lower, double upper, unsigned int n_intervals = 400) const;

private:
  /// Required minus carried moment if the friction is that of the load carrying @p moment.
  struct Trial;
  Trial attempt(double omega, const Orientation &orientation, const Eigen::Vector2d &moment) const;

  /// Broyden's method.
  struct Search;
  Search search(double omega, const Orientation &orientation, const BalanceStart &start) const;

  /// @p moment, or as much of the way from @p from to it as the load model can carry.
  Eigen::Vector2d within_limits(const Eigen::Vector2d &from, const Eigen::Vector2d &moment) const;

  /// The unit of moments, N R [N m].
  double moment_scale() const;

  /// Throws what at() throws when the iteration ended at @p moment with @p residual.
  [[noreturn]] void refuse(double omega, const Eigen::Vector2d &moment,
                           const Eigen::Vector2d &residual) const;

  /// m = |M_N| / (N R / 2).
  double moment_ratio(const Eigen::Vector2d &moment) const;

  Closure closure;
  Motion motion;
  std::shared_ptr<const LoadModel> model;
};
} // namespace stemware::ring
