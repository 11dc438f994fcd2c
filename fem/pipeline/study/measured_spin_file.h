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

/// The points of Motion/Measured spin file, two columns, time and spin (read_column_file()), in any order.
/// Throws BadInput that names the line.
std::vector<MeasuredSpin> read_measured_spin_file(const std::string &file);

} // namespace stemware::pipeline
