#pragma once

#include "fem/pipeline/support/failures.h"

namespace stemware::pipeline
{

/// One sentence on what is wrong, for the exception that is being handled. To be called from a catch block.
std::string failure_sentence();

/// The exit code for the exception that is being handled, after its message has been printed on stderr as one
/// line "stemware: ...". On ranks other than the first nothing is printed. To be called from a catch block.
ExitCode report_failure();

} // namespace stemware::pipeline
