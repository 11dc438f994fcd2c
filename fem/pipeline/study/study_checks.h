#pragma once

#include "fem/pipeline/study/study.h"

#include <string>
#include <vector>

namespace stemware::pipeline
{

/// "Section/Entry" of the entries that a study was given (Study::given_entries) and that no result of it
/// depends on, in the order of a study file: the modulus of a disc on a rigid substrate, the tilt under a
/// given moment.
std::vector<std::string> unused_entries(const Study &study);

/// One sentence for the console that names @p entries; empty where there are none.
std::string unused_entries_note(const std::vector<std::string> &entries);

/// One sentence if @p value, in SI units, is one that no glass on a table has (StudyEntry::plausible):
/// "Motion/Mass = 300 kg is outside 0.02 to 2 kg for a glass; write 300 g if grams are meant." Empty
/// otherwise, and for the 0 of what may be left out.
std::string implausible_note(const std::string &path, double value);

/// An implausible_note() for each entry that the study was given and that has an effect.
std::vector<std::string> implausible_notes(const Study &study);

/// Returns @p sentence, why the glass tips at rest, behind the values that no glass has, the likelier
/// trouble: "Unusual values for a glass: Motion/Mass = 300 kg (0.02 to 2 kg). The closure ...".
std::string with_implausible_values(const Study &study, const std::string &sentence);

/// Throws BadInput for a glass that would tip at rest, with_implausible_values().
void require_no_tipping_at_rest(const Study &study);

} // namespace stemware::pipeline
