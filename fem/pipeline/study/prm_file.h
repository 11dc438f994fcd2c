#pragma once

#include "fem/pipeline/study/study_entries.h"

#include <string>
#include <vector>

namespace stemware::pipeline
{

/// Sets @p entries from @p text, the content of the study file @p file in the format of deal.II's parameter
/// files:
///
///   subsection Glass          # a comment
///     set Contact radius = 0.03
///   end
///
/// Sections may come in any order and more than once, an entry once; a line that ends in a backslash goes on
/// in the next one. Throws BadInput, with the line, about the first thing that is wrong.
void read_prm(const std::string &file, const std::string &text, const std::vector<StudyEntry> &entries);

/// The entries in that format with their present values; with @p comments also their help and what they take.
std::string prm_text(const std::vector<StudyEntry> &entries, bool comments);

} // namespace stemware::pipeline
