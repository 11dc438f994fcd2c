#pragma once

#include <functional>
#include <string>

namespace stemware::pipeline
{

/// The span in which MPI may be used; one per program, in main(). It ends MPI, and starts it where mpirun has
/// started the program.
class MpiSession
{
public:
  MpiSession();
  ~MpiSession();
  MpiSession(const MpiSession &) = delete;
  MpiSession &operator=(const MpiSession &) = delete;
};

/// Starts MPI unless it runs already. Without mpirun that is left to those who need it: it takes a third of a
/// second.
void start_mpi();

/// Whether this process is the one that prints and writes tables. True without MPI.
bool is_first_rank();

/// Number of processes that work on the study together.
unsigned int n_ranks();

/// Runs @p work on the first rank; the text it returns is returned on every rank. When it throws, every rank
/// does: OutputFailure for trouble with files, std::runtime_error with the same message for everything else.
std::string on_first_rank(const std::function<std::string()> &work);

/// Runs @p work on every rank, and waits for all of them. When it throws on some, every rank does, with the
/// message of the first of those: OutputFailure for trouble with files, std::runtime_error for everything
/// else.
void on_every_rank(const std::function<void()> &work);

/// Position of this process among n_ranks().
unsigned int this_rank();

/// Ends all processes at once; for failures that the other ranks do not know of.
[[noreturn]] void abort_all_ranks(int exit_status);

} // namespace stemware::pipeline
