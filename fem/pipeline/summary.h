#pragma once

#include "fem/pipeline/study_result.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace stemware::pipeline
{

/// The content of summary.json, schema 1: program, parameters, load, contact (null without one), ring,
/// resolved friction, truncation, closures, files. SI units, or those of the study. @p files are the names of
/// all that is in the results folder. Throws std::runtime_error for a number that is not finite: JSON has no
/// word for it.
nlohmann::ordered_json summary(const Study &study, const StudyResult &result,
                               const std::vector<std::string> &files);

} // namespace stemware::pipeline
