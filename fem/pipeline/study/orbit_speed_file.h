#pragma once

#include "ring_model/orbit_speed_table.h"

#include <string>

namespace stemware::pipeline
{

struct Study;

/// The orbit speed v(t) of a hand that is no motor, from a CSV file: a header with the names and units of
/// both columns, "t (s), v (m/s)" or "time (ms), speed (cm/s)", then two numbers a line, times increasing,
/// speeds greater than 0. Lines that are empty or begin with # are passed over. Throws BadInput that names
/// the line.
ring::OrbitSpeedTable read_orbit_speed_file(const std::string &file);

/// Refuses a study whose Motion/Orbit speed file cannot be read, does not last from 0 to Motion/End time, or
/// does not go with the rest of the study. Throws BadInput.
void check_orbit_speed_file(const Study &study);

} // namespace stemware::pipeline
