#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace stemware::pipeline
{

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
  std::string text(std::size_t n_finished, std::size_t n_failed) const;
  void show_bar(std::size_t n_finished, std::size_t n_failed);
  void show_line(std::size_t n_finished, std::size_t n_failed);

  const std::size_t n_cases;
  const std::size_t n_before;
  const std::string noun;
  const std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point last_line = start;
  std::size_t tenths_shown;
  std::size_t bar_width = 0; ///< columns of the line that may have to be overwritten
};

} // namespace stemware::pipeline
