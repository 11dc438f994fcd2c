#pragma once

#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace stemware::pipeline
{

/// Wall-clock times of the stages of a run, separate from its results, which are equal for equal runs.
class Stopwatch
{
public:
  /// Ends the present stage, which began when the previous one ended, and names it @p stage.
  void finish(const std::string &stage)
  {
    const auto now = std::chrono::steady_clock::now();
    seconds.emplace_back(stage, std::chrono::duration<double>(now - last).count());
    last = now;
  }

  /// Returns the durations of the stages, in order, and "total" [s].
  std::vector<std::pair<std::string, double>> times() const
  {
    std::vector<std::pair<std::string, double>> all = seconds;
    all.emplace_back("total", std::chrono::duration<double>(last - start).count());
    return all;
  }

private:
  using TimePoint = std::chrono::steady_clock::time_point;
  const TimePoint start = std::chrono::steady_clock::now();
  TimePoint last = start;
  std::vector<std::pair<std::string, double>> seconds;
};

} // namespace stemware::pipeline
