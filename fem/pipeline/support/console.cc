#include "fem/pipeline/support/console.h"

#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/ranks.h"

#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <iostream>
#include <string>
#include <unistd.h>

namespace stemware::pipeline
{

namespace
{

int console_descriptor = STDOUT_FILENO; ///< of the text for users; negative: nowhere
bool stdout_was_missing = false;        ///< when the program was started

std::streambuf *console_buffer()
{
  if (!is_first_rank() || console_descriptor < 0)
    return nullptr;
  return console_descriptor == STDOUT_FILENO ? std::cout.rdbuf() : std::cerr.rdbuf();
}

} // namespace

void open_missing_streams()
{
  for (const int descriptor : { STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO })
    if (::fcntl(descriptor, F_GETFD) < 0)
    {
      ::open("/dev/null", O_RDWR); // takes the lowest number that is free, which is this one
      stdout_was_missing = stdout_was_missing || descriptor == STDOUT_FILENO;
    }
}

void direct_console(bool quiet, bool json)
{
  if (json && stdout_was_missing)
    throw OutputFailure(
      "--json prints on standard output, which is closed; redirect it to a file, or leave --json away.");
  console_descriptor = quiet ? -1 : json ? STDERR_FILENO : STDOUT_FILENO;
}

std::ostream &console()
{
  // Asked each time: whether this is the first rank is known only once MPI runs.
  static std::ostream stream(nullptr);
  if (stream.rdbuf() != console_buffer())
    stream.rdbuf(console_buffer());
  return stream;
}

void require_printed()
{
  std::cout << std::flush;
  // Of the stream of C, which both streams to it write on: it remembers every failure.
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
    throw OutputFailure("Standard output has not taken all that was printed (is the disk full?); results "
                        "that were written to a folder are whole.");
}

bool console_is_terminal()
{
  const char *kind = std::getenv("TERM");
  return console_buffer() != nullptr && ::isatty(console_descriptor) == 1 && kind != nullptr &&
         std::string(kind) != "dumb";
}

} // namespace stemware::pipeline
