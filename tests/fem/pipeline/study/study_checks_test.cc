// Values that do not go together, that no glass has, and choices that one entry makes for another.
#include "fem/pipeline/study/study_file.h"
#include "fem/pipeline/support/failures.h"

#include <gtest/gtest.h>

namespace stemware::pipeline
{
namespace
{

using Settings = std::vector<std::pair<std::string, std::string>>;

std::string refusal_of(const Settings &settings)
{
  try
  {
    with_values(Study(), "the test", settings);
    return "";
  }
  catch (const BadInput &error)
  {
    return error.what();
  }
}

TEST(StudyChecks, WithoutAContactThereIsNoFootToCheck)
{
  // A ring of 65 mm, to which the default foot of 34 mm does not belong.
  const Settings ring = { { "Glass/Contact radius", "65 mm" } };
  EXPECT_NE(refusal_of(ring).find("Glass/Foot radius"), std::string::npos) << refusal_of(ring);
  Settings paper = ring;
  paper.emplace_back("Load/Source", "first harmonic");
  EXPECT_EQ(refusal_of(paper), "");
  paper.emplace_back("Glass/Contact radius", "-65 mm");
  EXPECT_NE(refusal_of(paper), "");
}

TEST(StudyChecks, LengthsInAnotherUnitAreRefused)
{
  EXPECT_EQ(
    refusal_of({ { "Glass/Foot radius", "34" } }),
    "Glass/Foot radius = 34 m is 1133.33 times Glass/Contact radius = 0.03 m, but from 1e-5 to 300 is "
    "allowed; give both in one unit.");
  const Settings elastic = { { "Table/Substrate", "elastic" } };
  for (const auto &[entry, value] : Settings{ { "Glass/Stem height", "10" },
                                              { "Glass/Land width", "1e-12" },
                                              { "Glass/Foot thickness", "1e12" },
                                              { "Glass/Edge thickness", "1e-9" },
                                              { "Table/Disc radius", "150" },
                                              { "Table/Disc thickness", "50" },
                                              { "Motion/Orbit radius", "1e-5" } })
  {
    Settings settings = elastic;
    settings.emplace_back(entry, value);
    EXPECT_EQ(refusal_of(settings).find(entry + " = " + value + " m is "), 0u) << refusal_of(settings);
  }
  // A glass in millimetres under a motion in metres.
  EXPECT_NE(refusal_of({ { "Glass/Contact radius", "30" },
                         { "Glass/Foot radius", "34" },
                         { "Glass/Foot thickness", "4" },
                         { "Glass/Land width", "4" },
                         { "Glass/Land height", "1" },
                         { "Glass/Crown radius", "3" },
                         { "Glass/Underside rise", "3" },
                         { "Glass/Edge thickness", "1.5" },
                         { "Glass/Fillet radius", "5" },
                         { "Glass/Stem radius", "5" },
                         { "Glass/Stem height", "10" } }),
            "");
}

TEST(StudyChecks, LengthsThatNothingIsMadeFromAreNotLookedAt)
{
  EXPECT_EQ(refusal_of({ { "Table/Disc radius", "150" } }), "");
  EXPECT_EQ(refusal_of({ { "Load/Source", "first harmonic" }, { "Glass/Stem height", "10" } }), "");
}

TEST(StudyChecks, ThinLayersAndLargeDiscsAreAllowed)
{
  EXPECT_EQ(refusal_of({ { "Table/Substrate", "elastic" }, { "Table/Disc thickness", "5e-5" } }), "");
  EXPECT_EQ(
    refusal_of(
      { { "Table/Substrate", "elastic" }, { "Table/Disc radius", "3" }, { "Table/Disc thickness", "3" } }),
    "");
}

TEST(StudyChecks, SolidBodyStandsOnRigidGroundWithEveryInterface)
{
  for (const char *interface : { "hard", "Winkler", "rough" })
    EXPECT_EQ(refusal_of({ { "Contact/Body", "solid" }, { "Table/Interface", interface } }), "");
  EXPECT_EQ(refusal_of({ { "Contact/Body", "solid" }, { "Table/Substrate", "elastic" } }),
            "Table/Substrate = elastic needs a body of revolution; set Contact/Body = revolution.");
  EXPECT_EQ(refusal_of({ { "Contact/Body", "solid" }, { "Load/Coupling", "two-way" } }), "");
}

TEST(StudyChecks, LoadHarmonicsNeedLines)
{
  EXPECT_EQ(refusal_of({ { "Contact/Load harmonics", "63" } }), "");
  EXPECT_EQ(
    refusal_of({ { "Contact/Load harmonics", "64" } }),
    "Contact/Load harmonics = 64 needs more than 128 Contact/Azimuth lines, not 128; give more lines, "
    "or fewer load harmonics.");
}

TEST(StudyChecks, AGoalNeedsAFootWhoseErrorIsEstimated)
{
  EXPECT_EQ(refusal_of({ { "Contact/Goal", "torque" }, { "Contact/Body", "solid" } }), "");
  for (const auto &[settings, needs] :
       { std::pair(Settings{ { "Contact/Body", "solid" }, { "Table/Interface", "hard" } },
                   "Contact/Goal of a solid foot on a hard table needs a refined mesh"),
         std::pair(Settings{ { "Contact/Body", "solid" }, { "Contact/Rings", "1" } },
                   "Contact/Goal needs more than one ring"),
         std::pair(Settings{}, "Contact/Goal is given for a body of revolution") })
  {
    Settings with_goal = settings;
    with_goal.emplace_back("Contact/Goal", "a2");
    EXPECT_EQ(refusal_of(with_goal).find(needs), 0u) << refusal_of(with_goal);
    EXPECT_EQ(refusal_of(settings), "");
  }
}

TEST(StudyChecks, ALoadFileHasAMomentOfItsOwn)
{
  EXPECT_EQ(
    refusal_of({ { "Load/Source", "file" }, { "Load/File", "a.dat" }, { "Load/Moment ratio", "0.5" } }),
    "Load/Moment ratio = 0.5 contradicts Load/Source = file, whose load has a moment of its own; leave "
    "Moment ratio at -1.");
}

TEST(StudyChecks, SizesThatWouldRunWithoutEndAreRefused)
{
  EXPECT_EQ(refusal_of({ { "Glass/Foot thickness", "40 um" } }),
            "Glass/Foot thickness = 4e-5 m is 0.00133333 times Glass/Contact radius = 0.03 m, but from 0.01 "
            "to 300 is "
            "allowed; give both in one unit.");
  EXPECT_NE(refusal_of({ { "Table/Substrate", "elastic" }, { "Table/Disc thickness", "20 um" } })
              .find("Table/Disc thickness = 2e-5 m is"),
            std::string::npos);
  EXPECT_EQ(
    refusal_of({ { "Table/Foundation modulus", "1e22" } }),
    "Table/Foundation modulus = 1e22 Pa/m is 4.28571e9 times Glass/Young modulus over Glass/Contact radius, "
    "but at most 1e8 is allowed; write Table/Interface = hard for a table that does not yield.");
  EXPECT_EQ(refusal_of({ { "Glass/Foot thickness", "0.3 mm" } }), "");
  EXPECT_EQ(refusal_of({ { "Table/Foundation modulus", "1e20" } }), "");
}

TEST(StudyChecks, NumbersThatAreNotAllowed)
{
  for (const auto &[entry, value] : Settings{ { "Motion/Grip torque", "-1e-3" },
                                              { "Motion/Tilt", "yes" },
                                              { "Table/Layer thickness", "-0.005" },
                                              { "Contact/Rings", "0" },
                                              { "Contact/Rings", "26" } })
    EXPECT_NE(refusal_of({ { entry, value } }), "") << entry << " = " << value;
  EXPECT_EQ(refusal_of({ { "Contact/Rings", "25" } }), "");
}

TEST(StudyChoices, AGivenMomentIsOneWayAndDoesNotTilt)
{
  Study study;
  EXPECT_TRUE(study.load.is_in_balance());
  EXPECT_TRUE(study.tilts());
  study.load.moment_ratio = 0.5;
  EXPECT_FALSE(study.load.is_in_balance());
  EXPECT_FALSE(study.tilts());
}

TEST(StudyChoices, TiltActsInTheClosureFullOnAContact)
{
  const auto tilts = [](const Settings &settings)
  { return with_values(Study(), "the test", settings).tilts(); };
  EXPECT_TRUE(tilts({ { "Load/Coupling", "one-way" } }));
  EXPECT_FALSE(tilts({ { "Motion/Tilt", "neglected" } }));
  EXPECT_FALSE(tilts({ { "Motion/Closure", "paper" } }));
  EXPECT_FALSE(tilts({ { "Motion/Closure", "hand" } }));
  EXPECT_FALSE(tilts({ { "Load/Source", "first harmonic" } }));
}

TEST(StudyChoices, FrictionDeformsEitherBody)
{
  Study study;
  EXPECT_TRUE(study.friction_deforms());
  study.contact.body = BodyKind::solid;
  EXPECT_TRUE(study.friction_deforms());
  study.contact.friction_coupling = FrictionCoupling::none;
  EXPECT_FALSE(study.friction_deforms());
}

TEST(StudyChoices, WavinessCanBeLeftOut)
{
  Study study;
  study.glass.waviness = *parse_waviness("3: 2e-6");
  EXPECT_TRUE(study.has_waviness());
  study.model.waviness = false;
  EXPECT_FALSE(study.has_waviness());
}

} // namespace
} // namespace stemware::pipeline
