#pragma once

#include "fem/pipeline/study/study.h"

#include <string>

namespace stemware::pipeline
{

/// Sets the section of a glass with Glass/Shape = profile from the points of Glass/Profile file, and contact
/// and crown radius, if not given, from the circle through the points of the land (GlassSection::rim_circle).
/// A given value equal to the circle's counts as fitted, because parameters.prm of a result contains both.
/// Other glasses lose their section. Throws BadInput.
void attach_profile(Study &study);

/// Returns a note on the points of a drawn section and its fitted circle, for the console; empty for other
/// sections.
std::string profile_note(const Study &study);

} // namespace stemware::pipeline
