#include "fem/pipeline/support/console.h"

#include "fem/pipeline/support/ranks.h"

#include <cstdlib>
#include <iostream>
#include <string>
#include <unistd.h>

namespace stemware::pipeline
{

namespace
{

/// The file descriptor of the text for people, or a negative number for nowhere.
int &people()
{
  static int descriptor = STDOUT_FILENO;
  return descriptor;
}

std::streambuf *buffer_for_people()
{
  if (!is_first_rank() || people() < 0)
    return nullptr;
  return people() == STDOUT_FILENO ? std::cout.rdbuf() : std::cerr.rdbuf();
}

} // namespace

void direct_console(bool quiet, bool json)
{
  people() = quiet ? -1 : json ? STDERR_FILENO : STDOUT_FILENO;
}

std::ostream &console()
{
  // Asked each time: whether this is the first rank is known only once MPI runs.
  static std::ostream stream(nullptr);
  if (stream.rdbuf() != buffer_for_people())
    stream.rdbuf(buffer_for_people());
  return stream;
}

bool console_is_terminal()
{
  const char *kind = std::getenv("TERM");
  return buffer_for_people() != nullptr && ::isatty(people()) == 1 && kind != nullptr &&
         std::string(kind) != "dumb";
}

} // namespace stemware::pipeline
