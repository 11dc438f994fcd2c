// Trilinos objects have to be destroyed before MPI_Finalize, so MPI must outlive the tests.
#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>

namespace
{

class FailurePrinter : public testing::EmptyTestEventListener
{
  void OnTestPartResult(const testing::TestPartResult &result) override
  {
    if (result.failed())
      std::cout << "rank " << dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) << ": "
                << (result.file_name() ? result.file_name() : "") << ':' << result.line_number() << ": "
                << result.message() << std::endl;
  }
};

} // namespace

int main(int argc, char **argv)
{
  // Without mpirun, Open MPI must start no daemon (which needs ssh), make no folder in /tmp (all processes
  // would use the same name) and use no network.
  if (std::getenv("OMPI_COMM_WORLD_RANK") == nullptr)
  {
    ::setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
    ::setenv("OMPI_MCA_orte_create_session_dirs", "0", 0);
    ::setenv("OMPI_MCA_pml", "ob1", 0);
    ::setenv("OMPI_MCA_btl", "self", 0);
  }
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  testing::InitGoogleTest(&argc, argv);
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) > 0)
  {
    testing::TestEventListeners &listeners = testing::UnitTest::GetInstance()->listeners();
    delete listeners.Release(listeners.default_result_printer());
    listeners.Append(new FailurePrinter); // the list owns the listener
  }
  return RUN_ALL_TESTS();
}
