#pragma once

#include "fem/pipeline/analysis/quantity.h"

#include <string>

namespace stemware::pipeline
{

/// Returns the text of summary.schema.json: the JSON Schema of the summaries of all verbs, and under
/// "definitions/files" the columns of the data files with key, heading without unit (name), unit, and
/// description (label).
std::string summary_schema();

/// Returns the unit of @p key, a member of the part @p part of the summary or of the entries of this list;
/// empty for words.
std::string unit_in_summary(const std::string &part, const std::string &key);

} // namespace stemware::pipeline
