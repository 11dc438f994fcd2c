#pragma once

#include <string>
#include <vector>

namespace stemware::pipeline
{

/// A spin that was measured.
struct MeasuredSpin
{
  double time = 0;  ///< since the glass was at rest [s]
  double omega = 0; ///< counter-clockwise > 0 [rad/s]
};

/// Measured spins, or yaw angles, of one run of a glass.
struct MeasuredRun
{
  std::vector<double> times;  ///< ascending; equal time stamps are possible [s]
  std::vector<double> values; ///< spins [rad/s] or yaw angles [rad], counter-clockwise > 0
  bool is_angle = false;
  std::string summary; ///< ColumnTable::summary(), and the number of equal time stamps
};

/// Finds the columns of time and spin in the table @p text (parse_columns()), those of time and yaw angle if
/// no heading names a spin, or the one with the heading @p column unless that is empty. Rows without a value
/// are skipped. Throws BadInput, which begins with @p setting and names the line, also for falling times and
/// for spins without a unit that look like degrees per second.
MeasuredRun parse_measured_run(const std::string &setting, const std::string &text,
                               const std::string &column = "");

/// Spins of a run: of angles their mean between two times, in the middle of these.
std::vector<MeasuredSpin> spins_of(const MeasuredRun &run);

} // namespace stemware::pipeline
