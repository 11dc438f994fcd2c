#include "fem/pipeline/base/failures.h"
#include "fem/pipeline/study/presets.h"
#include "fem/pipeline/study/study_checks.h"
#include "fem/pipeline/study/study_file.h"
#include "tests/fem/pipeline/matchers.h"
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

#include <regex>

namespace stemware::test
{
namespace
{

using pipeline::glass_presets;
using pipeline::Preset;
using pipeline::table_presets;

/// Returns the number of lines "set ..." with and without a preceding comment.
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

TEST(NewStudy, WritesTheDefaultStudyInTwelveCommentedEntries)
{
  const ScratchFolder scratch;
  const Ended ended = stemware(scratch, { "new", "my_glass.prm" });
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_THAT(ended.out, testing::HasSubstr("stemware run my_glass.prm"));
  EXPECT_EQ(count_entries(read_text(scratch / "my_glass.prm")), std::pair(12u, 0u));
  EXPECT_EQ(pipeline::study_as_json(pipeline::entries_of(pipeline::read_study(scratch / "my_glass.prm"))),
            pipeline::study_as_json(pipeline::entries_of(pipeline::Study())));
}

TEST(NewStudy, EveryPairOfPresetsIsAPlausibleStudy)
{
  const ScratchFolder scratch;
  for (const Preset &glass : glass_presets())
    for (const Preset &table : table_presets())
    {
      const std::string text = pipeline::new_study_text(glass, table, "a.prm");
      EXPECT_EQ(count_entries(text).first, 12u) << text;
      scratch.write("a.prm", text);
      const pipeline::Study study = pipeline::read_study(scratch / "a.prm");
      EXPECT_EQ(pipeline::unused_entries(pipeline::entries_of(study)), std::vector<std::string>()) << text;
      EXPECT_EQ(pipeline::implausible_notes(pipeline::entries_of(study)), std::vector<std::string>()) << text;
      EXPECT_NO_THROW(study.required_resultants());
    }
}

TEST(NewStudy, AcceptsPresetNamesInAnyCaseAndWithHyphens)
{
  EXPECT_EQ(pipeline::preset_of(table_presets(), "--table", "Cork-Mat").name, "cork mat");
  EXPECT_EQ(pipeline::preset_of(glass_presets(), "--glass", "bordeaux").name, "Bordeaux");
}

TEST(NewCookbook, CopiesTheStudyWithItsFiles)
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
    for (const auto &[path, text] : pipeline::cookbook_parts(name, scratch / (name + ".prm")))
      scratch.write(path.filename(), text);
    EXPECT_EQ(as_text(scratch.path(), name), as_text(source, name)) << name;
    for (const std::string &file :
         pipeline::files_of(pipeline::entries_of(pipeline::read_study(scratch / (name + ".prm")))))
    {
      const std::filesystem::path written = file;
      EXPECT_EQ(written.parent_path(), scratch.path()) << file;
      EXPECT_GT(std::filesystem::file_size(written), 100u) << file;
    }
  }
}

TEST(NewCookbook, AcceptsAnotherNameAndFolder)
{
  const ScratchFolder scratch;
  std::filesystem::create_directory(scratch / "mine");
  const Ended ended = stemware(scratch, { "new", "mine/drawn.prm", "--cookbook", "own_profile" });
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_THAT(read_text(scratch / "mine/drawn.prm"), testing::HasSubstr("#   stemware run drawn.prm\n"));
  EXPECT_EQ(stemware(scratch, { "mesh", "mine/drawn.prm" }).exit_code, 0);
}

} // namespace
} // namespace stemware::test
