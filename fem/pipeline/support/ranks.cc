#include "fem/pipeline/support/ranks.h"

#include "fem/pipeline/support/failures.h"

#include <deal.II/base/mpi.h>

#include <boost/serialization/utility.hpp>

#include <cstdlib>
#include <filesystem>
#include <memory>
#include <utility>
#include <vector>

namespace stemware::pipeline
{

namespace mpi = dealii::Utilities::MPI;

namespace
{

std::unique_ptr<mpi::MPI_InitFinalize> running_session;

#ifdef DEAL_II_WITH_MPI
constexpr bool has_mpi = true;
#else
constexpr bool has_mpi = false;
#endif

/// Open MPI, PMIx and MPICH launchers tell their processes so.
bool launched_by_mpirun()
{
  for (const char *variable : { "OMPI_COMM_WORLD_RANK", "PMIX_RANK", "PMI_RANK" })
    if (std::getenv(variable) != nullptr)
      return true;
  return false;
}

/// Outcome of some work: the exit code that belongs to it, and the message of its failure.
std::pair<int, std::string> outcome_of(const std::function<void()> &work)
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
  if (launched_by_mpirun() && has_mpi)
    start_mpi();
}

MpiSession::~MpiSession()
{
  running_session.reset();
}

void start_mpi()
{
  if (launched_by_mpirun() && !has_mpi)
    throw BadInput("mpirun has started this program, whose deal.II has no MPI, so that its processes do not "
                   "know of each other; start it by itself.");
  static int n_arguments = 0;
  static char **arguments = nullptr;
  // A process that stands alone needs no daemon of Open MPI beside it, nor the ssh that the daemon asks for;
  // nor the folder in /tmp, which has the same name for all such processes: where two start at once, one
  // finds it made, or gone, and aborts; nor a network, whose libraries take 0.2 s to find that there is none.
  if (!launched_by_mpirun())
    for (const auto &[name, value] : { std::pair("OMPI_MCA_ess_singleton_isolated", "1"),
                                       std::pair("OMPI_MCA_orte_create_session_dirs", "0"),
                                       std::pair("OMPI_MCA_pml", "ob1"), std::pair("OMPI_MCA_btl", "self") })
      ::setenv(name, value, 0);
  // One thread per rank: deal.II's own threads would compete with the other ranks and make sums depend on the
  // machine.
  if (!running_session)
    running_session = std::make_unique<mpi::MPI_InitFinalize>(n_arguments, arguments, 1);
}

void on_every_rank(const std::function<void()> &work)
{
  std::vector<std::pair<int, std::string>> outcomes = { outcome_of(work) };
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
  return running_session ? mpi::this_mpi_process(MPI_COMM_WORLD) : 0;
}

unsigned int n_ranks()
{
  return running_session ? mpi::n_mpi_processes(MPI_COMM_WORLD) : 1;
}

bool is_first_rank()
{
  return this_rank() == 0;
}

void abort_all_ranks(int exit_status)
{
#ifdef DEAL_II_WITH_MPI
  MPI_Abort(MPI_COMM_WORLD, exit_status);
#endif
  std::_Exit(exit_status);
}

} // namespace stemware::pipeline
