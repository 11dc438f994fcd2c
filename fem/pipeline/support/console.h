#pragma once

#include <chrono>
#include <cstddef>
#include <iosfwd>
#include <string>

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

/// "about 3 min", for what is left of a long work.
std::string rough_duration(double seconds);

/// Shows on the console how far a work of many cases has come: a bar with the time left where somebody
/// watches, else a line for every tenth, at most every three seconds.
class WorkProgress
{
public:
  /// @p n_before of the @p n_cases were finished by an earlier run. @p noun is what the cases are called.
  explicit WorkProgress(std::size_t n_cases, std::size_t n_before = 0, std::string noun = "cases");
  ~WorkProgress();

  /// Shows how much is done; to be called as often as one likes.
  void show(std::size_t n_finished, std::size_t n_failed = 0);

private:
  const std::size_t n_cases;
  const std::size_t n_before;
  const std::string noun;
  const std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point last_line = start;
  std::size_t tenths_shown;
  std::size_t bar_width = 0; ///< columns of the line that may have to be overwritten
};

} // namespace stemware::pipeline
