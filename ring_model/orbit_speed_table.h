#pragma once

#include "ring_model/motion.h"

#include <functional>
#include <vector>

namespace stemware::ring
{
/**
 * Orbit speed v(t) of a hand that is not a motor: a table, interpolated by the monotone cubic of Fritsch
 * and Carlson (SIAM J. Numer. Anal. 17 (1980) 238), which never leaves the range of its two neighbouring
 * entries and has a continuous acceleration dv/dt. Fewer than four entries are joined by straight lines.
 */
class OrbitSpeedTable
{
public:
  /**
   * @param times  Increasing times [s], at least two.
   * @param speeds Speeds v >= 0 at these times [m/s]: 0 at the beginning only, while the hand rests.
   * @throws std::invalid_argument naming the entry that is not allowed.
   */
  OrbitSpeedTable(std::vector<double> times, std::vector<double> speeds);

  /// Table of these entries joined by straight lines: another reading of what lies between them. Its
  /// acceleration jumps at the entries, where it is that of the line before.
  OrbitSpeedTable joined_by_lines() const;

  /// v(t) [m/s]. @throws std::out_of_range outside the table: it is not extrapolated.
  double speed(double time) const;

  /// dv/dt [m/s^2]. @throws std::out_of_range outside the table.
  double acceleration(double time) const;

  /// @p motion with the orbit speed and acceleration of that time. A hand at rest has a speed of a billionth
  /// of its largest: friction then has the direction of the motion to come.
  Motion motion_at(const Motion &motion, double time) const;

  bool starts_from_rest() const { return speeds.front() == 0.; }

  double max_speed() const;

  /// The first time [s] at which the hand is at least as fast as @p speed [m/s], and faster than 0: for 0,
  /// when it starts. @throws std::out_of_range for more than max_speed().
  double time_of(double speed) const;

private:
  void check_range(double time) const;

  std::vector<double> times;
  std::vector<double> speeds;
  std::function<double(double)> interpolant;
  std::function<double(double)> slope;
};
} // namespace stemware::ring
