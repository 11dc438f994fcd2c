#pragma once

#include "fem/geometry/meridian_section.h"
#include "fem/pipeline/study/study.h"

#include <string>
#include <vector>

namespace stemware::pipeline
{

/// The points (r, z) in m of a drawn meridian, from a file of two columns (read_column_file()). Throws
/// BadInput with one sentence that names the line.
std::vector<fem::SectionVertex> read_profile_file(const std::string &file);

/// Whether the entry at @p path, if it is not given, follows from the points of a drawn section.
bool follows_from_profile(const std::string &path);

/// Gives a glass whose Glass/Shape is profile its section, from Glass/Profile file, and those of contact
/// radius and crown radius that the study was not given, from the points of the land
/// (GlassSection::rim_circle); other glasses lose their section. Throws BadInput with one sentence.
void attach_profile(Study &study);

/// A sentence without subject for the console: which points the section has, and what was fitted to them;
/// empty where it is not drawn.
std::string profile_note(const Study &study);

} // namespace stemware::pipeline
