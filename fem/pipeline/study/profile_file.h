#pragma once

#include "fem/pipeline/study/study.h"

#include <string>

namespace stemware::pipeline
{

/// Gives a glass whose Glass/Shape is profile its section, from the points (r, z) of Glass/Profile file, two
/// columns (read_column_file()), and those of contact radius and crown radius that the study was not given,
/// from the points of the land (GlassSection::rim_circle); other glasses lose their section. Values that were
/// given and are those of the points count as theirs: so they stand in the study that a folder of results
/// repeats. Throws BadInput with one sentence.
void attach_profile(Study &study);

/// A sentence without subject for the console: which points the section has, and what was fitted to them,
/// with standard errors; empty where it is not drawn.
std::string profile_note(const Study &study);

/// Contact and crown radius by the points of the land: "R = 29.76 ± 0.12 mm, crown 4.4 ± 0.9 mm (rms 19 µm,
/// 10 points)"; only what follows from them. Empty where the points have no scatter.
std::string fitted_rim(const Study &study);

/// Whether the points leave the crown open: its standard error is half of it or more.
bool crown_is_open(const fem::RimCircle &circle);

} // namespace stemware::pipeline
