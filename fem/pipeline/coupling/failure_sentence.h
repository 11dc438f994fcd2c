#pragma once

#include "fem/pipeline/base/failures.h"

namespace stemware::pipeline
{

/// Returns one sentence about the exception that is being handled. Call from a catch block.
std::string failure_sentence();

/// Prints the message of the exception that is being handled to stderr as one line "stemware: ..." (first
/// rank only) and returns the exit code. Call from a catch block.
ExitCode report_failure();

} // namespace stemware::pipeline
