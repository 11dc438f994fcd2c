#pragma once

#include <iosfwd>

namespace stemware::pipeline
{

/// Opens those of standard input, output and error that the program was started without, to nothing:
/// otherwise the next file that is opened would take their place. To be called first.
void open_missing_streams();

/// Where the text for users goes from now on: to standard output; with @p json, which keeps standard output
/// for programs, to standard error; with @p quiet nowhere. Throws OutputFailure for @p json where the program
/// was started without a standard output.
void direct_console(bool quiet, bool json);

/// The stream of that text, on the first rank; silent on the others. Plain text: no colours, no escape codes.
/// For the thread that started the program only.
std::ostream &console();

/// To be called at the end: throws OutputFailure where standard output has not taken all that was printed on
/// it, because the disk is full.
void require_printed();

/// Whether somebody watches the console, so that a line may be overwritten with "\r" to show progress. False
/// for files, pipes, terminals that cannot do it (TERM=dumb), and where nothing is printed.
bool console_is_terminal();

} // namespace stemware::pipeline
