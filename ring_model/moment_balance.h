#pragma once

#include "ring_model/motion.h"

#include <Eigen/Core>

#include <string>

namespace stemware::ring
{
/// Moments that the normal load balances (docs/theory/closures.md).
enum class Closure
{
  paper, ///< the moment of the centripetal part of the hand force only
  hand,  ///< the moment of the whole hand force F = m a - T
  full   ///< as hand, plus the moment of the friction T about the centre of mass
};

/// Returns "paper", "hand" or "full".
std::string to_string(Closure closure);

/// Returns the lever arm h [m] of the friction T in M_N = moment without friction + h k x T: 0 for `paper`,
/// Delta z for `hand` (from the centre of mass of glass and liquid), z_CM + Delta z for `full`.
double friction_arm(Closure closure, const Motion &motion);

/// Returns the moment M_N of the normal forces about the ring's centre [N m], slip frame, that balances the
/// glass under the table's @p friction = (T_x, T_y) [N]: M_N = -Delta z k x F + z_CM k x T with F = m a - T,
/// reduced to the terms of @p closure, plus the moment of a liquid whose surface leans. At omega = 0 the
/// friction is exactly (-mu(v) N, 0).
Eigen::Vector2d required_moment(Closure closure, const Motion &motion, const Eigen::Vector2d &friction);

/// Returns required_moment() at omega = 0, for a load that does not depend on the spin.
Eigen::Vector2d required_moment_at_rest(Closure closure, const Motion &motion);
} // namespace stemware::ring
