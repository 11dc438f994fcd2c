#include "fem/pipeline/app/console_progress.h"

#include "fem/contact/contact_newton.h"

#include <fmt/format.h>
#include <ostream>

namespace stemware::pipeline
{

ConsoleProgress::ConsoleProgress(Stopwatch &stopwatch)
    : stopwatch(stopwatch)
{
}

void ConsoleProgress::stage_done(const std::string &stage)
{
  stopwatch.finish(stage);
}

void ConsoleProgress::pieces_done(const std::string &what, std::size_t n_done, std::size_t n_all)
{
  if (n_all > 0)
  {
    if (!bar)
      bar.emplace(n_all, what);
    bar->show(n_done);
    if (n_done == n_all)
      bar.reset();
    return;
  }
  const auto now = std::chrono::steady_clock::now();
  if (bar || now - last_line < std::chrono::seconds(3))
    return; // at most one line every 3 s, and none if a bar shows the progress
  last_line = now;
  console() << fmt::format(FMT_STRING("  {} {}"), n_done, what) << std::endl;
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
