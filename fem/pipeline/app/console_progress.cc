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
  if (n_all > 0)
  {
    show(what, n_done, n_all);
    if (n_done == n_all)
      end_bar();
    return;
  }
  const auto now = std::chrono::steady_clock::now();
  if (is_counting || now - last_line < std::chrono::seconds(3))
    return; // at most one line every 3 s, and none if a bar shows the progress
  last_line = now;
  console() << fmt::format(FMT_STRING("  {} {}"), n_done, what) << std::endl;
}

void ConsoleProgress::show(const std::string &what, std::size_t n_done, std::size_t n_all)
{
  const auto now = std::chrono::steady_clock::now();
  if (!is_counting)
  {
    last_line = now;
    tenths_shown = 0;
  }
  is_counting = true;
  const std::size_t tenths = 10 * n_done / n_all;
  const bool is_watched = console_is_terminal();
  if (!is_watched && (tenths == tenths_shown || now - last_line < std::chrono::seconds(3)))
    return;
  tenths_shown = tenths;
  last_line = now;
  const std::string text = fmt::format(FMT_STRING("{} of {} {}"), n_done, n_all, what);
  if (!is_watched)
  {
    console() << "          " << text << std::endl;
    return;
  }
  constexpr std::size_t n_marks = 40;
  const std::size_t n_filled = n_marks * n_done / n_all;
  std::string line = "[" + std::string(n_filled, '#') + std::string(n_marks - n_filled, '.') + "] " + text;
  const std::size_t width = line.size();
  line.resize(std::max(width, bar_width), ' ');
  bar_width = width;
  console() << '\r' << line << std::flush;
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
