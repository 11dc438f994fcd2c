// A program that does nothing but start deal.II with MPI: what any program built on it takes before its own
// work. Build: cmake --preset bench && cmake --build --preset bench, compare: time build/bench/start_deal_ii

#include <deal.II/base/mpi.h>
#include <deal.II/base/revision.h>

#include <cstdio>

int main(int argc, char *argv[])
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::printf("deal.II %s\n", DEAL_II_PACKAGE_VERSION);
  return 0;
}
