// What a study is told that it cannot use: entries without effect are named, words of version 0.1 refused.
#include "fem/pipeline/study/study_checks.h"
#include "fem/pipeline/study/study_file.h"
#include "fem/pipeline/support/failures.h"
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

namespace stemware::pipeline
{
namespace
{

using Settings = std::vector<std::pair<std::string, std::string>>;
using Names = std::vector<std::string>;

Names idle_with(const Settings &settings)
{
  return idle_entries(with_values(Study(), "the test", settings));
}

std::string refusal_of(const std::string &file, const std::vector<std::string> &overrides = {})
{
  try
  {
    read_study(file, overrides);
    return "";
  }
  catch (const BadInput &error)
  {
    return error.what();
  }
}

TEST(IdleEntries, OfTheDefaultStudyThereAreNone)
{
  EXPECT_EQ(idle_with({}), Names());
  EXPECT_EQ(idle_with({ { "Motion/Tilt", "neglected" },
                        { "Motion/Centre of mass height", "0.07" },
                        { "Motion/Grip torque", "0" },
                        { "Table/Foundation modulus", "1e9" },
                        { "Glass/Edge thickness", "0.002" },
                        { "Contact/Land grading", "2" },
                        { "Load/Coupling", "one-way" } }),
            Names());
}

TEST(IdleEntries, OfTheTableFollowInterfaceAndSubstrate)
{
  const Settings all = { { "Table/Foundation modulus", "1e9" }, { "Table/Layer thickness", "0.005" },
                         { "Table/Reference pressure", "2e9" }, { "Table/Decay length", "2e-6" },
                         { "Table/Disc radius", "0.1" },        { "Table/Disc thickness", "0.02" },
                         { "Table/Disc Young modulus", "5e9" }, { "Table/Disc Poisson ratio", "0.2" } };
  const Names winkler = { "Table/Foundation modulus", "Table/Layer thickness" };
  const Names rough = { "Table/Reference pressure", "Table/Decay length" };
  const Names disc = { "Table/Disc radius", "Table/Disc thickness", "Table/Disc Young modulus",
                       "Table/Disc Poisson ratio" };
  const auto idle_on = [&](const std::string &interface, const std::string &substrate)
  {
    Settings settings = all;
    settings.emplace_back("Table/Interface", interface);
    settings.emplace_back("Table/Substrate", substrate);
    return idle_with(settings);
  };
  const auto joined = [](const std::vector<Names> &parts)
  {
    Names names;
    for (const Names &part : parts)
      names.insert(names.end(), part.begin(), part.end());
    return names;
  };
  EXPECT_EQ(idle_on("hard", "rigid"), joined({ winkler, rough, disc }));
  EXPECT_EQ(idle_on("hard", "elastic"), joined({ winkler, rough }));
  EXPECT_EQ(idle_on("Winkler", "rigid"), joined({ rough, disc }));
  EXPECT_EQ(idle_on("rough", "elastic"), winkler);
}

TEST(IdleEntries, OfMotionAndLoadFollowTheMomentBalance)
{
  EXPECT_EQ(idle_with({ { "Motion/Closure", "paper" },
                        { "Motion/Tilt", "included" },
                        { "Motion/Centre of mass height", "0.07" } }),
            Names({ "Motion/Centre of mass height", "Motion/Tilt" }));
  EXPECT_EQ(idle_with({ { "Load/Moment ratio", "0.5" },
                        { "Load/Moment direction", "0" },
                        { "Load/Coupling", "two-way" },
                        { "Motion/Closure", "full" },
                        { "Motion/Tilt", "included" } }),
            Names({ "Motion/Closure", "Motion/Tilt", "Load/Coupling" }));
  EXPECT_EQ(idle_with({ { "Load/Moment direction", "0" } }), Names({ "Load/Moment direction" }));
}

TEST(IdleEntries, OfTheBodyFollowItsKind)
{
  const Settings both = { { "Contact/Azimuthal cells", "24" },
                          { "Contact/Foot layers", "1" },
                          { "Contact/Linear solver", "direct" },
                          { "Contact/Radial cells", "2" },
                          { "Contact/Refinements", "1" },
                          { "Contact/Land grading", "2" },
                          { "Contact/Harmonics", "8" },
                          { "Contact/Azimuth lines", "64" },
                          { "Contact/Friction coupling", "elastic" } };
  EXPECT_EQ(idle_with(both),
            Names({ "Contact/Azimuthal cells", "Contact/Foot layers", "Contact/Linear solver" }));
  Settings solid = both;
  solid.emplace_back("Contact/Body", "solid");
  EXPECT_EQ(idle_with(solid),
            Names({ "Contact/Land grading", "Contact/Harmonics", "Contact/Azimuth lines" }));
  EXPECT_EQ(idle_with({ { "Contact/Mesh contact id", "2" }, { "Contact/Mesh contact height", "0" } }),
            Names({ "Contact/Mesh contact id", "Contact/Mesh contact height" }));
  EXPECT_EQ(idle_with({ { "Contact/Body", "solid" },
                        { "Contact/Mesh file", STEMWARE_MESHES "/oval_foot.msh" },
                        { "Contact/Radial cells", "2" },
                        { "Glass/Stem height", "0.02" },
                        { "Glass/Crown radius", "0.002" } }),
            Names({ "Glass/Stem height", "Contact/Radial cells" }));
  EXPECT_EQ(idle_with({ { "Glass/Crown radius", "0" }, { "Contact/Land grading", "2" } }),
            Names({ "Contact/Land grading" }));
  EXPECT_EQ(idle_with({ { "Glass/Shape", "step" }, { "Glass/Fillet radius", "0.002" } }),
            Names({ "Glass/Fillet radius" }));
}

TEST(IdleEntries, WithoutAContactOnlyTheRadiusOfTheRimIsLeft)
{
  EXPECT_EQ(
    idle_with({ { "Load/Source", "first harmonic" },
                { "Glass/Contact radius", "0.031" },
                { "Glass/Young modulus", "5e10" },
                { "Table/Interface", "hard" },
                { "Contact/Rings", "3" },
                { "Motion/Tilt", "included" },
                { "Motion/Centre of mass height", "0.07" },
                { "Load/Coupling", "two-way" } }),
    Names({ "Motion/Tilt", "Glass/Young modulus", "Table/Interface", "Contact/Rings", "Load/Coupling" }));
}

TEST(IdleEntries, AFileOfAllEntriesGivesThoseThatDifferFromTheirDefaults)
{
  const test::ScratchFolder scratch;
  const std::string all = scratch.write("all.prm", commented_defaults());
  EXPECT_EQ(idle_entries(read_study(all)), Names());
  EXPECT_EQ(idle_entries(read_study(all, { "Table/Disc radius=0.15" })), Names({ "Table/Disc radius" }));
  Study study;
  study.table.disc.thickness = 0.01;
  EXPECT_EQ(idle_entries(read_study(scratch.write("changed.prm", study_as_prm(study)))),
            Names({ "Table/Disc thickness" }));
  EXPECT_EQ(idle_entries(read_study(scratch.write("one.json", R"({"Table": {"Disc thickness": 0.05}})"))),
            Names({ "Table/Disc thickness" }));
}

TEST(IdleEntries, ThereAreNoneInTheCookbooks)
{
  unsigned int n_studies = 0;
  for (const auto &item : std::filesystem::directory_iterator(STEMWARE_COOKBOOKS))
    if (item.path().extension() == ".prm")
    {
      EXPECT_EQ(idle_entries(read_study(item.path())), Names()) << item.path();
      ++n_studies;
    }
  EXPECT_GE(n_studies, 9u);
}

TEST(IdleEntries, AreNamedInOneSentence)
{
  EXPECT_EQ(idle_note({}), "");
  EXPECT_EQ(idle_note({ "Motion/Tilt" }), "Motion/Tilt has no effect in this study.");
  EXPECT_EQ(idle_note({ "Motion/Tilt", "Table/Disc radius" }),
            "Motion/Tilt, Table/Disc radius have no effect in this study.");
}

TEST(RenamedEntries, AreRefusedWithTheNewWordsWhereverTheyStand)
{
  const test::ScratchFolder scratch;
  const std::string empty = scratch.write("empty.prm", "# nothing\n");
  const auto expect_refusal = [&](const std::string &section, const std::string &name,
                                  const std::string &value, const std::string &trouble)
  {
    const std::string sentence = section + '/' + name + " = " + value + " is " + trouble;
    EXPECT_EQ(refusal_of(empty, { section + '/' + name + '=' + value }), "--set: " + sentence);
    // First in a file: what is wrong after it is not looked at.
    const std::string prm = scratch.write("a.prm", "subsection " + section + "\n  set " + name + " = " +
                                                     value + "\n  set Foo = 1\nend\n");
    EXPECT_EQ(refusal_of(prm), prm + ", line 2: " + sentence);
    const std::string json =
      scratch.write("a.json", "{\"" + section + "\": {\"" + name + "\": \"" + value + "\"}}");
    EXPECT_EQ(refusal_of(json), json + ": " + sentence);
    EXPECT_THROW(with_values(Study(), "--vary", { { section + '/' + name, value } }), BadInput);
  };
  const std::string old_entry = "an entry of version 0.1; ", old_value = "a value of version 0.1; ";
  expect_refusal("Table", "Kind", "rigid",
                 old_entry + "write Table/Interface = hard, Table/Substrate = rigid.");
  expect_refusal("Table", "Kind", "mat",
                 old_entry + "write Table/Interface = Winkler, Table/Substrate = rigid.");
  expect_refusal("Table", "Kind", "rough",
                 old_entry + "write Table/Interface = rough, Table/Substrate = rigid.");
  expect_refusal("Table", "Kind", "elastic",
                 old_entry + "write Table/Interface = hard, Table/Substrate = elastic.");
  expect_refusal("Table", "Kind", "stone",
                 old_entry + "write Table/Interface = hard, Winkler or rough, and Table/Substrate = rigid or "
                             "elastic.");
  expect_refusal("Contact", "Friction coupling", "automatic",
                 old_value + "write Contact/Friction coupling = elastic.");
  expect_refusal("Load", "Coupling", "frozen", old_value + "write Load/Coupling = one-way.");
  expect_refusal("Load", "Coupling", "response", old_value + "write Load/Coupling = two-way.");
  expect_refusal("Load", "Coupling", "exact", old_value + "write Load/Coupling = two-way.");
  expect_refusal("Load", "Response tolerance", "1e-6",
                 old_entry + "leave it out: with Load/Coupling = two-way the contact is solved in balance at "
                             "every spin.");
  expect_refusal("Contact", "Checkpoint folder", "state",
                 "an entry of version 0.3; a contact takes seconds to a minute: leave the entry out.");
}

TEST(RenamedEntries, TheNewWordsAreTaken)
{
  for (const char *interface : { "hard", "Winkler", "rough", "winkler" })
    for (const char *substrate : { "rigid", "elastic" })
    {
      const Study study = with_values(Study(), "the test",
                                      { { "Table/Interface", interface }, { "Table/Substrate", substrate } });
      EXPECT_EQ(study.table.is_hard(), interface == std::string("hard"));
      EXPECT_EQ(study.table.make().substrate.has_value(), substrate == std::string("elastic"));
    }
}

TEST(RenamedEntries, AnEntryAloneIsRefusedToo)
{
  try
  {
    find_entry("--vary", "Table/Kind");
    FAIL() << "not refused";
  }
  catch (const BadInput &error)
  {
    EXPECT_STREQ(error.what(), "--vary: Table/Kind is an entry of version 0.1; write Table/Interface = hard, "
                               "Winkler or rough, and Table/Substrate = rigid or elastic.");
  }
  EXPECT_EQ(find_entry("--vary", "Load/Coupling").name, "Coupling");
}

} // namespace
} // namespace stemware::pipeline
