// The program `stemware`: from a study file to what the harmonics of the load do to the spin of the glass.

#include "fem/pipeline/app/program.h"
#include "fem/pipeline/support/interruption.h"

namespace
{

void before_libraries(int, char **, char **)
{
  stemware::pipeline::hold_interruptions_back();
}

/// Called by the loader before the libraries are initialised, some of which begin threads there.
__attribute__((section(".preinit_array"), used)) void (*const first_call)(int, char **,
                                                                          char **) = before_libraries;

} // namespace

int main(int argc, char *argv[])
{
  return stemware::pipeline::run_program(argc, argv);
}
