#pragma once

#include "fem/pipeline/study/study.h"

#include <string>
#include <vector>

namespace stemware::pipeline
{

/// "Section/Entry" of the entries that a study was given (Study::given_entries) and that no result of it
/// depends on, in the order of a study file: the modulus of a disc on a rigid substrate, the tilt under a
/// given moment.
std::vector<std::string> idle_entries(const Study &study);

/// One sentence for the console that names @p entries; empty where there are none.
std::string idle_note(const std::vector<std::string> &entries);

} // namespace stemware::pipeline
