// Writes N random studies as 1.prm, 2.prm, ... into a folder. Usage: random_study_files N SEED FOLDER

#include "tests/benchmark/random_study.h"

#include <cstdlib>
#include <fstream>

int main(int argc, char *argv[])
{
  using namespace stemware::pipeline;
  if (argc != 4)
    return 2;
  RandomStudies studies(static_cast<unsigned int>(std::atoi(argv[2])));
  const int n_studies = std::atoi(argv[1]);
  for (int i = 1; i <= n_studies; ++i)
    std::ofstream(std::string(argv[3]) + "/" + std::to_string(i) + ".prm") << study_as_prm(studies.next());
}
