#pragma once

#include <functional>
#include <mutex>
#include <set>
#include <string>
#include <sys/types.h>

namespace stemware::pipeline
{

/// Keeps SIGINT, SIGTERM and SIGHUP waiting until watch_for_interruption(), for this thread and those that it
/// begins; those of them that were ignored when the program started stay ignored. To be called before any
/// thread is begun.
void hold_interruptions_back();

/// Lets SIGINT, SIGTERM and SIGHUP end the program from now on, with exit code 130, at once and whatever it
/// is doing, as the InterruptionPlan says. A thread waits for them and does the work: so the clean-up is
/// ordinary code, and a factorisation that never looks at a flag does not delay it. To be called before the
/// work, and again after start_mpi(), which says which rank this is.
void watch_for_interruption();

/// Plan for the end of an interrupted program.
struct InterruptionPlan
{
  std::set<pid_t> children;              ///< killed first; to be erased once they have been waited for
  std::function<void()> clean_up;        ///< comes next; must not wait for the thread that works
  std::function<std::string()> sentence; ///< said instead of "interrupted; no results were written"
  /// How far the work is, for that sentence: "interrupted after 35 s; contact, 3 of 20 error bands done; no
  /// results were written."
  std::string work_done;
};

/// Holds an interruption back while it lives, for steps that must happen together, such as swapping folders,
/// and gives access to the plan.
class PostponedInterruption
{
public:
  PostponedInterruption();
  InterruptionPlan *operator->() const;

private:
  std::unique_lock<std::mutex> lock;
};

} // namespace stemware::pipeline
