#pragma once

#include "fem/pipeline/document/json.h"
#include "fem/pipeline/study/study.h"

#include <string>

namespace stemware::pipeline
{

struct StudyEntry;

/// A number in the unit, of those that people use beside the SI unit @p unit, that makes it short: "300 g".
std::string in_usual_unit(double value, const std::string &unit);

/// The value of an entry of @p study as its user wrote it, "300 g". An entry that was not given, or given
/// without a unit, is in the unit that makes it short.
std::string in_usual_unit(const Study &study, const StudyEntry &entry);

/// "The default glass", or the name of the study.
std::string title_of(const Study &study);

/// The inputs in one sentence, in the units of the study's user.
std::string inputs_of(const Study &study);

/// Entries of the study that differ from the defaults: entry, value, default, unit.
nlohmann::ordered_json changed_entries(const Study &study);

/// All entries of the study: entry, value, unit, meaning.
nlohmann::ordered_json all_entries(const Study &study);

/// Words and lengths at the sketch of the glass: the values of its entries by their names, the table, the
/// hand.
nlohmann::ordered_json sketch_labels(const Study &study);

} // namespace stemware::pipeline
