#pragma once

#include <stdexcept>
#include <string>

namespace stemware::ring
{
/// Failure of a balance of forces, moments or torques: there is no value to report. All other exceptions
/// are bad input or faults of the program.
class NoBalance : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Moment beyond the limit of the normal forces: the glass tips (moment ratio >= 2).
class Tipping : public NoBalance
{
public:
  using NoBalance::NoBalance;
};

/// Torque without a zero in the searched range: the spin-up does not end.
class NoTerminalSpin : public NoBalance
{
public:
  using NoBalance::NoBalance;
};

/// Spin-up that reaches a spin without a balance. The failure is nested (std::rethrow_if_nested).
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
