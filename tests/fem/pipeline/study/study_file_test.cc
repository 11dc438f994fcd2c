#include "fem/pipeline/base/failures.h"
#include "fem/pipeline/study/study_entries.h"
#include "fem/pipeline/study/study_file.h"
#include "tests/fem/pipeline/matchers.h"
#include "tests/fem/pipeline/program_runner.h"
#include "tests/fem/pipeline/refusal.h"

#include <gtest/gtest.h>

namespace stemware::pipeline
{
namespace
{

using test::ScratchFolder;

std::string study_refusal(const std::string &file, const std::vector<std::string> &overrides = {})
{
  return test::sentence_of([&] { read_study(file, overrides); });
}

TEST(StudyFile, WrittenStudyIsReadIdentically)
{
  const ScratchFolder scratch;
  const std::string file = scratch.write("first.prm", "# defaults\n");
  const Study study = read_study(file, { "Glass/Contact radius=0.0301234567890123", "Motion/Closure=hand",
                                         "Load/Source=first harmonic", "Motion/Orbit sense=clockwise",
                                         "Contact/Azimuthal cells=12", "Load/Moment ratio=0.3" });
  const Study again = read_study(scratch.write("echo.prm", study_as_prm(study)));
  EXPECT_EQ(study_as_json(entries_of(again)), study_as_json(entries_of(study)));
  EXPECT_EQ(study_as_json(entries_of(study))["Glass"]["Contact radius"], 0.0301234567890123);
  EXPECT_EQ(study_as_json(entries_of(study))["Load"]["Source"], "first harmonic");
}

TEST(StudyFile, CommentedDefaultsAreReadAsTheDefaultStudy)
{
  const ScratchFolder scratch;
  const Study study = read_study(scratch.write("defaults.prm", commented_defaults()));
  EXPECT_EQ(study_as_json(entries_of(study)), study_as_json(entries_of(Study())));
}

TEST(StudyFile, HandHeightIsKeptUnlessTheForceOffsetIsGiven)
{
  const ScratchFolder scratch;
  const auto hand_of = [](const std::string &file, const std::vector<std::string> &overrides)
  {
    const Study study = read_study(file, overrides);
    return std::pair(study.motion.hand_height, study.motion.orbit.force_offset);
  };
  const std::string centre = "Motion/Centre of mass height=0.25";
  const std::string offset = scratch.write("offset.prm", "set Force offset = -0.0625\n");
  for (const std::vector<std::string> &order :
       { std::vector<std::string>{ centre, "Motion/Hand height=0.125" },
         { "Motion/Hand height=0.125", centre } })
    EXPECT_EQ(hand_of(offset, order), std::pair(0.125, -0.125));
  EXPECT_EQ(hand_of("", { centre }), std::pair(0.03, 0.03 - 0.25));
  EXPECT_EQ(hand_of(offset, { centre }), std::pair(0.1875, -0.0625));
  EXPECT_EQ(hand_of("", { "Motion/Force offset=-0.0625", centre }), std::pair(0.1875, -0.0625));
  // A file with all entries contains both force offset and hand height. A changed centre of mass keeps the
  // hand height.
  const std::string all = scratch.write("all.prm", study_as_prm(read_study(offset, { centre })));
  EXPECT_EQ(hand_of(all, {}), std::pair(0.1875, -0.0625));
  EXPECT_EQ(hand_of(all, { "Motion/Centre of mass height=0.5" }), std::pair(0.1875, -0.3125));
  EXPECT_EQ(hand_of(all, { "Motion/Force offset=-0.125" }), std::pair(0.125, -0.125));
  const Study lower = with_values(read_study(all), "the test", { { "Motion/Hand height", "0.0625" } });
  EXPECT_EQ(lower.motion.orbit.force_offset, -0.1875);
}

TEST(StudyFile, JsonAndPrmGiveTheSameStudy)
{
  const ScratchFolder scratch;
  const Study prm = read_study(scratch.write("a.prm", "subsection Table\n  set Interface = hard\nend\n"
                                                      "subsection Contact\n  set Degree = 1\nend\n"));
  const Study json =
    read_study(scratch.write("a.json", R"({"Table": {"Interface": "hard"}, "Contact": {"Degree": 1}})"));
  EXPECT_EQ(study_as_json(entries_of(json)), study_as_json(entries_of(prm)));
}

TEST(StudyFile, OverridesReplaceFileValuesAndMayNotRepeat)
{
  const ScratchFolder scratch;
  const std::string file = scratch.write("a.prm", "subsection Motion\n  set Mass = 0.2\nend\n");
  EXPECT_EQ(read_study(file).motion.orbit.mass, 0.2);
  EXPECT_EQ(read_study(file, { "Motion/Mass=0.5" }).motion.orbit.mass, 0.5);
  EXPECT_THROW(read_study(file, { "Motion/Mass=0.4", "Motion/Mass=0.5" }), BadInput);
}

TEST(StudyFile, PathEntriesEndInFileAndAreRelativeToTheStudyFile)
{
  const ScratchFolder scratch;
  for (const char *folder : { "meshes", "studies", "results" })
    std::filesystem::create_directory(scratch / folder);
  const std::string mesh = scratch.write("meshes/foot.msh", "a mesh");
  const std::string text =
    "subsection Table\n  set Substrate = rigid\nend\n"
    "subsection Contact\n  set Body = solid\n  set Mesh file = ../meshes/foot.msh\nend\n";
  const std::string file = scratch.write("studies/a.prm", text);
  const Study study = read_study(file);
  EXPECT_EQ(study.contact.mesh_file, mesh);
  EXPECT_EQ(study.load.file, "");
  EXPECT_EQ(with_paths_from(scratch / "results", study).contact.mesh_file, "../meshes/foot.msh");
  // On the command line, paths are relative to the working directory.
  EXPECT_EQ(read_study(file, { "Contact/Mesh file=" + mesh }).contact.mesh_file, mesh);
  EXPECT_NE(study_refusal(file, { "Contact/Mesh file=../meshes/foot.msh" }), "");
  // An entry is a path if and only if its name ends in "file" or "File".
  Study any;
  for (const StudyEntry &entry : study_entries(any))
    EXPECT_EQ(entry.name.rfind("ile") + 3 == entry.name.size(), entry.path_value != nullptr) << entry.path();
}

TEST(StudyFile, SuggestsEntriesForCommonSymbolsAndWords)
{
  for (const auto &[word, meant] : {
         std::pair("Glass/E", "Glass/Young modulus"),
         std::pair("Table/E", "Table/Disc Young modulus"),
         std::pair("E", "Glass/Young modulus"),
         std::pair("Motion/\u03bc", "Motion/Friction coefficient"),
         std::pair("Glass/R", "Glass/Contact radius"),
         std::pair("Motion/R", "Motion/Orbit radius"),
         std::pair("motion/I", "Motion/Yaw inertia"),
         std::pair("Table/Roughness", "Table/Decay length"),
       })
    EXPECT_THAT(study_refusal("", { std::string(word) + "=1" }),
                testing::HasSubstr("did you mean " + std::string(meant) + "?"))
      << word;
}

TEST(StudyFile, SuggestsExistingEntriesOnly)
{
  for (const char *word :
       { "E",     "nu", "mu", "mu_k", "mu_s", "v_s", "c", "R",   "m",  "g", "v",        "rho",
         "rho_c", "z",  "h",  "hand", "dz",   "I",   "k", "p_0", "p0", "l", "Thickness" })
    for (const char *section : { "", "Motion/", "Glass/", "Table/" })
    {
      const std::string sentence = study_refusal("", { section + std::string(word) + "=1" }),
                        question = "did you mean ";
      const std::size_t begin = sentence.find(question) + question.size();
      EXPECT_NO_THROW(find_entry("", sentence.substr(begin, sentence.find('?') - begin))) << sentence;
    }
}

TEST(StudyFile, AcceptsAnEntryWithoutItsSectionUnlessItIsRepeatedOrInvalid)
{
  const ScratchFolder scratch;
  EXPECT_EQ(read_study("", { "Mass=250 g" }).motion.orbit.mass, 0.25);
  EXPECT_EQ(read_study(scratch.write("a.prm", "set Mass = 250 g\n")).motion.orbit.mass, 0.25);
  EXPECT_THAT(study_refusal("", { "Mass=250 g", "Motion/Mass=0.3" }), testing::HasSubstr("twice"));
  const std::string twice = "set Mass = 250 g\nsubsection Motion\n  set Mass = 0.3\nend\n";
  EXPECT_THAT(study_refusal(scratch.write("b.prm", twice)),
              testing::HasSubstr("a second time, after line 1"));
  EXPECT_THAT(study_refusal("", { "Coupling=frozen" }), testing::HasSubstr("give two-way or one-way"));
  EXPECT_THAT(study_refusal("", { "Mas=1" }), testing::HasSubstr("did you mean Motion/Mass?"));
}

TEST(StudyFile, RefusalOfQuotesAndBlanksGivesAHint)
{
  for (const char *value : { "\"300 g\"", "'300 g'", "\u201c300 g\u201d" })
    EXPECT_THAT(study_refusal("", { "Motion/Mass=" + std::string(value) }), testing::HasSubstr("quotes"))
      << value;
  EXPECT_THAT(study_refusal("", { "Glass/Young modulus=70\u2009000\u2009000\u2009000" }),
              testing::HasSubstr("blanks between its digits"));
}

TEST(StudyFile, ReadsContinuedLinesAndRepeatedSections)
{
  const ScratchFolder scratch;
  const std::string file = scratch.write("a.prm", "# a comment\n"
                                                  "subsection Glass # another\r\n"
                                                  "\tset Contact radius= 0.0\\\n"
                                                  "      31   # m\n"
                                                  "end\n\n"
                                                  "SUBSECTION Motion\n  SET Mass =0.4\nEND\n"
                                                  "subsection Glass\n  set Rim waviness = 2: 1e-6, \\\n"
                                                  "                     3: 2e-6\nend");
  const Study study = read_study(file);
  EXPECT_EQ(study.glass.profile.contact_radius, 0.031);
  EXPECT_EQ(study.motion.orbit.mass, 0.4);
  EXPECT_EQ(waviness_text(study.glass.waviness), "2: 1e-6, 3: 2e-6");
}

TEST(StudyFile, NamesTheLineOfAnError)
{
  const ScratchFolder scratch;
  for (const auto &[text, line, entry] :
       { std::tuple("subsection Glass\n  set Contact radius = 0.03\nend\nsubsection Glass\n"
                    "  set Contact radius = 0.04\nend\n",
                    5, "Glass/Contact radius"),
         std::tuple("subsection Glass\n  set Foot \\\n    radius = 0.03\n  set Foot radius = x\nend\n", 4,
                    "Glass/Foot radius"),
         std::tuple("subsection Glass\n\n  set Foot \\\n    radius = x\nend\n", 3, "Glass/Foot radius = x"),
         std::tuple("\nsubsection Glass\n  set Contact radius = 0.03\n", 2, "Glass"),
         std::tuple("subsection Glass\nsubsection Table\nend\n", 2, "Glass"),
         std::tuple("include other.prm\n", 1, "include other.prm"),
         std::tuple("subsection Table\n  set Contact radius = 0.03\nend\n", 2, "Glass/Contact radius?") })
  {
    const std::string file = scratch.write("a.prm", text), sentence = study_refusal(file);
    EXPECT_EQ(sentence.find(file + ", line " + std::to_string(line) + ": "), 0u) << sentence;
    EXPECT_THAT(sentence, testing::HasSubstr(entry));
  }
}

} // namespace
} // namespace stemware::pipeline
