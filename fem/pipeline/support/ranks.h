#pragma once

#include <functional>
#include <string>

namespace stemware::pipeline
{

/// The span in which MPI may be used; one per program, in main(). Ends MPI.
class MpiSession
{
public:
  /// Starts MPI if mpirun has started several processes. Throws as start_mpi().
  MpiSession();
  ~MpiSession();
  MpiSession(const MpiSession &) = delete;
  MpiSession &operator=(const MpiSession &) = delete;
};

/// Starts MPI unless it runs already, which takes a third of a second. Solid feet need it. Throws BadInput if
/// mpirun has started several processes of a program without MPI.
void start_mpi();

/// True if this process is the one that prints and writes tables. True without MPI.
bool is_first_rank();

/// Number of processes that work on the study together.
unsigned int n_ranks();

/// Runs @p work on every rank, and waits for all of them. When it throws on some, every rank does, with the
/// message of the first of those: OutputFailure for trouble with files, std::runtime_error for everything
/// else.
void on_every_rank(const std::function<void()> &work);

/// Runs @p work on the first rank; when it throws, every rank does, as in on_every_rank().
void on_first_rank(const std::function<void()> &work);

/// The text that @p work returns on the first rank, on every rank. Throws as on_first_rank().
std::string from_first_rank(const std::function<std::string()> &work);

/// Position of this process among n_ranks().
unsigned int this_rank();

/// Ends all processes at once; for failures that the other ranks do not know of.
[[noreturn]] void abort_all_ranks(int exit_status);

} // namespace stemware::pipeline
