#pragma once

#include <iosfwd>

namespace stemware::pipeline
{

/// Opens missing standard streams as /dev/null, so that no opened file becomes one of them. Call first.
void open_missing_streams();

/// Sends the console's text to standard output; with @p json to standard error, with @p quiet nowhere. Throws
/// OutputFailure if @p json is set and standard output is closed.
void direct_console(bool quiet, bool json);

/// Returns the stream of the console's text; silent except on the first rank. For the main thread only.
std::ostream &console();

/// Throws OutputFailure if standard output was not written completely. Call at the end of the program.
void require_printed();

/// Returns true if "\r" overwrites a line of the console: on terminals, except simple ones (TERM=dumb).
bool console_is_terminal();

} // namespace stemware::pipeline
