#pragma once

#include "ring_model/orbit_speed_table.h"

#include <string>

namespace stemware::pipeline
{

struct Study;

/// The orbit speed v(t) of a hand that is no motor, from a file of two columns, time and speed
/// (read_column_file()): times increasing, speeds greater than 0. Throws BadInput that names the line.
ring::OrbitSpeedTable read_orbit_speed_file(const std::string &file);

/// Refuses a study whose Motion/Orbit speed file cannot be read, does not last from 0 to Motion/End time, or
/// does not go with the rest of the study. Throws BadInput.
void check_orbit_speed_file(const Study &study);

} // namespace stemware::pipeline
