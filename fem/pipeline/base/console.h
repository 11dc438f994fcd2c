#pragma once

#include <chrono>
#include <cstddef>
#include <iosfwd>
#include <string>

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

/// Progress of many cases on the console: a bar on a terminal, else a line per tenth, at most every 3 s.
class WorkProgress
{
public:
  /// @p noun: name of the cases.
  explicit WorkProgress(std::size_t n_cases, std::string noun = "cases");
  ~WorkProgress();

  /// Shows the progress; may be called often.
  void show(std::size_t n_finished, std::size_t n_failed = 0);

private:
  const std::size_t n_cases;
  const std::string noun;
  std::chrono::steady_clock::time_point last_line = std::chrono::steady_clock::now();
  std::size_t tenths_shown = 0;
  std::size_t bar_width = 0; ///< columns of the present bar, to be overwritten
};

} // namespace stemware::pipeline
