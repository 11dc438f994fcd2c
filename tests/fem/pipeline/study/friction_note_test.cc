// What the console says of friction that deforms the foot: the second harmonic is named under a hard
// interface on a table that is stiff, not on cork or cloth.
#include "fem/pipeline/study/study_file.h"

#include <gtest/gtest.h>

#include <string>

namespace stemware::pipeline
{
namespace
{

bool names_the_second_harmonic(const Study &study)
{
  return friction_note(study).find("second harmonic") != std::string::npos;
}

TEST(FrictionNote, IsOfTheSecondHarmonicWhereInterfaceAndTableAreStiff)
{
  const std::string cookbooks = STEMWARE_COOKBOOKS;
  Study study = read_study(cookbooks + "/bare_wood.prm");
  EXPECT_TRUE(names_the_second_harmonic(study));
  EXPECT_EQ(friction_note(study).find("deforms the foot and the table"), 0u);
  study.contact.friction_coupling = FrictionCoupling::none;
  EXPECT_EQ(friction_note(study).find("does not deform the foot"), 0u);
  EXPECT_TRUE(names_the_second_harmonic(study));
  study.table.interface = TableInterface::rough;
  EXPECT_FALSE(names_the_second_harmonic(study));

  EXPECT_FALSE(names_the_second_harmonic(read_study(cookbooks + "/wine_glass.prm")));
  study = read_study(cookbooks + "/wine_glass.prm");
  study.table.interface = TableInterface::hard; // on a rigid table
  EXPECT_TRUE(names_the_second_harmonic(study));
}

// There the friction in the foot changes the spin by a third of what all harmonics do, and that in the cork
// by three times it (docs/cookbooks/soft_cork.md).
TEST(FrictionNote, IsSilentOnCorkAndCloth)
{
  Study cork = read_study(std::string(STEMWARE_COOKBOOKS) + "/soft_cork.prm");
  EXPECT_EQ(friction_note(cork), "deforms the foot and the table");
  cork.contact.friction_coupling = FrictionCoupling::none;
  EXPECT_EQ(friction_note(cork), "does not deform the foot");
  cork.contact.friction_coupling = FrictionCoupling::elastic;
  cork.table.disc_material.young_modulus = 1e6;
  EXPECT_EQ(friction_note(cork), "deforms the foot and the table");
}

} // namespace
} // namespace stemware::pipeline
