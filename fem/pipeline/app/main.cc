// The program `stemware`: from a study file to what the harmonics of the load do to the spin of the glass.

#include "fem/pipeline/app/program.h"

#include <cstdlib>

int main(int argc, char *argv[])
{
  const int exit_code = stemware::pipeline::run_program(argc, argv);
  // Everything is written. At the end of deal.II's static objects TBB starts threads, and aborts the program
  // if the memory left has no room for their stacks.
  std::_Exit(exit_code);
}
