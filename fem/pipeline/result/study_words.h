#pragma once

#include "fem/pipeline/result/results.h"
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

/// Returns results of a verb about @p study with its title (name of the study and @p what), inputs, sketch
/// and entries.
Results begun_results(const Study &study, const std::string &what);

} // namespace stemware::pipeline
