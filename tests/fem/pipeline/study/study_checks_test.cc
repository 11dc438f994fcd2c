#include "fem/pipeline/study/study_entries.h"
#include "tests/fem/pipeline/mat_study.h"
#include "tests/fem/pipeline/matchers.h"

#include <gtest/gtest.h>

namespace stemware::pipeline
{
namespace
{

using test::refusal_of;
using Settings = test::EntryTexts;

TEST(StudyChecks, CheckOnlyTheContactRadiusOfTheFootIfNoContactIsSolved)
{
  // The contact radius 65 mm exceeds the default foot radius 34 mm.
  const Settings ring = { { "Glass/Contact radius", "65 mm" } };
  EXPECT_THAT(refusal_of(ring), testing::HasSubstr("Glass/Foot radius"));
  Settings paper = ring;
  paper.emplace_back("Load/Source", "first harmonic");
  EXPECT_EQ(refusal_of(paper), "");
  paper.emplace_back("Glass/Contact radius", "-65 mm");
  EXPECT_NE(refusal_of(paper), "");
}

/// Settings and the beginning of their refusal ("entry = value"); empty if the settings are allowed.
struct Check
{
  Settings settings;
  std::string named;
};

TEST(StudyChecks, RefuseOnlyInconsistentAndOutOfRangeValues)
{
  const std::pair<std::string, std::string> elastic = { "Table/Substrate", "elastic" },
                                            solid = { "Contact/Body", "solid" };
  const std::vector<Check> checks = {
    // Lengths typed in the wrong unit. Unused lengths are not checked.
    { { { "Glass/Foot radius", "34" } }, "Glass/Foot radius = 34 m" },
    { { { "Glass/Stem height", "10" } }, "Glass/Stem height = 10 m" },
    { { { "Glass/Land width", "1e-12" } }, "Glass/Land width = 1e-12 m" },
    { { { "Glass/Foot thickness", "1e12" } }, "Glass/Foot thickness = 1e12 m" },
    { { { "Glass/Edge thickness", "1e-9" } }, "Glass/Edge thickness = 1e-9 m" },
    { { { "Motion/Orbit radius", "1e-5" } }, "Motion/Orbit radius = 1e-5 m" },
    { { elastic, { "Table/Disc radius", "150" } }, "Table/Disc radius = 150 m" },
    { { elastic, { "Table/Disc thickness", "50" } }, "Table/Disc thickness = 50 m" },
    { { { "Table/Disc radius", "150" } }, "" },
    { { { "Load/Source", "first harmonic" }, { "Glass/Stem height", "10" } }, "" },
    // Thin layers and large discs are allowed within the range that can be computed.
    { { elastic, { "Table/Disc thickness", "5e-5" } }, "" },
    { { elastic, { "Table/Disc radius", "3" }, { "Table/Disc thickness", "3" } }, "" },
    { { elastic, { "Table/Disc thickness", "20 um" } }, "Table/Disc thickness = 2e-5 m" },
    { { { "Glass/Foot thickness", "0.3 mm" } }, "" },
    { { { "Glass/Foot thickness", "40 um" } }, "Glass/Foot thickness = 4e-5 m" },
    { { { "Table/Foundation modulus", "1e20" } }, "" },
    { { { "Table/Foundation modulus", "1e22" } }, "Table/Foundation modulus = 1e22 Pa/m" },
    // A solid body needs a rigid substrate.
    { { solid, { "Table/Interface", "hard" } }, "" },
    { { solid, { "Table/Interface", "rough" } }, "" },
    { { solid, { "Load/Coupling", "two-way" } }, "" },
    { { solid, elastic }, "Table/Substrate = elastic" },
    // The 128 azimuth lines resolve at most 63 load harmonics.
    { { { "Contact/Load harmonics", "63" } }, "" },
    { { { "Contact/Load harmonics", "64" } }, "Contact/Load harmonics = 64" },
    { { { "Load/Source", "file" }, { "Load/File", "a.dat" }, { "Load/Moment ratio", "0.5" } },
      "Load/Moment ratio = 0.5" },
    { { { "Contact/Rings", "25" } }, "" },
    { { { "Contact/Rings", "26" } }, "the test: Contact/Rings = 26" },
    { { { "Contact/Rings", "0" } }, "the test: Contact/Rings = 0" },
    { { { "Motion/Grip torque", "-1e-3" } }, "the test: Motion/Grip torque = -1e-3" },
    { { { "Motion/Tilt", "yes" } }, "the test: Motion/Tilt = yes" },
    { { { "Table/Layer thickness", "-0.005" } }, "the test: Table/Layer thickness = -0.005" },
  };
  for (const auto &[settings, named] : checks)
  {
    const std::string sentence = refusal_of(settings);
    EXPECT_EQ(sentence.substr(0, named.size()), named) << sentence;
    EXPECT_EQ(sentence.empty(), named.empty()) << sentence;
  }
}

TEST(StudyChecks, RefuseAGoalOnlyIfTheErrorCannotBeEstimated)
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

TEST(StudyChoices, AGivenMomentDisablesBalanceAndTilt)
{
  Study study;
  EXPECT_TRUE(study.load.is_in_balance());
  EXPECT_TRUE(study.tilts());
  study.load.moment_ratio = 0.5;
  EXPECT_FALSE(study.load.is_in_balance());
  EXPECT_FALSE(study.tilts());
}

TEST(StudyChoices, TiltRequiresTheFullClosureAndAContactAndCanBeNeglected)
{
  const auto tilts = [](const Settings &settings) { return test::mat_study_with(settings).tilts(); };
  EXPECT_TRUE(tilts({ { "Load/Coupling", "one-way" } }));
  EXPECT_FALSE(tilts({ { "Motion/Tilt", "neglected" } }));
  EXPECT_FALSE(tilts({ { "Motion/Closure", "paper" } }));
  EXPECT_FALSE(tilts({ { "Motion/Closure", "hand" } }));
  EXPECT_FALSE(tilts({ { "Load/Source", "first harmonic" } }));
}

TEST(StudyChecks, MessagesOfTheLibraryAreCompletedWithEntryNames)
{
  EXPECT_EQ(with_entries("Foot radius = -1 m is no length; change the foot radius or the disc radius."),
            "Glass/Foot radius = -1 m is no length; change the Glass/Foot radius or the Table/Disc radius.");
  EXPECT_EQ(with_entries("set mesh contact id = 7; the radii stay"),
            "set Contact/Mesh contact id = 7; the radii stay");
  EXPECT_EQ(with_entries("Contact/Foot layers = 0"), "Contact/Foot layers = 0");
}

} // namespace
} // namespace stemware::pipeline
