#pragma once

#include "fem/pipeline/document/json.h"
#include "fem/pipeline/study/study.h"

#include <string>

namespace stemware::pipeline
{

struct StudyEntry;

/// Returns a number in the common unit of the dimension @p unit that gives the shortest text: "300 g".
std::string in_usual_unit(double value, const std::string &unit);

/// Returns the value of an entry of @p study as the user wrote it, "300 g"; in the unit of the shortest text
/// if it was not given, or given without a unit.
std::string in_usual_unit(const Study &study, const StudyEntry &entry);

/// Returns "The default glass", or the name of the study.
std::string title_of(const Study &study);

/// Returns the inputs as one sentence, in the units of the user.
std::string inputs_of(const Study &study);

/// Returns the entries that differ from the defaults: entry, value, default, unit.
nlohmann::ordered_json changed_entries(const Study &study);

/// Returns all entries of the study: entry, value, unit, meaning.
nlohmann::ordered_json all_entries(const Study &study);

/// Returns the labels and lengths of the sketch of the glass: values of its entries by name, table, hand.
nlohmann::ordered_json sketch_labels(const Study &study);

} // namespace stemware::pipeline
