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
#include <optional>
#include <utility>
#include <vector>

namespace stemware::pipeline
{

namespace
{

namespace mpi = dealii::Utilities::MPI;

using RankOutcome = std::pair<int, std::string>;

/// deal.II's MPI session, owned by this program; nullptr without MPI or if another program started MPI.
std::unique_ptr<mpi::MPI_InitFinalize> session;

std::atomic<bool> is_running = false;

bool is_set_to_one(const char *variable)
{
  const char *value = std::getenv(variable);
  return value != nullptr && std::string(value) == "1";
}

/// Returns false if mpirun states that it has started a single process, true if it has started this process
/// otherwise, std::nullopt without mpirun. Detects Open MPI, MPICH and Slurm with PMIx by their environment
/// variables for rank and number of ranks.
std::optional<bool> started_several()
{
  for (const auto &[rank, size] :
       { std::pair("OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"), std::pair("PMI_RANK", "PMI_SIZE"),
         std::pair("PMIX_RANK", "SLURM_STEP_NUM_TASKS") })
    if (std::getenv(rank) != nullptr)
      return !is_set_to_one(size);
  return std::nullopt;
}

/// Sets Open MPI's environment for a single process: no daemon (needs ssh), no session folder in /tmp
/// (simultaneous processes would collide) and no network (takes 0.2 s to detect). Hides a Slurm step of one
/// process, because an Open MPI without Slurm's PMI would abort.
void prepare_to_stand_alone()
{
  for (const auto &[name, value] : { std::pair("OMPI_MCA_ess_singleton_isolated", "1"),
                                     std::pair("OMPI_MCA_orte_create_session_dirs", "0"),
                                     std::pair("OMPI_MCA_pml", "ob1"), std::pair("OMPI_MCA_btl", "self") })
    ::setenv(name, value, 0);
  if (is_set_to_one("SLURM_STEP_NUM_TASKS"))
    ::unsetenv("SLURM_STEP_ID");
}

void start_session()
{
  if (mpi::job_supports_mpi()) // MPI has already been started, e.g. by mpi4py
    return;
  static int n_arguments = 0;
  static char **arguments = nullptr;
  const unsigned int n_threads = dealii::MultithreadInfo::n_threads();
  // Open MPI resets SIGHUP to its default action, which would undo nohup.
  struct sigaction hang_up;
  const bool is_known = ::sigaction(SIGHUP, nullptr, &hang_up) == 0;
  session = std::make_unique<mpi::MPI_InitFinalize>(n_arguments, arguments, 1);
  if (is_known)
    ::sigaction(SIGHUP, &hang_up, nullptr);
  dealii::MultithreadInfo::set_thread_limit(n_threads);
}

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
  if (started_several().value_or(false))
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
  if (started_several().value_or(false))
    throw BadInput(
      "mpirun started this program, whose deal.II was built without MPI; start it without mpirun.");
#endif
  if (!started_several())
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

unsigned int n_ranks()
{
  return is_running ? mpi::n_mpi_processes(MPI_COMM_WORLD) : 1;
}

bool is_first_rank()
{
  return !is_running || mpi::this_mpi_process(MPI_COMM_WORLD) == 0;
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
