#include "fem/pipeline/study/study_entries.h"
#include "fem/pipeline/study/study_file.h"
#include "fem/pipeline/support/failures.h"
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

namespace stemware::pipeline
{
namespace
{

using test::ScratchFolder;

/// Sentence with which a study is refused; empty when it is not.
std::string refusal(const std::string &file, const std::vector<std::string> &overrides = {})
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

// An entry that is added later states its default once, in its declaration.
TEST(StudyFile, DefaultsAreThoseThatOtherToolsRelyOn)
{
  const std::map<std::string, std::string> expected = {
    { "Motion/Mass", "0.3" },
    { "Motion/Yaw inertia", "3e-4" },
    { "Motion/Centre of mass height", "0.08" },
    { "Motion/Force offset", "-0.05" },
    { "Motion/Orbit radius", "0.15" },
    { "Motion/Orbit speed", "0.35" },
    { "Motion/Orbit sense", "counterclockwise" },
    { "Motion/Orbit speed file", "" },
    { "Motion/Measured spin file", "" },
    { "Motion/Friction coefficient", "0.3" },
    { "Motion/Friction law", "Coulomb" },
    { "Motion/Static friction coefficient", "0.4" },
    { "Motion/Friction decay speed", "0.1" },
    { "Motion/Viscous friction", "0" },
    { "Motion/Gravity", "9.81" },
    { "Motion/Closure", "full" },
    { "Motion/Tilt", "included" },
    { "Motion/Grip torque", "0" },
    { "Motion/End time", "2" },
    { "Motion/Euler step", "0.001" },
    { "Motion/Step limit", "1e6" },
    { "Glass/Shape", "foot" },
    { "Glass/Profile file", "" },
    { "Glass/Rim waviness", "" },
    { "Glass/Contact radius", "0.03" },
    { "Glass/Foot radius", "0.034" },
    { "Glass/Foot thickness", "0.004" },
    { "Glass/Land width", "0.004" },
    { "Glass/Land height", "0.001" },
    { "Glass/Crown radius", "0.003" },
    { "Glass/Underside rise", "0.003" },
    { "Glass/Edge thickness", "0.0015" },
    { "Glass/Fillet radius", "0.005" },
    { "Glass/Stem radius", "0.005" },
    { "Glass/Stem height", "0.01" },
    { "Glass/Young modulus", "7e10" },
    { "Glass/Poisson ratio", "0.22" },
    { "Table/Interface", "Winkler" },
    { "Table/Substrate", "rigid" },
    { "Table/Foundation modulus", "1e10" },
    { "Table/Layer thickness", "0" },
    { "Table/Reference pressure", "1e9" },
    { "Table/Decay length", "1e-6" },
    { "Table/Disc radius", "0.15" },
    { "Table/Disc thickness", "0.05" },
    { "Table/Disc Young modulus", "1e10" },
    { "Table/Disc Poisson ratio", "0.3" },
    { "Table/Waviness", "" },
    { "Contact/Body", "revolution" },
    { "Contact/Mesh file", "" },
    { "Contact/Mesh unit", "m" },
    { "Contact/Mesh contact id", "2" },
    { "Contact/Mesh stem id", "1" },
    { "Contact/Mesh contact height", "0" },
    { "Contact/Degree", "2" },
    { "Contact/Azimuthal cells", "48" },
    { "Contact/Radial cells", "4" },
    { "Contact/Refinements", "0" },
    { "Contact/Foot layers", "2" },
    { "Contact/Land grading", "3" },
    { "Contact/Linear solver", "automatic" },
    { "Contact/Harmonics", "16" },
    { "Contact/Azimuth lines", "128" },
    { "Contact/Rings", "5" },
    { "Contact/Load harmonics", "0" },
    { "Contact/Friction coupling", "elastic" },
    { "Contact/Goal", "none" },
    { "Contact/Goal tolerance", "1e-5" },
    { "Contact/Memory limit", "4e9" },
    { "Load/Source", "contact" },
    { "Load/Coupling", "two-way" },
    { "Load/Moment ratio", "-1" },
    { "Load/Moment direction", "-1.5707963" },
    { "Load/File", "" },
  };
  Study study;
  std::map<std::string, std::string> found;
  for (const StudyEntry &entry : study_entries(study))
    found[entry.path()] = entry.text();
  for (const auto &[path, text] : expected)
    EXPECT_EQ(found[path], text) << path;
}

TEST(StudyFile, EveryDefaultIsAnAllowedValue)
{
  Study study;
  for (const StudyEntry &entry : study_entries(study))
    EXPECT_TRUE(entry.assign(entry.text())) << entry.path();
  EXPECT_NO_THROW(check_study(study));
}

TEST(StudyFile, KeepsAllDigits)
{
  const ScratchFolder scratch;
  const std::string file = scratch.write("digits.prm", "subsection Glass\n"
                                                       "  set Contact radius = 0.0312345678901234\n"
                                                       "end\n");
  const Study study = read_study(file, { "Motion/Orbit speed = 0.3512345678901234" });
  EXPECT_EQ(study.glass.profile.contact_radius, 0.0312345678901234);
  EXPECT_EQ(study.motion.orbit.orbit_speed, 0.3512345678901234);
  EXPECT_EQ(study.glass.profile.foot_radius, 0.034);
}

TEST(StudyFile, EchoGivesTheSameStudyAgain)
{
  const ScratchFolder scratch;
  const std::string file = scratch.write("first.prm", "# defaults\n");
  const Study study = read_study(file, { "Glass/Contact radius=0.0301234567890123", "Motion/Closure=hand",
                                         "Load/Source=first harmonic", "Motion/Orbit sense=clockwise",
                                         "Contact/Azimuthal cells=12", "Load/Moment ratio=0.3" });
  const Study again = read_study(scratch.write("echo.prm", study_as_prm(study)));
  EXPECT_EQ(study_as_json(again), study_as_json(study));
  EXPECT_EQ(study_as_json(study)["Glass"]["Contact radius"], 0.0301234567890123);
  EXPECT_EQ(study_as_json(study)["Load"]["Source"], "first harmonic");
}

TEST(StudyFile, CommentedDefaultsAreAStudyOfDefaults)
{
  const ScratchFolder scratch;
  const Study study = read_study(scratch.write("defaults.prm", commented_defaults()));
  EXPECT_EQ(study_as_json(study), study_as_json(Study()));
}

TEST(StudyFile, JsonSaysTheSameAsPrm)
{
  const ScratchFolder scratch;
  const Study prm = read_study(scratch.write("a.prm", "subsection Table\n  set Interface = hard\nend\n"
                                                      "subsection Contact\n  set Degree = 1\nend\n"));
  const Study json =
    read_study(scratch.write("a.json", R"({"Table": {"Interface": "hard"}, "Contact": {"Degree": 1}})"));
  EXPECT_EQ(study_as_json(json), study_as_json(prm));
}

TEST(StudyFile, OverridesWinOverTheFileAndStandOnce)
{
  const ScratchFolder scratch;
  const std::string file = scratch.write("a.prm", "subsection Motion\n  set Mass = 0.2\nend\n");
  EXPECT_EQ(read_study(file).motion.orbit.mass, 0.2);
  EXPECT_EQ(read_study(file, { "Motion/Mass=0.5" }).motion.orbit.mass, 0.5);
  EXPECT_THROW(read_study(file, { "Motion/Mass=0.4", "Motion/Mass=0.5" }), BadInput);
}

TEST(StudyFile, PathsStartAtTheStudyFile)
{
  const ScratchFolder scratch;
  for (const char *folder : { "meshes", "studies", "results" })
    std::filesystem::create_directory(scratch / folder);
  const std::string mesh = scratch.write("meshes/foot.msh", "a mesh");
  const std::string text =
    "subsection Contact\n  set Body = solid\n  set Mesh file = ../meshes/foot.msh\nend\n";
  const std::string file = scratch.write("studies/a.prm", text);
  const Study study = read_study(file);
  EXPECT_EQ(study.contact.mesh_file, mesh);
  EXPECT_EQ(study.load.file, "");
  EXPECT_EQ(with_paths_from(scratch / "results", study).contact.mesh_file, "../meshes/foot.msh");
  // On the command line a path is what the shell's completion makes of it.
  EXPECT_EQ(read_study(file, { "Contact/Mesh file=" + mesh }).contact.mesh_file, mesh);
  EXPECT_NE(refusal(file, { "Contact/Mesh file=../meshes/foot.msh" }), "");
}

TEST(StudyFile, SuggestsTheLikeliestEntry)
{
  const ScratchFolder scratch;
  const std::string file = scratch.write("a.prm", "subsection Glass\n  set Contact radus = 0.03\nend\n");
  EXPECT_EQ(refusal(file), file + ", line 2: there is no entry \"Glass/Contact radus\"; did you mean "
                                  "Glass/Contact radius? (`stemware defaults` lists what there is.)");
  const std::string strange = refusal(scratch.write("b.prm", "# nothing\n"), { "Colour/Wine=red" });
  EXPECT_EQ(strange.find("did you mean"), std::string::npos) << strange;
}

TEST(StudyFile, GuessesTheSymbolsOfTheField)
{
  for (const auto &[word, meant] : {
         std::pair("Glass/E", "Glass/Young modulus"),
         std::pair("Table/E", "Table/Disc Young modulus"),
         std::pair("E", "Glass/Young modulus"),
         std::pair("Glass/nu", "Glass/Poisson ratio"),
         std::pair("Motion/mu", "Motion/Friction coefficient"),
         std::pair("Motion/\u03bc", "Motion/Friction coefficient"),
         std::pair("Glass/R", "Glass/Contact radius"),
         std::pair("Motion/R", "Motion/Orbit radius"),
         std::pair("Motion/m", "Motion/Mass"),
         std::pair("Motion/g", "Motion/Gravity"),
         std::pair("Motion/v", "Motion/Orbit speed"),
         std::pair("Motion/omega", "Motion/Orbit speed"),
         std::pair("Motion/rho", "Motion/Orbit radius"),
         std::pair("Motion/z_cm", "Motion/Centre of mass height"),
         std::pair("motion/I", "Motion/Yaw inertia"),
         std::pair("Motion/h", "Motion/Centre of mass height"),
         std::pair("Table/k", "Table/Foundation modulus"),
         std::pair("Table/Roughness", "Table/Decay length"),
       })
    EXPECT_NE(refusal("", { std::string(word) + "=1" }).find("did you mean " + std::string(meant) + "?"),
              std::string::npos)
      << word;
}

TEST(StudyFile, FieldWordsAreGuessesAtEntries)
{
  // A guess that names no entry would be found by nobody else.
  for (const char *word :
       { "E",     "nu", "mu", "mu_k", "mu_s", "v_s", "c", "R",   "m",  "g", "v",        "rho",
         "rho_c", "z",  "h",  "hand", "dz",   "I",   "k", "p_0", "p0", "l", "Thickness" })
    for (const char *section : { "", "Motion/", "Glass/", "Table/" })
    {
      const std::string sentence = refusal("", { section + std::string(word) + "=1" }),
                        question = "did you mean ";
      const std::size_t begin = sentence.find(question) + question.size();
      EXPECT_NO_THROW(find_entry("", sentence.substr(begin, sentence.find('?') - begin))) << sentence;
    }
}

TEST(StudyFile, TakesAnEntryByItsNameAlone)
{
  const ScratchFolder scratch;
  EXPECT_EQ(read_study("", { "Mass=250 g" }).motion.orbit.mass, 0.25);
  EXPECT_EQ(read_study(scratch.write("a.prm", "set Mass = 250 g\n")).motion.orbit.mass, 0.25);
  EXPECT_NE(refusal("", { "Mass=250 g", "Motion/Mass=0.3" }).find("twice"), std::string::npos);
  const std::string twice = "set Mass = 250 g\nsubsection Motion\n  set Mass = 0.3\nend\n";
  EXPECT_NE(refusal(scratch.write("b.prm", twice)).find("a second time, after line 1"), std::string::npos);
  EXPECT_NE(refusal("", { "Coupling=frozen" }).find("Load/Coupling = one-way"), std::string::npos);
  EXPECT_NE(refusal("", { "Mas=1" }).find("did you mean Motion/Mass?"), std::string::npos);
}

TEST(StudyFile, LeavesQuotesOut)
{
  for (const char *value : { "\"300 g\"", "'300 g'", "\u201c300 g\u201d" })
    EXPECT_NE(refusal("", { "Motion/Mass=" + std::string(value) }).find("quotes"), std::string::npos)
      << value;
  EXPECT_NE(
    refusal("", { "Glass/Young modulus=70\u2009000\u2009000\u2009000" }).find("blanks between its digits"),
    std::string::npos);
}

TEST(StudyFile, LinesMayGoOnAndSectionsComeBack)
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

TEST(StudyFile, NamesTheLineOfWhatIsWrong)
{
  const ScratchFolder scratch;
  const auto expect_refusal = [&](const std::string &text, const std::string &expected)
  {
    const std::string file = scratch.write("a.prm", text);
    EXPECT_EQ(refusal(file), file + expected);
  };
  expect_refusal("subsection Glass\n  set Contact radius = 0.03\nend\nsubsection Glass\n"
                 "  set Contact radius = 0.04\nend\n",
                 ", line 5: Glass/Contact radius is set a second time, after line 2; leave one of them.");
  expect_refusal("subsection Glass\n  set Foot \\\n    radius = 0.03\n  set Foot radius = x\nend\n",
                 ", line 4: Glass/Foot radius is set a second time, after line 2; leave one of them.");
  expect_refusal("subsection Glass\n\n  set Foot \\\n    radius = x\nend\n",
                 ", line 3: Glass/Foot radius = x is not allowed; give a number greater than 0 (m).");
  expect_refusal("\nsubsection Glass\n  set Contact radius = 0.03\n",
                 ", line 2: the subsection Glass is not closed; write one \"end\" for each \"subsection\".");
  expect_refusal("subsection Glass\nsubsection Table\nend\n",
                 ", line 2: the subsection Glass of line 1 is not closed; write one \"end\" for each "
                 "\"subsection\".");
  expect_refusal("include other.prm\n",
                 ", line 1: \"include other.prm\" is not a line of a study file; write "
                 "subsection NAME, set ENTRY = VALUE, or end.");
  expect_refusal("subsection Table\n  set Contact radius = 0.03\nend\n",
                 ", line 2: there is no entry \"Table/Contact radius\"; did you mean Glass/Contact "
                 "radius? (`stemware defaults` lists what there is.)");
  expect_refusal("subsection Table\n  set Interface = " + std::string(100000, 'x') + "\nend\n",
                 ", line 2: Table/Interface = " + std::string(80, 'x') +
                   "... is not allowed; give hard, Winkler or rough.");
}

TEST(StudyFile, SaysWhatWasGivenAndWhatIsAllowed)
{
  const ScratchFolder scratch;
  const std::string file =
    scratch.write("a (1).prm", "subsection Glass\n  set Contact radius = -0.03 # m\nend\n");
  EXPECT_EQ(refusal(file),
            file +
              ", line 2: Glass/Contact radius = -0.03 is not allowed; give a number greater than 0 (m).");
}

} // namespace
} // namespace stemware::pipeline
