// Writes summary.schema.json: stemware_schema FILE.
#include "fem/pipeline/result/schema.h"

#include <fstream>

int main(int, char **argv)
{
  std::ofstream file(argv[1]);
  file << stemware::pipeline::summary_schema() << std::flush;
  return file ? 0 : 1;
}
