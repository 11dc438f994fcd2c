#pragma once

#include "fem/pipeline/base/failures.h"

namespace stemware::pipeline
{

/// Returns one sentence about the exception being handled. Call from a catch block.
std::string failure_sentence();

/// Prints the exception being handled to stderr as one line "stemware: ..." on the first rank; returns the
/// exit code. Call from a catch block.
ExitCode report_failure();

} // namespace stemware::pipeline
