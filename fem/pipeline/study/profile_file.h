#pragma once

#include "fem/pipeline/study/study.h"

#include <string>

namespace stemware::pipeline
{

/// Gives a glass whose Glass/Shape is profile its section, from the points of Glass/Profile file, and the
/// contact radius and crown radius that were not given, from the circle through the points of the land
/// (GlassSection::rim_circle). A given value that is the circle's counts as fitted: the study that a folder
/// of results repeats gives both. Other glasses lose their section. Throws BadInput.
void attach_profile(Study &study);

/// Points of a drawn section and the circle that was fitted to them, for the console; empty for other
/// sections.
std::string profile_note(const Study &study);

} // namespace stemware::pipeline
