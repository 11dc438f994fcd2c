#include "fem/pipeline/base/console.h"

#include "fem/pipeline/base/failures.h"
#include "fem/pipeline/base/ranks.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <fmt/format.h>
#include <iostream>
#include <string>
#include <unistd.h>
#include <utility>

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

/// Returns true if "\r" overwrites a progress line: on terminals, except simple ones (TERM=dumb).
bool console_is_terminal()
{
  const char *kind = std::getenv("TERM");
  return console_buffer() != nullptr && ::isatty(console_descriptor) == 1 && kind != nullptr &&
         std::string(kind) != "dumb";
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

WorkProgress::WorkProgress(std::size_t n_cases, std::string noun)
    : n_cases(n_cases)
    , noun(std::move(noun))
{
}

WorkProgress::~WorkProgress()
{
  if (bar_width > 0)
    console() << std::endl;
}

void WorkProgress::show(std::size_t n_finished, std::size_t n_failed)
{
  const std::size_t n_all = std::max<std::size_t>(n_cases, 1), tenths = 10 * n_finished / n_all;
  const auto now = std::chrono::steady_clock::now();
  const bool is_watched = console_is_terminal();
  if (!is_watched && (tenths == tenths_shown || now - last_line < std::chrono::seconds(3)))
    return;
  tenths_shown = tenths;
  last_line = now;
  std::string text = fmt::format(FMT_STRING("{} of {} {}"), n_finished, n_cases, noun);
  if (n_failed > 0)
    text += fmt::format(FMT_STRING(", {} failed"), n_failed);
  if (!is_watched)
  {
    console() << "          " << text << std::endl;
    return;
  }
  constexpr std::size_t n_marks = 40;
  const std::size_t n_done = n_marks * n_finished / n_all;
  std::string line = "[" + std::string(n_done, '#') + std::string(n_marks - n_done, '.') + "] " + text;
  const std::size_t width = line.size();
  line.resize(std::max(width, bar_width), ' ');
  bar_width = width;
  console() << '\r' << line << std::flush;
}

} // namespace stemware::pipeline
