#include "fem/pipeline/support/interruption.h"

#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/ranks.h"
#include "fem/pipeline/support/work_progress.h"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <set>
#include <system_error>
#include <thread>
#include <unistd.h>

namespace stemware::pipeline
{

namespace
{

/// What the watching thread shares with the others. Never destroyed: the thread may outlive main().
struct Watch
{
  std::mutex mutex;
  std::function<void()> clean_up;
  std::function<std::string()> sentence;
  std::string work_done;
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
  std::set<pid_t> children;
  bool first_rank = true; ///< asked in advance: MPI may be busy, or over, when the signal comes
};

Watch &watch()
{
  static auto *const the_watch = new Watch;
  return *the_watch;
}

int wake_up_pipe[2] = { -1, -1 };

/// The signals that end the program.
struct WatchedSignal
{
  int number;
  /// Whether it was ignored when the program started (nohup, jobs in the background): it stays so.
  bool is_ignored = false;
};
WatchedSignal watched_signals[] = { { SIGINT }, { SIGTERM }, { SIGHUP } };

/// Ends a program that has not reached main() yet; it has nothing to tidy up.
extern "C" void end_at_once(int)
{
  const char message[] = "\nstemware: interrupted; no results were written.\n";
  [[maybe_unused]] const auto n_written = ::write(STDERR_FILENO, message, sizeof(message) - 1);
  ::_exit(static_cast<int>(ExitCode::interrupted));
}

void watch_while_libraries_start(int, char **, char **)
{
  for (WatchedSignal &signal : watched_signals)
  {
    struct sigaction action = {};
    ::sigaction(signal.number, nullptr, &action);
    signal.is_ignored = action.sa_handler == SIG_IGN;
    if (action.sa_handler != SIG_DFL)
      continue;
    action.sa_handler = end_at_once;
    ::sigaction(signal.number, &action, nullptr);
  }
}

/// Called by the loader before the libraries are initialised: these take as long as a study that is refused,
/// and some of them take signals.
__attribute__((section(".preinit_array"),
               used)) void (*const first_call)(int, char **, char **) = watch_while_libraries_start;

extern "C" void wake_up(int)
{
  const int saved_errno = errno;
  const char byte = 1;
  // A full pipe means that the thread is awake already.
  [[maybe_unused]] const auto n_written = ::write(wake_up_pipe[1], &byte, 1);
  errno = saved_errno;
}

std::string how_far()
{
  if (watch().work_done.empty())
    return "";
  const auto seconds = std::chrono::steady_clock::now() - watch().start;
  return " after " + rough_duration(std::chrono::duration<double>(seconds).count()) + "; " +
         watch().work_done + " done";
}

[[noreturn]] void end_program()
{
  // Kept until the end, so that the working thread cannot publish results, or report that its folder is gone,
  // meanwhile.
  watch().mutex.lock();
  for (const pid_t child : watch().children)
    ::kill(child, SIGKILL);
  if (watch().clean_up)
    watch().clean_up();
  // mpirun kills the remaining ranks as soon as one has ended: the first rank, which owns the folder, gets
  // time to tidy up.
  if (!watch().first_rank)
    std::this_thread::sleep_for(std::chrono::seconds(1));
  const std::string usual = "interrupted" + how_far() + "; no results were written.";
  const std::string message = "\nstemware: " + (watch().sentence ? watch().sentence() : usual) + "\n";
  if (watch().first_rank) [[maybe_unused]]
    const auto n_written = ::write(STDERR_FILENO, message.data(), message.size());
  ::_exit(static_cast<int>(ExitCode::interrupted));
}

void wait_for_signal()
{
  char byte;
  while (::read(wake_up_pipe[0], &byte, 1) < 0 && errno == EINTR)
    ;
  end_program();
}

} // namespace

void watch_for_interruption()
{
  watch().first_rank = is_first_rank();
  if (wake_up_pipe[0] < 0)
  {
    if (::pipe(wake_up_pipe) != 0)
      throw std::system_error(errno, std::generic_category(), "the watch for interruptions cannot start");
    std::thread(wait_for_signal).detach();
  }
  for (const WatchedSignal &signal : watched_signals)
  {
    struct sigaction action = {};
    action.sa_handler = signal.is_ignored ? SIG_IGN : wake_up;
    action.sa_flags = SA_RESTART;
    ::sigaction(signal.number, &action, nullptr);
  }
  // A file that grows beyond what the user may write is a file that cannot be written, and said so.
  std::signal(SIGXFSZ, SIG_IGN);
}

std::unique_lock<std::mutex> postpone_interruption()
{
  return std::unique_lock<std::mutex>(watch().mutex);
}

void clean_up_on_interruption(std::function<void()> clean_up)
{
  watch().clean_up = std::move(clean_up);
}

void say_on_interruption(std::function<std::string()> sentence)
{
  watch().sentence = std::move(sentence);
}

void note_work_done(const std::string &work)
{
  const auto lock = postpone_interruption();
  watch().work_done = work;
}

void kill_on_interruption(pid_t child)
{
  watch().children.insert(child);
}

void spare_on_interruption(pid_t child)
{
  watch().children.erase(child);
}

} // namespace stemware::pipeline
