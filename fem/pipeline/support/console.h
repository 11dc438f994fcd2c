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

/// Directs the text for users to standard output, with @p json to standard error, with @p quiet nowhere.
/// Throws OutputFailure if @p json is set and the program has no standard output.
void direct_console(bool quiet, bool json);

/// The stream of that text, on the first rank; silent on the others. Plain text: no colours, no escape codes.
/// For the thread that started the program only.
std::ostream &console();

/// Throws OutputFailure if standard output was not written completely, for example because the disk is full.
/// Call it at the end of the program.
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
