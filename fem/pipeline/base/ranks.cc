#include "fem/pipeline/base/ranks.h"

#include "fem/pipeline/base/failures.h"

#include <deal.II/base/mpi.h>
#include <deal.II/base/multithread_info.h>

#include <boost/serialization/utility.hpp>

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace stemware::pipeline
{

namespace
{

namespace mpi = dealii::Utilities::MPI;

/// Exit code and message of some work on one rank.
using RankOutcome = std::pair<int, std::string>;

/// MPI of this program, and all that deal.II starts with it; nullptr if MPI was started by others, or never.
std::unique_ptr<mpi::MPI_InitFinalize> session;

/// Whether start_mpi() has been called.
std::atomic<bool> is_running = false;

bool says_one(const char *variable)
{
  const char *value = std::getenv(variable);
  return value != nullptr && std::string(value) == "1";
}

/// Launcher that has started this process.
struct Launcher
{
  bool is_there = false;
  bool has_several = false; ///< processes: unless it says that there is one
};

/// Open MPI, MPICH and Slurm with PMIx tell their processes rank and number.
Launcher launcher()
{
  for (const auto &[rank, size] :
       { std::pair("OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"), std::pair("PMI_RANK", "PMI_SIZE"),
         std::pair("PMIX_RANK", "SLURM_STEP_NUM_TASKS") })
    if (std::getenv(rank) != nullptr)
      return { true, !says_one(size) };
  return {};
}

/// Prepares the environment of a process that stands alone: it needs no daemon of Open MPI beside it, nor the
/// ssh that the daemon asks for; nor the folder in /tmp, which has the same name for all such processes: if
/// two start at once, one finds it made, or gone, and aborts; nor a network, whose libraries take 0.2 s to
/// find that there is none. In a step of Slurm, Open MPI would ask Slurm for the ranks, and end the process
/// if it was built without Slurm's PMI.
void prepare_to_stand_alone()
{
  for (const auto &[name, value] : { std::pair("OMPI_MCA_ess_singleton_isolated", "1"),
                                     std::pair("OMPI_MCA_orte_create_session_dirs", "0"),
                                     std::pair("OMPI_MCA_pml", "ob1"), std::pair("OMPI_MCA_btl", "self") })
    ::setenv(name, value, 0);
  if (says_one("SLURM_STEP_NUM_TASKS"))
    ::unsetenv("SLURM_STEP_ID");
}

void start_session()
{
  if (mpi::job_supports_mpi()) // mpi4py has started it
    return;
  static int n_arguments = 0;
  static char **arguments = nullptr;
  const unsigned int n_threads = dealii::MultithreadInfo::n_threads();
  // Open MPI gives a hang-up its default action back, which nohup had taken.
  struct sigaction hang_up;
  const bool is_known = ::sigaction(SIGHUP, nullptr, &hang_up) == 0;
  session = std::make_unique<mpi::MPI_InitFinalize>(n_arguments, arguments, 1);
  if (is_known)
    ::sigaction(SIGHUP, &hang_up, nullptr);
  dealii::MultithreadInfo::set_thread_limit(n_threads);
}

/// Outcome of some work: the exit code that belongs to it, and the message of its failure.
RankOutcome outcome_of(const std::function<void()> &work)
try
{
  work();
  return { static_cast<int>(ExitCode::success), "" };
}
catch (const std::exception &failure)
{
  const bool is_of_files = dynamic_cast<const OutputFailure *>(&failure) != nullptr ||
                           dynamic_cast<const std::filesystem::filesystem_error *>(&failure) != nullptr;
  return { static_cast<int>(is_of_files ? ExitCode::output_failure : ExitCode::numerical_failure),
           failure.what() };
}

} // namespace

MpiSession::MpiSession()
{
  if (launcher().has_several)
    start_mpi();
}

MpiSession::~MpiSession()
{
  is_running = false;
  session.reset();
}

void start_mpi()
{
  static std::mutex mutex;
  const std::lock_guard<std::mutex> lock(mutex);
  if (is_running)
    return;
#ifndef DEAL_II_WITH_MPI
  if (launcher().has_several)
    throw BadInput(
      "mpirun started this program, whose deal.II was built without MPI; start it without mpirun.");
#endif
  if (!launcher().is_there)
    prepare_to_stand_alone();
  start_session();
  is_running = true;
}

void on_every_rank(const std::function<void()> &work)
{
  std::vector<RankOutcome> outcomes = { outcome_of(work) };
  if (n_ranks() > 1)
    outcomes = mpi::all_gather(MPI_COMM_WORLD, outcomes.front());
  for (const auto &[code, message] : outcomes)
    if (code == static_cast<int>(ExitCode::output_failure))
      throw OutputFailure(message);
    else if (code != static_cast<int>(ExitCode::success))
      throw std::runtime_error(message);
}

void on_first_rank(const std::function<void()> &work)
{
  on_every_rank(is_first_rank() ? work : [] {});
}

std::string from_first_rank(const std::function<std::string()> &work)
{
  std::string text;
  on_first_rank([&] { text = work(); });
  return n_ranks() > 1 ? mpi::broadcast(MPI_COMM_WORLD, text) : text;
}

unsigned int this_rank()
{
  return is_running ? mpi::this_mpi_process(MPI_COMM_WORLD) : 0;
}

unsigned int n_ranks()
{
  return is_running ? mpi::n_mpi_processes(MPI_COMM_WORLD) : 1;
}

bool is_first_rank()
{
  return this_rank() == 0;
}

void abort_all_ranks(int exit_status)
{
#ifdef DEAL_II_WITH_MPI
  if (is_running)
    MPI_Abort(MPI_COMM_WORLD, exit_status);
#endif
  std::_Exit(exit_status);
}

} // namespace stemware::pipeline
