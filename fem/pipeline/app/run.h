#pragma once

#include "fem/pipeline/app/options.h"

namespace stemware::pipeline
{

/// Runs a study from its file to the folder of its results. Collective over all ranks.
/// Throws BadInput, OutputFailure, ContactFailure or, for what nobody foresaw, any other exception.
void run(const StudyOptions &options);

} // namespace stemware::pipeline
