#pragma once

#include "fem/pipeline/base/json.h"

#include <chrono>
#include <string>

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
    seconds[stage] = std::chrono::duration<double>(now - last).count();
    last = now;
  }

  /// Returns the seconds since the start.
  double elapsed() const
  {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }

  /// Returns the seconds per stage, in order, and "total".
  nlohmann::ordered_json times() const
  {
    nlohmann::ordered_json all = seconds;
    all["total"] = std::chrono::duration<double>(last - start).count();
    return all;
  }

private:
  using TimePoint = std::chrono::steady_clock::time_point;
  const TimePoint start = std::chrono::steady_clock::now();
  TimePoint last = start;
  nlohmann::ordered_json seconds = nlohmann::ordered_json::object();
};

} // namespace stemware::pipeline
