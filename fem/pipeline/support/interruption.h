#pragma once

#include <functional>
#include <mutex>
#include <string>
#include <sys/types.h>

namespace stemware::pipeline
{

/// Keeps SIGINT, SIGTERM and SIGHUP waiting until watch_for_interruption(), for this thread and those that it
/// begins; those of them that were ignored when the program started stay ignored. To be called before any
/// thread is begun.
void hold_interruptions_back();

/// Lets SIGINT, SIGTERM and SIGHUP end the program from now on, with exit code 130, at once and whatever it
/// is doing, after the clean-up of clean_up_on_interruption(). A thread waits for them and does the work: so
/// the clean-up is ordinary code, and a factorisation that never looks at a flag does not delay it. To be
/// called before the work, and again after start_mpi(), which says which rank this is.
void watch_for_interruption();

/// Holds an interruption back while the lock lives: for steps that must happen together, such as swapping
/// folders.
std::unique_lock<std::mutex> postpone_interruption();

/// Sets the clean-up before the program ends; replaces the earlier one. The clean-up must not wait for the
/// thread that works. The caller holds the lock of postpone_interruption().
void clean_up_on_interruption(std::function<void()> clean_up);

/// Sets the sentence of the interrupted program, said instead of "interrupted; no results were written". The
/// thread that does the clean-up asks for it. The caller holds the lock of postpone_interruption().
void say_on_interruption(std::function<std::string()> sentence);

/// How far the work is, for that sentence: "interrupted after 35 s; contact, 3 of 20 error bands done; no
/// results were written." Takes the lock.
void note_work_done(const std::string &work);

/// A child process that is killed on interruption, before the clean-up, until it is spared. The caller holds
/// the lock.
void kill_on_interruption(pid_t child);

/// Undoes kill_on_interruption(): @p child has been waited for. The caller holds the lock.
void spare_on_interruption(pid_t child);

} // namespace stemware::pipeline
