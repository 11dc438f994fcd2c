// MPI through deal.II, which starts what stands on MPI with it.
#include "fem/pipeline/system/rank_functions.h"

#include <deal.II/base/mpi.h>
#include <deal.II/base/multithread_info.h>

#include <boost/serialization/utility.hpp>

#include <csignal>
#include <memory>

namespace stemware::pipeline
{

namespace
{

namespace mpi = dealii::Utilities::MPI;

#ifdef DEAL_II_WITH_MPI
constexpr bool has_mpi = true;
#else
constexpr bool has_mpi = false;
#endif

std::unique_ptr<mpi::MPI_InitFinalize> session;

void start()
{
  if (session || mpi::job_supports_mpi())
    return;
  static int n_arguments = 0;
  static char **arguments = nullptr;
  const unsigned int n_threads = dealii::MultithreadInfo::n_threads();
  // Open MPI gives a hang-up its default action back, which nohup had taken.
  const auto hang_up = std::signal(SIGHUP, SIG_IGN);
  session = std::make_unique<mpi::MPI_InitFinalize>(n_arguments, arguments, 1);
  if (hang_up != SIG_ERR)
    std::signal(SIGHUP, hang_up);
  dealii::MultithreadInfo::set_thread_limit(n_threads);
}

void stop()
{
  session.reset();
}

unsigned int this_rank()
{
  return mpi::this_mpi_process(MPI_COMM_WORLD);
}

unsigned int n_ranks()
{
  return mpi::n_mpi_processes(MPI_COMM_WORLD);
}

std::vector<RankOutcome> all_gather(const RankOutcome &outcome)
{
  return mpi::all_gather(MPI_COMM_WORLD, outcome);
}

std::string broadcast(const std::string &text)
{
  return mpi::broadcast(MPI_COMM_WORLD, text);
}

void abort(int exit_status)
{
#ifdef DEAL_II_WITH_MPI
  MPI_Abort(MPI_COMM_WORLD, exit_status);
#else
  (void)exit_status;
#endif
}

} // namespace

extern "C" const RankFunctions stemware_ranks;
const RankFunctions stemware_ranks = {
  has_mpi, start, stop, this_rank, n_ranks, all_gather, broadcast, abort
};

} // namespace stemware::pipeline
