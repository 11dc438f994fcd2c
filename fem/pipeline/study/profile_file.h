#pragma once

#include "fem/pipeline/study/study.h"

#include <string>

namespace stemware::pipeline
{

/// Reads the section of a glass with Glass/Shape = profile from Glass/Profile file; removes the section of
/// other glasses. Contact and crown radius that are not given follow from the circle through the points of
/// the land (GlassSection::rim_circle); a given value equal to the circle's counts as not given, because
/// parameters.prm of a result has both. Throws BadInput.
void attach_profile(Study &study);

/// Returns a note on the points and the fitted circle of a drawn section; empty for other sections.
std::string profile_note(const GlassSection &glass);

} // namespace stemware::pipeline
