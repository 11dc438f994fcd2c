// Program `stemware_schema FILE`: writes the JSON schema of summary.json to FILE.
#include "fem/pipeline/result/verb_results.h"

#include <fstream>

int main(int, char **argv)
{
  std::ofstream file(argv[1]);
  file << stemware::pipeline::summary_schema() << std::flush;
  return file ? 0 : 1;
}
