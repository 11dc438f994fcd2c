#pragma once

#include "fem/pipeline/app/options.h"

namespace stemware::pipeline
{

/// Puts the glass of a study under every closure on every kind of load, and writes the folder of the results.
/// Collective over all ranks. Throws as run(), and BadInput for a study whose load or moment is given.
void compare(const StudyOptions &options);

} // namespace stemware::pipeline
