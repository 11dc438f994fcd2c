#include "fem/pipeline/base/failures.h"
#include "fem/pipeline/study/study_checks.h"
#include "fem/pipeline/study/study_file.h"
#include "tests/fem/pipeline/mat_study.h"
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace stemware::pipeline
{
namespace
{

using Settings = test::EntryTexts;
using Names = std::vector<std::string>;

TEST(UnusedEntries, AreListedForEachChoiceOfTheModel)
{
  const Settings table = { { "Table/Foundation modulus", "1e9" },
                           { "Table/Decay length", "2e-6" },
                           { "Table/Disc radius", "0.1" } };
  const Settings body = { { "Contact/Foot layers", "1" },        { "Contact/Linear solver", "condensed" },
                          { "Contact/Radial cells", "2" },       { "Contact/Refinements", "0" },
                          { "Contact/Land grading", "2" },       { "Contact/Harmonics", "8" },
                          { "Contact/Mesh contact id", "2" },    { "Contact/Friction coupling", "elastic" },
                          { "Contact/Mesh contact height", "0" } };
  const Settings motion = { { "Motion/Closure", "full" },
                            { "Motion/Tilt", "included" },
                            { "Motion/Centre of mass height", "0.07" },
                            { "Load/Coupling", "two-way" } };
  struct Case
  {
    Settings all, choices;
    Names idle;
  };
  const std::vector<Case> cases = {
    { motion, {}, {} },
    { table,
      { { "Table/Interface", "hard" } },
      { "Table/Foundation modulus", "Table/Decay length", "Table/Disc radius" } },
    { table,
      { { "Table/Interface", "hard" }, { "Table/Substrate", "elastic" } },
      { "Table/Foundation modulus", "Table/Decay length" } },
    { table, { { "Table/Interface", "Winkler" } }, { "Table/Decay length", "Table/Disc radius" } },
    { table,
      { { "Table/Interface", "rough" }, { "Table/Substrate", "elastic" } },
      { "Table/Foundation modulus" } },
    { body,
      {},
      { "Contact/Mesh contact id", "Contact/Mesh contact height", "Contact/Foot layers",
        "Contact/Linear solver" } },
    { body,
      { { "Contact/Body", "solid" } },
      { "Contact/Mesh contact id", "Contact/Mesh contact height", "Contact/Land grading",
        "Contact/Harmonics" } },
    { { { "Contact/Radial cells", "2" }, { "Glass/Stem height", "0.02" }, { "Glass/Crown radius", "0.002" } },
      { { "Contact/Body", "solid" }, { "Contact/Mesh file", STEMWARE_MESHES "/oval_foot.msh" } },
      { "Glass/Stem height", "Contact/Radial cells" } },
    { { { "Contact/Land grading", "2" } }, { { "Glass/Crown radius", "0" } }, { "Contact/Land grading" } },
    { { { "Glass/Fillet radius", "0.002" } }, { { "Glass/Shape", "step" } }, { "Glass/Fillet radius" } },
    { motion,
      { { "Load/Moment ratio", "0.5" }, { "Load/Moment direction", "0" } },
      { "Motion/Centre of mass height", "Motion/Closure", "Motion/Tilt", "Load/Coupling" } },
    { { { "Load/Moment direction", "0" } }, {}, { "Load/Moment direction" } },
    { { { "Glass/Contact radius", "0.031" }, { "Glass/Young modulus", "5e10" }, { "Contact/Rings", "3" } },
      { { "Load/Source", "first harmonic" } },
      { "Glass/Young modulus", "Contact/Rings" } },
  };
  for (const auto &[all, choices, idle] : cases)
  {
    Settings settings = all;
    settings.insert(settings.end(), choices.begin(), choices.end());
    Names found = unused_entries(entries_of(test::mat_study_with(settings))), expected = idle;
    std::sort(found.begin(), found.end());
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(found, expected) << testing::PrintToString(settings);
  }
}

TEST(UnusedEntries, AreReportedUnlessACompleteFileGivesTheirDefault)
{
  const test::ScratchFolder scratch;
  const std::string all = scratch.write("all.prm", commented_defaults());
  EXPECT_EQ(unused_entries(entries_of(read_study(all))), Names());
  EXPECT_EQ(unused_entries(entries_of(read_study(all, { "Table/Foundation modulus=1e10" }))),
            Names({ "Table/Foundation modulus" }));
  Study study;
  study.table.foundation_modulus = 2e10;
  EXPECT_EQ(unused_entries(entries_of(read_study(scratch.write("changed.prm", study_as_prm(study))))),
            Names({ "Table/Foundation modulus" }));
  EXPECT_EQ(unused_entries(entries_of(
              read_study(scratch.write("one.json", R"({"Table": {"Foundation modulus": 1e10}})")))),
            Names({ "Table/Foundation modulus" }));
}

TEST(UnusedEntries, AreNotGivenInAnyCookbook)
{
  unsigned int n_studies = 0;
  for (const auto &item : std::filesystem::directory_iterator(STEMWARE_COOKBOOKS))
    if (item.path().extension() == ".prm")
    {
      EXPECT_EQ(unused_entries(entries_of(read_study(item.path()))), Names()) << item.path();
      ++n_studies;
    }
  EXPECT_GE(n_studies, 9u);
}

} // namespace
} // namespace stemware::pipeline
