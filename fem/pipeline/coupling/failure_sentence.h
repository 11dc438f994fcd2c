#pragma once

#include "fem/pipeline/base/failures.h"

namespace stemware::pipeline
{

/// Returns one sentence about the present exception. Call from a catch block.
std::string failure_sentence();

/// Prints the present exception to stderr as one line "stemware: ..." on the first rank; returns the exit
/// code. Call from a catch block.
ExitCode report_failure();

} // namespace stemware::pipeline
