#pragma once

#include "fem/pipeline/analysis/quantity.h"

#include <string>

namespace stemware::pipeline
{

/// Returns summary.schema.json: the JSON Schema of the summaries of all verbs, and under "definitions/files"
/// key, heading without unit (name), unit and description (label) of the columns of data files.
std::string summary_schema();

/// Returns the unit of @p key in @p part of the summary, or in its entries if it is a list; empty for words.
std::string unit_in_summary(const std::string &part, const std::string &key);

} // namespace stemware::pipeline
