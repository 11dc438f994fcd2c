// `stemware new`: twelve entries with a comment each, ready to run; nothing is overwritten; every preset
// gives a result.
#include "fem/pipeline/study/presets.h"
#include "fem/pipeline/study/study_checks.h"
#include "fem/pipeline/study/study_file.h"
#include "fem/pipeline/support/failures.h"
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

#include <cmath>
#include <regex>

namespace stemware::test
{
namespace
{

using pipeline::glass_presets;
using pipeline::Preset;
using pipeline::table_presets;

/// Lines "set ..." that follow a comment, and those that do not.
std::pair<unsigned int, unsigned int> count_entries(const std::string &text)
{
  std::pair<unsigned int, unsigned int> n;
  std::istringstream lines(text);
  bool is_explained = false;
  for (std::string line; std::getline(lines, line);)
  {
    if (line.rfind("  set ", 0) == 0)
      ++(is_explained ? n.first : n.second);
    is_explained = line.rfind("  # ", 0) == 0;
  }
  return n;
}

TEST(NewStudy, IsTheDefaultStudyInTwelveCommentedEntries)
{
  const ScratchFolder scratch;
  const Ended ended = stemware(scratch, { "new", "my_glass.prm" });
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_NE(ended.out.find("stemware run my_glass.prm"), std::string::npos);
  EXPECT_EQ(count_entries(read_text(scratch / "my_glass.prm")), std::pair(12u, 0u));
  EXPECT_EQ(pipeline::study_as_json(pipeline::read_study(scratch / "my_glass.prm")),
            pipeline::study_as_json(pipeline::Study()));
}

TEST(NewStudy, OverwritesNothing)
{
  const ScratchFolder scratch;
  scratch.write("mine.prm", "# mine\n");
  const Ended ended = stemware(scratch, { "new", "mine.prm" });
  EXPECT_EQ(ended.exit_code, 3);
  EXPECT_NE(ended.err.find("is not overwritten"), std::string::npos) << ended.err;
  EXPECT_EQ(read_text(scratch / "mine.prm"), "# mine\n");
}

TEST(NewStudy, EveryPairOfPresetsIsAStudyWithoutIdleOrStrangeEntries)
{
  const ScratchFolder scratch;
  for (const Preset &glass : glass_presets())
    for (const Preset &table : table_presets())
    {
      const std::string text = pipeline::new_study_text(glass, table, "a.prm");
      EXPECT_EQ(count_entries(text).first, 12u) << text;
      scratch.write("a.prm", text);
      const pipeline::Study study = pipeline::read_study(scratch / "a.prm");
      EXPECT_EQ(pipeline::idle_entries(study), std::vector<std::string>()) << text;
      EXPECT_EQ(pipeline::implausible_notes(study), std::vector<std::string>()) << text;
      EXPECT_NO_THROW(study.required_resultants());
    }
}

TEST(NewStudy, NamesAreTakenInAnyCaseAndWithHyphens)
{
  EXPECT_EQ(pipeline::preset_of(table_presets(), "--table", "Cork-Mat").name, "cork mat");
  EXPECT_EQ(pipeline::preset_of(glass_presets(), "--glass", "bordeaux").name, "Bordeaux");
}

TEST(NewStudy, OtherNamesOfPresetsAreGuessed)
{
  const auto refusal = [](const std::vector<Preset> &presets, const std::string &name) -> std::string
  {
    try
    {
      return pipeline::preset_of(presets, "--preset", name).name;
    }
    catch (const pipeline::BadInput &error)
    {
      return error.what();
    }
  };
  for (const auto &[name, meant] : { std::pair("wineglass", "wine glass"), std::pair("glass", "wine glass"),
                                     std::pair("flute", "champagne"), std::pair("bordaux", "Bordeaux") })
    EXPECT_NE(refusal(glass_presets(), name).find("did you mean \"" + std::string(meant) + "\"?"),
              std::string::npos)
      << refusal(glass_presets(), name);
  for (const auto &[name, meant] :
       { std::pair("wood", "oak"), std::pair("felt", "tablecloth"), std::pair("glass", "window glass"),
         std::pair("cork", "cork mat"), std::pair("marbel", "marble") })
    EXPECT_NE(refusal(table_presets(), name).find("did you mean \"" + std::string(meant) + "\"?"),
              std::string::npos)
      << refusal(table_presets(), name);
  EXPECT_EQ(refusal(table_presets(), "a bed of nails").find("did you mean"), std::string::npos);
}

TEST(NewCookbook, IsTheCookbooksStudyWithTheFilesThatItReads)
{
  const std::filesystem::path source = STEMWARE_COOKBOOKS;
  std::vector<std::string> names;
  for (const std::string &file : names_in(source))
    if (std::filesystem::path(file).extension() == ".prm")
      names.push_back(std::filesystem::path(file).stem());
  ASSERT_EQ(pipeline::cookbook_names(), names);
  const auto as_text = [](const std::filesystem::path &folder, const std::string &name)
  {
    const pipeline::Study study = pipeline::read_study(folder / (name + ".prm"));
    const std::string text = pipeline::study_as_prm(pipeline::with_paths_from(folder, study));
    return std::regex_replace(text, std::regex("\\.\\./\\.\\./meshes/"), "");
  };
  for (const std::string &name : names)
  {
    const ScratchFolder scratch;
    const Ended ended = stemware(scratch, { "new", "--cookbook", name });
    ASSERT_EQ(ended.exit_code, 0) << ended.err;
    EXPECT_NE(ended.out.find("stemware run " + name + ".prm"), std::string::npos) << ended.out;
    EXPECT_EQ(as_text(scratch.path(), name), as_text(source, name)) << name;
    for (const std::string &file : pipeline::files_of(pipeline::read_study(scratch / (name + ".prm"))))
    {
      const std::filesystem::path written = file;
      EXPECT_EQ(written.parent_path(), scratch.path()) << file;
      EXPECT_NE(ended.out.find(written.filename()), std::string::npos) << ended.out;
      EXPECT_GT(std::filesystem::file_size(written), 100u) << file;
    }
  }
}

TEST(NewCookbook, MayHaveAnotherNameAndPlace)
{
  const ScratchFolder scratch;
  std::filesystem::create_directory(scratch / "mine");
  const Ended ended = stemware(scratch, { "new", "mine/drawn.prm", "--cookbook", "own_profile" });
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_NE(read_text(scratch / "mine/drawn.prm").find("#   stemware run drawn.prm\n"), std::string::npos);
  EXPECT_EQ(stemware(scratch, { "mesh", "mine/drawn.prm" }).exit_code, 0);
}

TEST(NewCookbook, NothingIsWrittenWhereAFileIsInTheWay)
{
  const ScratchFolder scratch;
  scratch.write("own_profile.csv", "mine\n");
  const Ended ended = stemware(scratch, { "new", "--cookbook", "own_profile" });
  EXPECT_EQ(ended.exit_code, 3);
  EXPECT_NE(ended.err.find("own_profile.csv exists"), std::string::npos) << ended.err;
  EXPECT_EQ(names_in(scratch.path()), std::vector<std::string>{ "own_profile.csv" });
}

TEST(NewCookbook, IsNamedWhereItIsLookedForInVain)
{
  const ScratchFolder scratch;
  const auto refusal = [&](const std::vector<std::string> &arguments)
  {
    const Ended ended = stemware(scratch, arguments);
    EXPECT_EQ(ended.exit_code, 1);
    return ended.err;
  };
  EXPECT_NE(refusal({ "new", "--cookbook", "liftoff" }).find("did you mean lift_off? There are bare_wood, "),
            std::string::npos);
  EXPECT_NE(refusal({ "run", "docs/cookbooks/lift_off.prm" }).find("`stemware new --cookbook lift_off`"),
            std::string::npos);
  EXPECT_NE(refusal({ "new", "--cookbook", "paper", "--glass", "Bordeaux" }).find("--glass"),
            std::string::npos);
  EXPECT_NE(refusal({ "new" }).find("FILE is required"), std::string::npos);
  EXPECT_NE(stemware(scratch, { "new", "--help" }).out.find("Cookbooks:\n  bare_wood, "), std::string::npos);
}

TEST(NewStudy, HasNoLineEndInItsName)
{
  const ScratchFolder scratch;
  for (const std::vector<std::string> &kind : { std::vector<std::string>(), { "--cookbook", "paper" } })
  {
    std::vector<std::string> arguments = { "new", "x\nset Foo = 1.prm" };
    arguments.insert(arguments.end(), kind.begin(), kind.end());
    const Ended ended = stemware(scratch, arguments);
    EXPECT_EQ(ended.exit_code, 1);
    EXPECT_NE(ended.err.find("line end"), std::string::npos) << ended.err;
  }
  EXPECT_TRUE(names_in(scratch.path()).empty());
}

class PresetPair : public testing::TestWithParam<std::pair<std::string, std::string>>
{
};

TEST_P(PresetPair, GivesAResultWithThreeLinesChanged)
{
  const ScratchFolder scratch;
  const auto &[glass, table] = GetParam();
  ASSERT_EQ(stemware(scratch, { "new", "my.prm", "--glass", glass, "--table", table }).exit_code, 0);
  std::string text = read_text(scratch / "my.prm");
  for (const auto &[entry, value] : { std::pair("Mass ", "280 g"), std::pair("Orbit speed ", "30 cm/s"),
                                      std::pair("Friction coefficient ", "0.28") })
    text = std::regex_replace(text, std::regex("(set " + std::string(entry) + "\\s*= ).*"),
                              "$01" + std::string(value));
  scratch.write("my.prm", text);
  const Ended ended = stemware(scratch, { "run", "my.prm", "--quick", "--output", "results" });
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  const auto summary = read_summary(scratch / "results");
  EXPECT_EQ(summary["parameters"]["Motion"]["Mass"], 0.28);
  EXPECT_EQ(summary["parameters"]["Motion"]["Orbit speed"], 0.3);
  EXPECT_EQ(summary["parameters"]["Motion"]["Friction coefficient"], 0.28);
  // Against the orbit, and not faster than the rim could roll along the table.
  const double omega = summary["ring"]["omega_terminal"];
  const double radius = summary["parameters"]["Glass"]["Contact radius"];
  EXPECT_LT(omega, 0);
  EXPECT_GT(omega, -0.3 / radius);
}

std::vector<std::pair<std::string, std::string>> preset_pairs()
{
  std::vector<std::pair<std::string, std::string>> pairs;
  for (const Preset &glass : glass_presets())
    pairs.emplace_back(glass.name, "mat");
  for (const Preset &table : table_presets())
    if (table.name != "mat")
      pairs.emplace_back("wine glass", table.name);
  return pairs;
}

INSTANTIATE_TEST_SUITE_P(All, PresetPair, testing::ValuesIn(preset_pairs()),
                         [](const auto &info)
                         {
                           std::string name = info.param.first + "_on_" + info.param.second;
                           std::replace(name.begin(), name.end(), ' ', '_');
                           return name;
                         });

} // namespace
} // namespace stemware::test
