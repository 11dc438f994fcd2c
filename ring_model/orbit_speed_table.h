#pragma once

#include "ring_model/motion.h"

#include <functional>
#include <vector>

namespace stemware::ring
{
/// Orbit speed v(t) from a table, interpolated by the monotone cubic of Fritsch and Carlson (SIAM J. Numer.
/// Anal. 17 (1980) 238): v stays between neighbouring entries and dv/dt is continuous; at either end dv/dt is
/// the slope of the line to the neighbour. Fewer than four entries are joined by straight lines.
class OrbitSpeedTable
{
public:
  /// @p times: at least two increasing times [s]. @p speeds: speeds v >= 0 at these times [m/s], 0 at the
  /// beginning only, while the hand rests. Throws std::invalid_argument naming the entry that is not allowed.
  OrbitSpeedTable(std::vector<double> times, std::vector<double> speeds);

  /// Returns the table with entries joined by straight lines, corners rounded within 1/1000 of an interval.
  OrbitSpeedTable joined_by_lines() const;

  /// Returns v(t) [m/s]. Throws std::out_of_range outside the table (no extrapolation).
  double speed(double time) const;

  /// Returns dv/dt [m/s^2]. Throws std::out_of_range outside the table.
  double acceleration(double time) const;

  /// Returns @p motion with the orbit speed and acceleration at @p time. At rest, v is 1e-9 of the largest
  /// speed: friction then has the direction of the motion to come.
  Motion motion_at(const Motion &motion, double time) const;

  /// Returns the times [s] at which the slope of dv/dt jumps.
  const std::vector<double> &knots() const { return knot_times; }

  bool starts_from_rest() const { return speeds.front() == 0.; }

  double max_speed() const;

  /// Returns the first time [s] at which v reaches @p speed [m/s]; for 0, the time at which the hand starts.
  /// Throws std::out_of_range above max_speed().
  double time_of(double speed) const;

private:
  void check_range(double time) const;

  std::vector<double> times;
  std::vector<double> speeds;
  std::vector<double> knot_times;
  std::function<double(double)> interpolant;
  std::function<double(double)> slope;
};
} // namespace stemware::ring
