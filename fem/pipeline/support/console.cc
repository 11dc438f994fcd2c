#include "fem/pipeline/support/console.h"

#include "fem/pipeline/support/ranks.h"

#include <cstdlib>
#include <fcntl.h>
#include <iostream>
#include <string>
#include <unistd.h>

namespace stemware::pipeline
{

namespace
{

/// The file descriptor of the text for users, or a negative number for nowhere.
int &console_descriptor()
{
  static int descriptor = STDOUT_FILENO;
  return descriptor;
}

std::streambuf *console_buffer()
{
  if (!is_first_rank() || console_descriptor() < 0)
    return nullptr;
  return console_descriptor() == STDOUT_FILENO ? std::cout.rdbuf() : std::cerr.rdbuf();
}

} // namespace

void open_missing_streams()
{
  for (const int descriptor : { STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO })
    if (::fcntl(descriptor, F_GETFD) < 0)
      ::open("/dev/null", O_RDWR); // takes the lowest number that is free, which is this one
}

void direct_console(bool quiet, bool json)
{
  console_descriptor() = quiet ? -1 : json ? STDERR_FILENO : STDOUT_FILENO;
}

std::ostream &console()
{
  // Asked each time: whether this is the first rank is known only once MPI runs.
  static std::ostream stream(nullptr);
  if (stream.rdbuf() != console_buffer())
    stream.rdbuf(console_buffer());
  return stream;
}

bool console_is_terminal()
{
  const char *kind = std::getenv("TERM");
  return console_buffer() != nullptr && ::isatty(console_descriptor()) == 1 && kind != nullptr &&
         std::string(kind) != "dumb";
}

} // namespace stemware::pipeline
