#include "fem/pipeline/study/study_file.h"
#include "tests/fem/pipeline/mat_study.h"
#include "tests/ulps.h"

#include <gtest/gtest.h>

#include <cmath>

namespace stemware::pipeline
{
namespace
{

fem::Table table_of(const std::vector<std::pair<std::string, std::string>> &values)
{
  return with_values(test::mat_study(), "the test", values).table.make();
}

TEST(TableSection, MakesAMatOfTheGivenModulus)
{
  const fem::Table table = table_of({ { "Table/Foundation modulus", "4e9" } });
  EXPECT_NEAR(table.interface->penetration_at(1e5), 1e5 / 4e9, ulps(4, 1e5 / 4e9));
  EXPECT_FALSE(table.substrate);
}

TEST(TableSection, MakesARoughTableOfTheGivenPressureAndDecayLength)
{
  const fem::Table table = table_of({ { "Table/Interface", "rough" },
                                      { "Table/Reference pressure", "2e9" },
                                      { "Table/Decay length", "3e-6" } });
  // p = p0 exp(d / s) with the penetration d and the decay length s
  EXPECT_NEAR(table.interface->penetration_at(2e9 * std::exp(-5.)), -15e-6, ulps(40, 15e-6));
  EXPECT_NEAR(table.interface->stiffness_at(1e6), 1e6 / 3e-6, 1e-3);
}

TEST(TableSection, MakesADiscOfTheGivenSizeAndMaterial)
{
  const fem::Table table = table_of({ { "Table/Interface", "hard" },
                                      { "Table/Substrate", "elastic" },
                                      { "Table/Disc radius", "0.12" },
                                      { "Table/Disc thickness", "0.02" },
                                      { "Table/Disc Young modulus", "5e9" },
                                      { "Table/Disc Poisson ratio", "0.1" } });
  EXPECT_TRUE(table.interface->is_hard());
  ASSERT_TRUE(table.substrate);
  EXPECT_EQ(table.substrate->disc.radius, 0.12);
  EXPECT_EQ(table.substrate->disc.thickness, 0.02);
  EXPECT_EQ(table.substrate->material.young_modulus, 5e9);
  EXPECT_EQ(table.substrate->material.poisson_ratio, 0.1);
}

} // namespace
} // namespace stemware::pipeline
