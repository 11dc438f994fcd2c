// Before any test has begun a thread, the process forks that runs programs.
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

int main(int argc, char **argv)
{
  stemware::test::serve_programs();
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
