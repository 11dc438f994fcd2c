// The program `stemware`: computes the effect of the load's harmonics on the spin of the glass from a study
// file.

#include "fem/pipeline/app/verbs.h"

#include <cstdlib>

int main(int argc, char *argv[])
{
  const int exit_code = stemware::pipeline::run_program(argc, argv);
  // Skips the destruction of deal.II's static objects, in which TBB starts threads and aborts the program if
  // memory for their stacks is missing. All files are already written.
  std::_Exit(exit_code);
}
