#pragma once

#include "ring_model/orbit_speed_table.h"

#include <string>

namespace stemware::pipeline
{

struct Study;

/// The orbit speed v(t) of a hand that is no motor, from a file of two columns, time and speed
/// (read_column_file()): times increasing, speeds greater than 0. Throws BadInput that names the line.
ring::OrbitSpeedTable read_orbit_speed_file(const std::string &file);

/// Gives a study the speeds of its Motion/Orbit speed file, MotionSection::orbit_speeds, where it names one.
/// Throws as read_orbit_speed_file().
void attach_orbit_speeds(Study &study);

} // namespace stemware::pipeline
