#include "fem/pipeline/support/work_progress.h"

#include "fem/pipeline/support/console.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <ostream>
#include <utility>

namespace stemware::pipeline
{

std::string rough_duration(double seconds)
{
  if (seconds < 90)
    return fmt::format(FMT_STRING("{:.0f} s"), std::ceil(seconds));
  if (seconds < 90 * 60)
    return fmt::format(FMT_STRING("{:.0f} min"), std::ceil(seconds / 60));
  return fmt::format(FMT_STRING("{:.1f} h"), seconds / 3600);
}

WorkProgress::WorkProgress(std::size_t n_cases, std::size_t n_before, std::string noun)
    : n_cases(n_cases)
    , n_before(n_before)
    , noun(std::move(noun))
    , tenths_shown(10 * n_before / std::max<std::size_t>(n_cases, 1))
{
}

WorkProgress::~WorkProgress()
{
  if (bar_width > 0)
    console() << std::endl;
}

void WorkProgress::show(std::size_t n_finished, std::size_t n_failed)
{
  if (console_is_terminal())
    show_bar(n_finished, n_failed);
  else
    show_line(n_finished, n_failed);
}

std::string WorkProgress::text(std::size_t n_finished, std::size_t n_failed) const
{
  std::string text = fmt::format(FMT_STRING("{} of {} {}"), n_finished, n_cases, noun);
  if (n_failed > 0)
    text += fmt::format(FMT_STRING(", {} failed"), n_failed);
  const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (n_finished > n_before && n_finished < n_cases)
    text += ", " +
            rough_duration(elapsed * static_cast<double>(n_cases - n_finished) /
                           static_cast<double>(n_finished - n_before)) +
            " left";
  return text;
}

void WorkProgress::show_bar(std::size_t n_finished, std::size_t n_failed)
{
  constexpr std::size_t n_marks = 40;
  const std::size_t n_done = n_marks * n_finished / std::max<std::size_t>(n_cases, 1);
  std::string line =
    "[" + std::string(n_done, '#') + std::string(n_marks - n_done, '.') + "] " + text(n_finished, n_failed);
  const std::size_t width = line.size();
  line.resize(std::max(width, bar_width), ' ');
  bar_width = width;
  console() << '\r' << line << std::flush;
}

void WorkProgress::show_line(std::size_t n_finished, std::size_t n_failed)
{
  const std::size_t tenths = 10 * n_finished / std::max<std::size_t>(n_cases, 1);
  const auto now = std::chrono::steady_clock::now();
  if (tenths == tenths_shown || now - last_line < std::chrono::seconds(3))
    return;
  tenths_shown = tenths;
  last_line = now;
  console() << "          " << text(n_finished, n_failed) << std::endl;
}

} // namespace stemware::pipeline
