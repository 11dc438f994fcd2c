#pragma once

#include "fem/pipeline/analysis/solve.h"
#include "fem/pipeline/base/console.h"
#include "fem/pipeline/base/progress.h"
#include "fem/pipeline/base/stopwatch.h"

#include <chrono>
#include <optional>

namespace stemware::pipeline
{

/// Progress on the console: Newton steps as a table, known work as a bar, balances every few seconds.
class ConsoleProgress : public Progress
{
public:
  /// Keeps a reference to @p stopwatch, which receives the stages.
  explicit ConsoleProgress(Stopwatch &stopwatch);

  void stage_done(const std::string &stage) override;
  void pieces_done(const std::string &what, std::size_t n_done, std::size_t n_all) override;
  void iteration(const fem::ContactIteration &step) override;
  void note(const std::string &subject, const std::string &text) override;

private:
  Stopwatch &stopwatch;
  std::optional<WorkProgress> bar;
  bool has_header = false; ///< table of Newton steps has its header
  std::chrono::steady_clock::time_point last_line = std::chrono::steady_clock::now();
};

} // namespace stemware::pipeline
