#include "fem/pipeline/base/console.h"

#include "fem/pipeline/base/failures.h"
#include "fem/pipeline/base/ranks.h"

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

int console_descriptor = STDOUT_FILENO; ///< descriptor for messages to the user; negative: none
bool stdout_was_missing = false;        ///< true if stdout was closed at program start

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
      ::open("/dev/null", O_RDWR); // open() assigns the lowest free number: the missing descriptor
      stdout_was_missing = stdout_was_missing || descriptor == STDOUT_FILENO;
    }
}

bool console_is_terminal()
{
  const char *kind = std::getenv("TERM");
  return console_buffer() != nullptr && ::isatty(console_descriptor) == 1 && kind != nullptr &&
         std::string(kind) != "dumb";
}

void direct_console(bool quiet, bool json)
{
  if (json && stdout_was_missing)
    throw OutputFailure(
      "--json needs standard output, which is closed; redirect it to a file, or omit --json.");
  console_descriptor = quiet ? -1 : json ? STDERR_FILENO : STDOUT_FILENO;
}

std::ostream &console()
{
  // The rank is known only after the start of MPI, so it is checked at every call.
  static std::ostream stream(nullptr);
  if (stream.rdbuf() != console_buffer())
    stream.rdbuf(console_buffer());
  return stream;
}

void require_printed()
{
  std::cout << std::flush;
  // std::cout writes through the C stream stdout, so ferror(stdout) reports every earlier failure.
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
    throw OutputFailure(
      "Standard output is incomplete (disk full?); results written to a folder are complete.");
}

} // namespace stemware::pipeline
