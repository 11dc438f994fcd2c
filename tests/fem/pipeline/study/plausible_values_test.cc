#include "fem/pipeline/base/numbers.h"
#include "fem/pipeline/study/study_checks.h"
#include "fem/pipeline/study/study_entries.h"
#include "fem/pipeline/study/study_file.h"
#include "fem/pipeline/study/study_size.h"
#include "tests/fem/pipeline/mat_study.h"
#include "tests/fem/pipeline/matchers.h"
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

namespace stemware::pipeline
{
namespace
{

using test::refusal_of;
using Settings = test::EntryTexts;
using Texts = std::vector<std::string>;

Texts notes_with(const Settings &settings)
{
  return implausible_notes(entries_of(test::mat_study_with(settings)));
}

TEST(PlausibleValues, WarnOfProbableUnitErrors)
{
  EXPECT_EQ(notes_with({ { "Motion/Mass", "300 g" } }), Texts());
  for (const auto &[entry, value, meant] : { std::tuple("Motion/Mass", "300", "write 300 g"),
                                             std::tuple("Motion/Orbit speed", "20", "write 20 cm/s"),
                                             std::tuple("Glass/Young modulus", "70", "write 70 GPa"),
                                             std::tuple("Motion/Friction coefficient", "5", "write 5 %"),
                                             std::tuple("Motion/Gravity", "1e6", "check number and unit") })
  {
    const Texts notes = notes_with({ { entry, value } });
    ASSERT_EQ(notes.size(), 1u) << entry;
    EXPECT_EQ(notes.front().find(entry + std::string(" = ") + value), 0u) << notes.front();
    EXPECT_THAT(notes.front(), testing::HasSubstr(meant));
  }
}

TEST(PlausibleValues, GiveNoWarningForUnusedEntries)
{
  EXPECT_EQ(notes_with({ { "Table/Disc thickness", "8" } }), Texts());
  EXPECT_EQ(notes_with({ { "Glass/Crown radius", "0" } }), Texts());
}

TEST(PlausibleValues, AreListedInTheDocumentation)
{
  const std::string page = test::read_text(STEMWARE_DOCS "/values.md");
  for (const StudyEntry &entry : entries_of(Study()))
    if (entry.plausible)
    {
      const std::string range =
        to_short_text(entry.plausible->first) + " to " + to_short_text(entry.plausible->second);
      EXPECT_THAT(page, testing::HasSubstr("\n| `" + entry.path() + "` | " + range +
                                           (entry.unit == "1" ? "" : " " + entry.unit) + " | " +
                                           entry.plausible_reason + " |\n"));
    }
}

TEST(PlausibleValues, ContainTheDefaultsAndExcludeValuesAboveTheMaximum)
{
  Study study;
  unsigned int n_ranges = 0;
  for (const StudyEntry &entry : study_entries(study))
  {
    if (entry.quantity != nullptr)
    {
      EXPECT_EQ(implausible_note(entry, *entry.quantity), "") << entry.path();
    }
    if (!entry.plausible)
      continue;
    EXPECT_LT(entry.plausible->first, entry.plausible->second) << entry.path();
    EXPECT_NE(implausible_note(entry, 1.01 * entry.plausible->second), "") << entry.path();
    EXPECT_FALSE(entry.plausible_reason.empty()) << entry.path();
    ++n_ranges;
  }
  EXPECT_GE(n_ranges, 35u);
}

TEST(StudySize, AllowsFineDiscretisationsASolidBodyAndALongMotion)
{
  for (const auto &setting : Settings{ { "Contact/Refinements", "3" },
                                       { "Contact/Harmonics", "64" },
                                       { "Contact/Azimuth lines", "4096" },
                                       { "Contact/Degree", "4" },
                                       { "Contact/Body", "solid" },
                                       { "Motion/End time", "100" } })
    EXPECT_EQ(refusal_of({ setting }), "") << setting.first;
}

TEST(StudySize, RefusalNamesTheCostliestEntryAndALargerLimitPermitsTheStudy)
{
  const auto expect_refusal =
    [](const std::string &entry, const std::string &value, const Settings &base = {})
  {
    Settings settings = base;
    settings.emplace_back("Contact/Harmonics", "20");
    settings.emplace_back(entry, value);
    EXPECT_EQ(refusal_of(settings).rfind(entry + " = " + value + " would take about ", 0), 0u)
      << refusal_of(settings);
    settings.emplace_back("Contact/Memory limit", "1e15");
    EXPECT_EQ(refusal_of(settings), "");
  };
  expect_refusal("Contact/Refinements", "6");
  expect_refusal("Contact/Harmonics", "1000");
  expect_refusal("Contact/Azimuth lines", "100000");
  expect_refusal(
    "Contact/Foot layers", "100",
    { { "Contact/Body", "solid" }, { "Contact/Azimuthal cells", "480" }, { "Contact/Radial cells", "40" } });
  expect_refusal(
    "Contact/Azimuthal cells", "2000",
    { { "Contact/Body", "solid" }, { "Contact/Foot layers", "20" }, { "Contact/Radial cells", "40" } });
  EXPECT_EQ(refusal_of({ { "Motion/End time", "1e6" } }).rfind("Motion/End time = 1e6 s in steps of ", 0),
            0u);
  EXPECT_EQ(refusal_of({ { "Motion/End time", "5000" }, { "Motion/Step limit", "1e7" } }), "");
}

TEST(StudySize, EstimatesTheUnknownsOfAMeshFromItsHeaderOrSizeAndRefusesALargeMesh)
{
  const test::ScratchFolder scratch;
  const auto size_with = [&](const std::string &mesh, const std::string &refinements = "0")
  {
    return size_of(test::mat_study_with({ { "Contact/Body", "solid" },
                                          { "Contact/Degree", "1" },
                                          { "Contact/Refinements", refinements },
                                          { "Contact/Mesh file", scratch.write("foot.msh", mesh) } }));
  };
  const std::string format_2 = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n7000\n";
  const std::string format_4 = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n1 2\n$EndEntities\n"
                               "$Nodes\n12 7000 1 7000\n";
  const std::string with_parameters = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$ParametricNodes\n7000\n";
  for (const std::string &mesh : { format_2, format_4, with_parameters, std::string(560000, 'x') })
    EXPECT_NEAR(size_with(mesh).unknowns, 21000, 1e-9);
  EXPECT_NEAR(size_with(format_2, "1").unknowns, 168000, 1e-9);
  const std::string large = scratch.write("large.msh", "$Nodes\n20000000\n");
  const std::string refusal =
    refusal_of({ { "Contact/Body", "solid" }, { "Contact/Degree", "2" }, { "Contact/Mesh file", large } });
  EXPECT_EQ(refusal.rfind("Contact/Mesh file = ", 0), 0u) << refusal;
  EXPECT_THAT(refusal, testing::HasSubstr("give a coarser mesh, or allow more with Contact/Memory limit = "));
}

TEST(StudySize, EstimatedMemoryIsWithinAFactorOfTwoOfMeasuredRuns)
{
  // The estimate must agree within a factor of two with the resident memory, measured with `stemware
  // truncate` of version 0.2 (body of revolution) and `stemware run --quick` of version 0.4 (solid).
  const auto megabytes = [](const Settings &settings)
  { return size_of(test::mat_study_with(settings)).memory / 1e6; };
  for (const auto &[found, measured] :
       { std::pair(megabytes({}), 189.), std::pair(megabytes({ { "Contact/Refinements", "2" } }), 454.),
         std::pair(megabytes({ { "Contact/Azimuth lines", "4000" } }), 411.),
         std::pair(megabytes({ { "Contact/Body", "solid" },
                               { "Contact/Azimuthal cells", "32" },
                               { "Contact/Radial cells", "6" } }),
                   858.) })
  {
    EXPECT_GT(found, measured / 2);
    EXPECT_LT(found, measured * 2);
  }
}

} // namespace
} // namespace stemware::pipeline
