#include "fem/pipeline/app/console_progress.h"

#include "fem/contact/contact_newton.h"
#include "fem/pipeline/base/console.h"

#include <algorithm>
#include <fmt/format.h>
#include <ostream>

namespace stemware::pipeline
{

void ConsoleProgress::stage_done(const std::string &stage)
{
  stopwatch.finish(stage);
}

void ConsoleProgress::pieces_done(const std::string &what, std::size_t n_done, std::size_t n_all)
{
  const auto now = std::chrono::steady_clock::now();
  if (n_all > 0 && !is_counting)
  {
    last_line = now;
    tenths_shown = 0;
    is_counting = true;
  }
  const bool is_late = now - last_line >= std::chrono::seconds(3); // after a line; a bar is shown at once
  if (n_all == 0)
  {
    if (is_counting || !is_late)
      return;
    last_line = now;
    console() << fmt::format(FMT_STRING("  {} {}"), n_done, what) << std::endl;
    return;
  }
  const std::size_t tenths = 10 * n_done / n_all;
  const std::string text = fmt::format(FMT_STRING("{} of {} {}"), n_done, n_all, what);
  if (console_is_terminal())
  {
    constexpr std::size_t n_marks = 40;
    const std::size_t n_filled = n_marks * n_done / n_all;
    std::string line = "[" + std::string(n_filled, '#') + std::string(n_marks - n_filled, '.') + "] " + text;
    const std::size_t width = line.size();
    line.resize(std::max(width, bar_width), ' ');
    bar_width = width;
    last_line = now;
    console() << '\r' << line << std::flush;
  }
  else if (tenths != tenths_shown && is_late)
  {
    tenths_shown = tenths;
    last_line = now;
    console() << "          " << text << std::endl;
  }
  if (n_done == n_all)
    end_bar();
}

void ConsoleProgress::end_bar()
{
  if (bar_width > 0)
    console() << std::endl;
  is_counting = false;
  bar_width = 0;
}

void ConsoleProgress::iteration(const fem::ContactIteration &step)
{
  if (!has_header)
    console() << "  step   active  changed    residual   step length   CG iterations\n";
  has_header = true;
  console() << fmt::format(FMT_STRING("  {:4} {:8} {:8}   {:9.2e}   {:11.3g}   {:13}"), step.number,
                           step.n_loaded, step.n_changed, step.residual, step.step_length,
                           step.linear_iterations)
            << std::endl;
}

void ConsoleProgress::note(const std::string &subject, const std::string &text)
{
  console() << fmt::format(FMT_STRING("{:<9} {}"), subject, text) << std::endl;
}

} // namespace stemware::pipeline
