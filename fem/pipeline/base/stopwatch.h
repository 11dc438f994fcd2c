#pragma once

#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace stemware::pipeline
{

/// Wall-clock time of the stages of a run, kept apart from other results because it differs between equal
/// runs.
class Stopwatch
{
public:
  /// Ends the present stage, which began at the end of the last one, under the name @p stage.
  void finish(const std::string &stage)
  {
    const auto now = std::chrono::steady_clock::now();
    seconds.emplace_back(stage, std::chrono::duration<double>(now - last).count());
    last = now;
  }

  /// Returns the seconds per stage, in order, and "total".
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
