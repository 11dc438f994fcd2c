#pragma once

#include "fem/pipeline/base/progress.h"
#include "fem/pipeline/base/stopwatch.h"

#include <chrono>
#include <cstddef>
#include <string>

namespace stemware::pipeline
{

/// Progress on the console: Newton steps as a table, known work as a bar on a terminal, else as a line per
/// tenth, at most every 3 s, and balances every few seconds.
class ConsoleProgress : public Progress
{
public:
  ConsoleProgress() = default;
  ~ConsoleProgress() override { end_bar(); }
  ConsoleProgress(const ConsoleProgress &) = delete;
  ConsoleProgress &operator=(const ConsoleProgress &) = delete;

  void stage_done(const std::string &stage) override;
  void pieces_done(const std::string &what, std::size_t n_done, std::size_t n_all) override;
  void iteration(const fem::ContactIteration &step) override;
  void note(const std::string &subject, const std::string &text) override;

  Stopwatch stopwatch; ///< times of the stages

private:
  void end_bar();

  bool is_counting = false; ///< true until all pieces of a known number are done
  std::size_t tenths_shown = 0;
  std::size_t bar_width = 0; ///< columns of the present bar, to be overwritten
  bool has_header = false;   ///< table of Newton steps has its header
  std::chrono::steady_clock::time_point last_line = std::chrono::steady_clock::now();
};

} // namespace stemware::pipeline
