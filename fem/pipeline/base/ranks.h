#pragma once

#include <functional>
#include <string>

namespace stemware::pipeline
{

/// Scope in which MPI may be used; one per program, in main(). The destructor ends MPI.
class MpiSession
{
public:
  /// Starts MPI if mpirun has started several processes. Throws as start_mpi().
  MpiSession();
  ~MpiSession();
  MpiSession(const MpiSession &) = delete;
  MpiSession &operator=(const MpiSession &) = delete;
};

/// Starts MPI, which solid feet need, unless it is running; takes 0.3 s. Throws BadInput if mpirun has
/// started several processes of a program without MPI.
void start_mpi();

/// Returns true if this process prints and writes tables; true without MPI.
bool is_first_rank();

/// Returns the number of processes.
unsigned int n_ranks();

/// Runs @p work on every rank and waits for all. If @p work throws on some ranks, every rank throws with the
/// message of the first of them: OutputFailure for file errors, else std::runtime_error.
void on_every_rank(const std::function<void()> &work);

/// Runs @p work on the first rank; if it throws, every rank throws as in on_every_rank().
void on_first_rank(const std::function<void()> &work);

/// Returns on every rank the text that @p work returns on the first rank. Throws as on_first_rank().
std::string from_first_rank(const std::function<std::string()> &work);

/// Aborts all processes; for failures on one rank only.
[[noreturn]] void abort_all_ranks(int exit_status);

} // namespace stemware::pipeline
