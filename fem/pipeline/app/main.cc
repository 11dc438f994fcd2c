// The program `stemware`: from a study file to what the harmonics of the load do to the spin of the glass.

#include "fem/pipeline/app/program.h"

int main(int argc, char *argv[])
{
  return stemware::pipeline::run_program(argc, argv);
}
