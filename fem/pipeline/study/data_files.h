#pragma once

#include "ring_model/load/ring_stack.h"
#include "ring_model/orbit_speed_table.h"

#include <string>

namespace stemware::pipeline
{

/// Reads the orbit speed v(t) from Motion/Orbit speed file by parse_columns(): times increase, and speeds
/// are positive except at the beginning, where the hand may be at rest. Throws BadInput that names the line.
ring::OrbitSpeedTable read_orbit_speed_file(const std::string &file);

/// Reads lambda(theta) from Load/File, a table of Fourier coefficients:
///
///   # ring radius: 0.03 (m)
///   0  0.4684   0
///   1  0       -0.13
///
/// with rows n a_n b_n [N/rad] for n = 0, 1, 2, ... without gaps. Further columns and lines that start with #
/// are ignored, as in harmonics.dat of a results folder. Throws BadInput that names the line.
ring::RingStack read_load_file(const std::string &file);

} // namespace stemware::pipeline
