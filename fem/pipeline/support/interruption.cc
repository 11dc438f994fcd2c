#include "fem/pipeline/support/interruption.h"

#include "fem/pipeline/support/console.h"
#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/ranks.h"

#include <chrono>
#include <csignal>
#include <thread>
#include <unistd.h>

namespace stemware::pipeline
{

namespace
{

/// State that the watching thread shares with the others. Never destroyed: the thread may outlive main().
struct Watch
{
  std::mutex mutex;
  InterruptionPlan plan;
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
  bool first_rank = true; ///< asked in advance: MPI may be busy, or over, when the signal comes
};

Watch &watch()
{
  static auto *const the_watch = new Watch;
  return *the_watch;
}

/// The signals that interrupt: those of SIGINT, SIGTERM and SIGHUP that were not ignored when the program
/// started (nohup, jobs in the background).
sigset_t interruptions;

std::string usual_sentence()
{
  const std::string &work = watch().plan.work_done;
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - watch().start;
  const std::string how_far = " after " + rough_duration(seconds.count()) + "; " + work + " done";
  return "interrupted" + (work.empty() ? "" : how_far) + "; no results were written.";
}

[[noreturn]] void end_on_interruption()
{
  int signal = 0;
  ::sigwait(&interruptions, &signal);
  // Kept until the end, so that the working thread cannot publish results, or report that its folder is gone,
  // meanwhile.
  watch().mutex.lock();
  const InterruptionPlan &plan = watch().plan;
  for (const pid_t child : plan.children)
    ::kill(child, SIGKILL);
  if (plan.clean_up)
    plan.clean_up();
  // mpirun kills the remaining ranks as soon as one has ended: the first rank, which owns the folder, gets
  // time to tidy up.
  if (!watch().first_rank)
    std::this_thread::sleep_for(std::chrono::seconds(1));
  const std::string message = "\nstemware: " + (plan.sentence ? plan.sentence() : usual_sentence()) + "\n";
  if (watch().first_rank) [[maybe_unused]]
    const auto n_written = ::write(STDERR_FILENO, message.data(), message.size());
  ::_exit(static_cast<int>(ExitCode::interrupted));
}

} // namespace

void hold_interruptions_back()
{
  sigset_t all;
  ::sigemptyset(&all);
  ::sigemptyset(&interruptions);
  for (const int signal : { SIGINT, SIGTERM, SIGHUP })
  {
    struct sigaction action = {};
    ::sigaction(signal, nullptr, &action);
    ::sigaddset(&all, signal);
    if (action.sa_handler != SIG_IGN)
      ::sigaddset(&interruptions, signal);
  }
  // Those that are ignored too: MPI puts handlers of its own in place.
  ::sigprocmask(SIG_BLOCK, &all, nullptr);
}

void watch_for_interruption()
{
  watch().first_rank = is_first_rank();
  static std::once_flag once;
  std::call_once(once, [] { std::thread(end_on_interruption).detach(); });
  // A file that grows beyond what the user may write is a file that cannot be written, and said so.
  std::signal(SIGXFSZ, SIG_IGN);
}

PostponedInterruption::PostponedInterruption()
    : lock(watch().mutex)
{
}

InterruptionPlan *PostponedInterruption::operator->() const
{
  return &watch().plan;
}

} // namespace stemware::pipeline
