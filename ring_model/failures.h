#pragma once

#include <optional>
#include <stdexcept>
#include <string>

namespace stemware::ring
{
/// Failure of a balance of forces, moments or torques; any other exception is bad input or a program error.
class NoBalance : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;

  /// Returns whether the glass tips: no compressive load has the required moment.
  virtual bool tips() const { return false; }
};

/// Moment beyond the limit of the normal forces: the glass tips (moment ratio >= 2).
class Tipping : public NoBalance
{
public:
  using NoBalance::NoBalance;
  bool tips() const override { return true; }
};

/// Exception for a torque without a zero in the searched range: the spin-up does not end.
class NoTerminalSpin : public NoBalance
{
public:
  using NoBalance::NoBalance;
};

/// Exception for a spin-up that reaches a spin without a balance of moments; the failure is nested.
class BalanceLost : public NoBalance
{
public:
  BalanceLost(const std::string &message, double last_spin, bool tips)
      : NoBalance(message)
      , last_spin(last_spin)
      , is_tipping(tips)
  {
  }
  bool tips() const override { return is_tipping; }

  const double last_spin; ///< last spin in balance [rad/s]

private:
  const bool is_tipping;
};

/// Returns the result of @p find. If @p find throws NoBalance: std::nullopt, and its message in @p reason.
template <typename Find>
auto find_or_nullopt(const Find &find, std::string *reason = nullptr) -> std::optional<decltype(find())>
{
  try
  {
    return find();
  }
  catch (const NoBalance &failure)
  {
    if (reason)
      *reason = failure.what();
    return std::nullopt;
  }
}
} // namespace stemware::ring
