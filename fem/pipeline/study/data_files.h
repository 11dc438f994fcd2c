#pragma once

#include "fem/pipeline/study/study.h"
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

/// Reads the section of a glass with Glass/Shape = profile from Glass/Profile file; removes the section of
/// other glasses. Contact and crown radius that are not given follow from the circle through the points of
/// the land (GlassSection::rim_circle); a given value equal to the circle's counts as not given, because
/// parameters.prm of a result has both. Throws BadInput.
void attach_profile(Study &study);

/// Returns a note on the points and the fitted circle of a drawn section; empty for other sections.
std::string profile_note(const GlassSection &glass);

} // namespace stemware::pipeline
