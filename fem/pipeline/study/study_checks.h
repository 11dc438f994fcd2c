#pragma once

#include "fem/pipeline/study/study_entries.h"
#include "fem/pipeline/support/sentence.h"

#include <string>
#include <vector>

namespace stemware::pipeline
{

/// Returns "Section/Entry" of the given entries (Study::given_entries) that do not affect any result, in the
/// order of a study file: the modulus of a disc on a rigid substrate, the tilt under a given moment.
std::vector<std::string> unused_entries(const Study &study);

/// Returns a sentence that names @p entries; empty without entries.
std::string unused_entries_note(const std::vector<std::string> &entries);

/// Returns a sentence if @p value, in SI units, is outside StudyEntry::plausible: "Motion/Mass = 300 kg is
/// outside 0.02 to 2 kg for a glass; write 300 g if grams are meant." Empty otherwise, and for 0 of an
/// optional entry.
std::string implausible_note(const std::string &path, double value);

/// Returns implausible_note() of @p entry, whose @p value is implausible, with its values.
Sentence implausible_sentence(const StudyEntry &entry, double value);

/// Returns the note of each given entry with an effect.
std::vector<Sentence> implausible_sentences(const Study &study);
std::vector<std::string> implausible_notes(const Study &study);

/// Returns @p sentence, the reason why the glass tips at rest, preceded by implausible values, the likelier
/// cause: "Unusual values for a glass: Motion/Mass = 300 kg (0.02 to 2 kg). The closure ...".
std::string with_implausible_values(const Study &study, const std::string &sentence);

/// Throws BadInput for a glass that would tip at rest, with_implausible_values().
void require_no_tipping_at_rest(const Study &study);

} // namespace stemware::pipeline
