#pragma once

#include "fem/pipeline/study/study_entries.h"

#include <string>
#include <vector>

namespace stemware::pipeline
{

/// Returns "Section/Entry" of the given @p entries (StudyEntry::is_given) that affect no result, in the order
/// of a study file: for example the modulus of a disc on a rigid substrate.
std::vector<std::string> unused_entries(const std::vector<StudyEntry> &entries);

/// Returns a sentence if @p value [SI] of @p entry is outside StudyEntry::plausible: "Motion/Mass = 300 kg is
/// outside 0.02 to 2 kg for a glass; write 300 g if grams are meant."; empty otherwise, and for an optional
/// entry 0.
std::string implausible_note(const StudyEntry &entry, double value);

/// Returns the implausible_note() of each of @p entries that is given and has an effect.
std::vector<std::string> implausible_notes(const std::vector<StudyEntry> &entries);

/// Throws ring::Tipping if the glass would tip at rest. Implausible values, the likelier cause, begin the
/// message: "Unusual values for a glass: Motion/Mass = 300 kg (0.02 to 2 kg). The glass would tip ...".
void require_no_tipping_at_rest(const Study &study);

} // namespace stemware::pipeline
