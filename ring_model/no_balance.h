#pragma once

#include <stdexcept>
#include <string>

namespace stemware::ring
{
/// Forces, moments or torques cannot be in balance, or no balance was found: there is no value to report. All
/// other exceptions mean bad input, or a fault of the program.
class NoBalance : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// The moment asked for is more than the normal forces can carry: the glass tips (moment ratio >= 2).
class Tipping : public NoBalance
{
public:
  using NoBalance::NoBalance;
};

/// The torque keeps its sign as far as one searches: nothing ends the spin-up.
class NoTerminalSpin : public NoBalance
{
public:
  using NoBalance::NoBalance;
};

/// The spin-up comes to a spin beyond which there is no balance. The failure met there is nested
/// (std::rethrow_if_nested).
class BalanceLost : public NoBalance
{
public:
  BalanceLost(const std::string &message, double last_spin)
      : NoBalance(message)
      , last_spin(last_spin)
  {
  }
  const double last_spin; ///< the last one in balance [rad/s]
};
} // namespace stemware::ring
