// Whatever is wrong with the input ends in one clear sentence, a meaningful exit code, and nothing on the
// disk.
#include "tests/fem/pipeline/matchers.h"
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace stemware::test
{
namespace
{

/// Asserts that a run was refused with exactly one line on standard error that contains @p expected, and that
/// it left nothing behind.
void expect_refused(const ScratchFolder &scratch, const std::vector<std::string> &arguments, int exit_code,
                    const std::string &expected)
{
  const auto before = names_in(scratch.path());
  const Ended ended = stemware(scratch, arguments);
  EXPECT_EQ(ended.exit_code, exit_code) << ended.err;
  EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
  EXPECT_EQ(ended.err.rfind("stemware: ", 0), 0u) << ended.err;
  EXPECT_THAT(ended.err, testing::HasSubstr(expected));
  EXPECT_THAT(ended.err, testing::Not(testing::HasSubstr("does not match the given pattern")));
  EXPECT_EQ(names_in(scratch.path()), before);
}

/// Letters, digits and underscores, as names of tests want it.
std::string as_name(std::string text)
{
  std::replace_if(
    text.begin(), text.end(), [](unsigned char letter) { return !std::isalnum(letter); }, '_');
  return text;
}

struct BadFile
{
  std::string name;
  std::string text;
  std::string expected;
};

std::ostream &operator<<(std::ostream &stream, const BadFile &file)
{
  return stream << file.name;
}

class BadStudyFile : public testing::TestWithParam<BadFile>
{
};

TEST_P(BadStudyFile, IsRefusedInOneSentence)
{
  const ScratchFolder scratch;
  const std::string file = scratch.write(GetParam().name, GetParam().text);
  expect_refused(scratch, { "run", file }, 1, GetParam().expected);
}

INSTANTIATE_TEST_SUITE_P(
  Kinds, BadStudyFile,
  testing::Values(
    BadFile{ "empty.prm", "", "is empty" }, BadFile{ "blank.prm", " \n\t\n", "is empty" },
    BadFile{ "binary.prm",
             std::string("\x7f"
                         "ELF\0\1\2",
                         7),
             "is not a text file" },
    BadFile{ "study.txt", "# text\n", "neither .prm nor .json" },
    BadFile{ "entry.prm", "subsection Glass\n  set Contact radus = 1\nend\n",
             "no entry \"Glass/Contact radus\"" },
    BadFile{ "section.prm", "subsection Glas\n  set Contact radius = 1\nend\n", "no subsection \"Glas\"" },
    BadFile{ "case.prm", "subsection motion\n  set Mass = 1\nend\n", "did you mean Motion?" },
    BadFile{ "top.prm", "set Contact radus = 0.03\n", "did you mean Glass/Contact radius" },
    BadFile{ "open.prm", "subsection Glass\n  set Contact radius = 0.03\n", "is not closed" },
    BadFile{ "end.prm", "end\n", "no \"subsection\" above it" },
    BadFile{ "no_set.prm", "subsection Glass\n  Contact radius = 1\nend\n", "is not a line of a study file" },
    BadFile{ "no_value.prm", "subsection Glass\n  set Contact radius\nend\n", "write set ENTRY = VALUE" },
    BadFile{ "include.prm", "include nothing.prm\n", "nothing.prm" },
    BadFile{ "negative.prm", "subsection Glass\n  set Contact radius = -0.03\nend\n",
             "Glass/Contact radius = -0.03 is not allowed; give a number greater than 0 (m)" },
    BadFile{ "nan.prm", "subsection Glass\n  set Contact radius = nan\nend\n",
             "Glass/Contact radius = nan is not allowed" },
    BadFile{ "nothing.prm", "subsection Glass\n  set Contact radius =\nend\n",
             "Glass/Contact radius = (nothing) is not allowed" },
    BadFile{ "broken.json", "{\"Glass\": ", "line 1, column 11: the JSON ends before it is complete" },
    BadFile{ "entry.json", "{\"Glass\": {\"Contact radus\": 1}}", "did you mean Glass/Contact radius" },
    BadFile{ "value.json", "{\"Glass\": {\"Contact radius\": -1}}",
             "Glass/Contact radius = -1 is not allowed" }),
  [](const auto &info) { return as_name(info.param.name); });

struct BadSetting
{
  std::string setting;
  std::string expected;
  std::string body = "revolution";
};

std::ostream &operator<<(std::ostream &stream, const BadSetting &setting)
{
  return stream << setting.setting;
}

class BadOverride : public testing::TestWithParam<BadSetting>
{
};

TEST_P(BadOverride, IsRefusedInOneSentence)
{
  const ScratchFolder scratch;
  const std::string file =
    scratch.write("study.prm", "subsection Contact\n  set Body = " + GetParam().body + "\nend\n");
  expect_refused(scratch, { "run", file, "--set", GetParam().setting }, 1, GetParam().expected);
}

INSTANTIATE_TEST_SUITE_P(
  Settings, BadOverride,
  testing::Values(
    BadSetting{ "Glass/Contact radus=1", "no entry" }, BadSetting{ "=0.03", "is not an assignment" },
    BadSetting{ "Glass/Contact radius", "is not an assignment" },
    BadSetting{ "Glass/Contact radius=inf", "is not allowed" },
    BadSetting{ "Motion/Mass=0", "is not allowed" }, BadSetting{ "Motion/Gravity=1e400", "is not allowed" },
    BadSetting{ "Motion/Closure=papper", "is not allowed" },
    BadSetting{ "Motion/Euler step=1e-12", "use longer steps" },
    BadSetting{ "Glass/Poisson ratio=0.5", "is not allowed" },
    BadSetting{ "Glass/Crown radius=-1", "not less than 0" },
    BadSetting{ "Glass/Stem radius=0.029", "Glass/Stem radius = 0.029 m does not fit the foot" },
    BadSetting{ "Glass/Shape=round", "give step, foot or profile" },
    BadSetting{ "Glass/Edge thickness=0", "greater than 0" },
    BadSetting{ "Glass/Underside rise=-1e-3", "not less than 0" },
    BadSetting{ "Table/Foundation modulus=nan", "is not allowed" },
    BadSetting{ "Load/Moment ratio=2", "less than 2, where the foot tips" },
    BadSetting{ "Load/Moment ratio=nan", "is not allowed" },
    BadSetting{ "Motion/Force offset=0.3", "asks for a moment ratio of" },
    BadSetting{ "Contact/Azimuthal cells=10", "multiple of 4" },
    BadSetting{ "Contact/Radial cells=3", "even" }, BadSetting{ "Contact/Degree=3", "give 1 or 2", "solid" },
    BadSetting{ "Contact/Degree=5", "from 1 to 4" },
    BadSetting{ "Contact/Mesh file=nothing.msh", "nothing.msh does not exist", "solid" },
    BadSetting{ "Contact/Mesh file=study.prm", "give a .msh or .inp file", "solid" },
    BadSetting{ "Contact/Mesh file=.", "is not a file", "solid" },
    BadSetting{ "Load/File=nothing.dat", "Load/Source = file" },
    BadSetting{ "Load/Source=file", "needs Load/File" },
    BadSetting{ "Table/Substrate=elastic", "set Contact/Body = revolution", "solid" },
    BadSetting{ "Table/Kind=mat", "write Table/Interface = Winkler, Table/Substrate = rigid" },
    BadSetting{ "Motion/Grip torque=-1e-3", "not less than 0" },
    BadSetting{ "Motion/Liquid mass=0.5", "the bowl overflows: the liquid reaches 0.13415 m" },
    BadSetting{ "Motion/Liquid mass=1 g", "meets the bottom of the bowl" },
    BadSetting{ "Glass/Foot radius=34", "times Glass/Contact radius" },
    BadSetting{ "Table/Decay length=0", "greater than 0" },
    BadSetting{ "Contact/Azimuth lines=3", "from 16 to 100000" },
    BadSetting{ "Contact/Mesh file=study.prm", "is read by a solid body only" },
    BadSetting{ "Load/Coupling=exact", "write Load/Coupling = two-way" },
    BadSetting{ "Contact/Load harmonics=500", "give more lines, or fewer load harmonics" }),
  [](const auto &info) { return as_name(info.param.setting + " " + info.param.body); });

TEST(BadInput, SettingsThatContradictEachOtherAreRefused)
{
  const ScratchFolder scratch;
  const std::string study = scratch.write("study.prm", coarse_study());
  const auto expect_contradiction = [&](const std::string &one, const std::string &other,
                                        const std::string &expected) {
    expect_refused(scratch, { "run", study, "--set", one, "--set", other }, 1, expected);
  };
  expect_contradiction("Contact/Body=revolution", "Contact/Azimuth lines=20", "lines");
  expect_contradiction("Glass/Shape=foot", "Glass/Fillet radius=0.02",
                       "give a smaller fillet or a longer stem");
  expect_contradiction("Glass/Shape=foot", "Glass/Stem height=0.003", "a longer stem");
}

TEST(BadInput, AnEntryIsSetOnceOnTheCommandLineToo)
{
  const ScratchFolder scratch;
  const std::string file = scratch.write("study.prm", coarse_study());
  expect_refused(scratch, { "run", file, "--set", "Motion/Mass=0.3", "--set", "Motion/Mass=0.4" }, 1,
                 "--set sets Motion/Mass twice, to \"Motion/Mass=0.3\" and \"Motion/Mass=0.4\"");
}

TEST(BadInput, FoldersWithoutANameAreRefused)
{
  const ScratchFolder scratch;
  expect_refused(scratch, { "run", "--output", "" }, 1, "the name of the folder is empty");
  expect_refused(scratch, { "sweep", "--output", "   " }, 1, "the name of the folder is empty");
  expect_refused(scratch, { "new", "" }, 1, "The name of the study file is empty");
}

TEST(BadInput, ASlipOfUnitsBehindATippingGlassIsNamedFirst)
{
  const ScratchFolder scratch;
  const std::vector<std::string> slips = { "run",
                                           "--set",
                                           "Motion/Centre of mass height=80",
                                           "--set",
                                           "Motion/Friction coefficient=3",
                                           "--set",
                                           "Motion/Orbit speed=35" };
  const Ended ended = stemware(scratch, slips);
  EXPECT_EQ(ended.exit_code, 1);
  EXPECT_THAT(ended.out,
              testing::HasSubstr("Check     Motion/Centre of mass height = 80 m is outside 0.01 to 0.3 m"));
  const auto named = ended.err.find("Motion/Centre of mass height = 80 m (0.01 to 0.3 m)");
  EXPECT_LT(named, ended.err.find("but the foot tips at 2")) << ended.err;
  EXPECT_THAT(ended.err, testing::HasSubstr("Motion/Orbit speed = 35 m/s (0.01 to 3 m/s)"));
  EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
}

/// The exit code and standard error of a command of the shell; $S is the program.
Ended shell(const ScratchFolder &scratch, const std::string &command)
{
  return RunningProgram({ "/bin/sh", "-c", "S=" STEMWARE_PROGRAM "; " + command }, scratch.path()).end();
}

TEST(BadInput, OutputThatIsLostEndsInAFailure)
{
  const ScratchFolder scratch;
  scratch.write("study.prm", "subsection Load\n  set Source = first harmonic\nend\n");
  for (const char *command :
       { "$S run study.prm --json --quiet > /dev/full", "$S defaults > /dev/full", "$S --help > /dev/full" })
  {
    const Ended ended = shell(scratch, command);
    EXPECT_EQ(ended.exit_code, 3) << command;
    EXPECT_THAT(ended.err, testing::HasSubstr("Standard output"));
    EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
  }
  EXPECT_TRUE(std::filesystem::exists(scratch / "results/study/summary.json"));
  std::filesystem::remove_all(scratch / "results");
  const Ended closed = shell(scratch, "$S run study.prm --json --quiet >&-");
  EXPECT_EQ(closed.exit_code, 3);
  EXPECT_THAT(closed.err, testing::HasSubstr("--json"));
  EXPECT_FALSE(std::filesystem::exists(scratch / "results"));
  EXPECT_EQ(shell(scratch, "$S run study.prm --quiet > /dev/full").exit_code, 0); // prints nothing
}

TEST(BadInput, MissingStudyFileIsRefused)
{
  const ScratchFolder scratch;
  expect_refused(scratch, { "run", "nothing.prm" }, 1, "nothing.prm does not exist");
  expect_refused(scratch, { "run", "." }, 1, "is not a file");
}

TEST(BadInput, UsageErrorsAreRefused)
{
  const ScratchFolder scratch;
  const std::string file = scratch.write("study.prm", "# defaults\n");
  expect_refused(scratch, {}, 1, "say what to do: one of run");
  expect_refused(scratch, { "rum" }, 1, "\"rum\" is not one of the verbs run");
  expect_refused(scratch, { "rum" }, 1, "; did you mean run? See `stemware --help`");
  expect_refused(scratch, { "frobnicate" }, 1, "; see `stemware --help`");
  expect_refused(scratch, { "run", "" }, 1, "the name of the study is empty");
  expect_refused(scratch, { "run", file, "--bogus" }, 1, "--bogus");
  expect_refused(scratch, { "run", file, "--outptu", "there" }, 1,
                 "\"--outptu\" is not expected by run; did you mean --output? See `stemware run --help`");
  expect_refused(scratch, { "run", file, "another.prm" }, 1, "another.prm");
}

TEST(BadInput, MeshWithoutContactZoneIsRefused)
{
  const ScratchFolder scratch;
  scratch.write("cube.msh",
                "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n8\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n"
                "5 0 0 1\n6 1 0 1\n7 1 1 1\n8 0 1 1\n$EndNodes\n$Elements\n1\n1 5 2 0 1 1 2 3 4 5 6 7 8\n"
                "$EndElements\n");
  const std::string file = scratch.write("study.prm", coarse_study());
  expect_refused(scratch, { "run", file, "--set", "Contact/Mesh file=cube.msh" }, 1, "has no contact zone");
}

TEST(BadInput, LoadThatTipsTheRingIsRefused)
{
  const ScratchFolder scratch;
  scratch.write("tipping.dat", "# ring radius: 0.03 (m)\n0 0.4 0\n1 0.9 0\n");
  const std::string file = scratch.write("study.prm", "subsection Load\n  set Source = file\n"
                                                      "  set File = tipping.dat\nend\n");
  expect_refused(scratch, { "run", file }, 1, "tips at 2");
}

TEST(BadInput, UnwritableOutputIsRefused)
{
  const ScratchFolder scratch;
  const std::string file = scratch.write("study.prm", "# defaults\n");
  expect_refused(scratch, { "run", file, "--output", "/proc/stemware" }, 3, "cannot be written");
  expect_refused(scratch, { "run", file, "--output", "study.prm/results" }, 3, "cannot be written");
  expect_refused(scratch, { "run", file, "--output", "study.prm" }, 3, "not a folder");
  expect_refused(scratch, { "run", file, "--output", "." }, 3, "where the program was started");
  expect_refused(scratch, { "run", file, "--output", "/" }, 3,
                 "around the folder where the program was started");
  expect_refused(scratch, { "explore", file, "--output", "study.prm" }, 3,
                 "exists without a mark of Stemware");
  expect_refused(scratch, { "mesh", file, "--write", scratch.write("mine.msh", "mine") }, 3,
                 "exists without a mark of Stemware");
  EXPECT_EQ(read_text(file), "# defaults\n");
  EXPECT_EQ(read_text(scratch / "mine.msh"), "mine");
}

TEST(BadInput, BytesThatAreNoUtf8AreRefusedBeforeTheWork)
{
  const ScratchFolder scratch;
  scratch.write("latin\xe9.prm", "# defaults\n");
  scratch.write("study.prm", "# Verr\xe9\n"); // a comment becomes no result
  scratch.write("entry.prm", "subsection Glass\n  set Profile file = verr\xe9.csv\nend\n");
  const auto before = names_in(scratch.path());
  for (const std::vector<std::string> &arguments :
       { std::vector<std::string>{ "run", "latin\xe9.prm" },
         { "run", "entry.prm" },
         { "new", "verr\xe9.prm" },
         { "run", "study.prm", "--output", "r\xff" },
         { "explore", "study.prm", "--output", "e\xff.html" },
         { "run", "study.prm", "--set", "Glass/Profile file=q\xff.csv" },
         { "sweep", "study.prm", "--vary", "Motion/Closure=paper,\xff" } })
  {
    std::vector<std::string> command = arguments;
    command.insert(command.begin(), STEMWARE_PROGRAM);
    const Ended ended = RunningProgram(command, scratch.path()).end();
    EXPECT_EQ(ended.exit_code, 1) << ended.err;
    EXPECT_THAT(ended.err, testing::HasSubstr("not in UTF-8"));
    EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
    EXPECT_EQ(names_in(scratch.path()), before);
  }
}

TEST(BadInput, ARerunLosesNoFileOfAUser)
{
  const ScratchFolder scratch;
  const std::string file =
    scratch.write("study.prm", "subsection Load\n  set Source = first harmonic\nend\n");
  const auto run = [&] { return stemware(scratch, { "run", file, "--output", "results", "--quiet" }); };
  ASSERT_EQ(run().exit_code, 0);
  ASSERT_EQ(run().exit_code, 0); // nothing has changed
  scratch.write("results/figures/my_note.txt", "mine");
  const auto before = all_files(scratch / "results");
  for (const char *verb : { "run", "truncate" })
    expect_refused(scratch, { verb, file, "--output", "results" }, 3,
                   "holds figures/my_note.txt, which Stemware never writes; move it away");
  EXPECT_EQ(all_files(scratch / "results"), before);
}

TEST(BadInput, MessagesRepeatLittleOfALongInput)
{
  const ScratchFolder scratch;
  const std::string file = scratch.write("study.prm", "# defaults\n"), much(100000, '7');
  for (const std::string &setting :
       std::vector<std::string>{ "Motion/Mass=x" + much, "Motion/Mess" + much + "=1", much })
  {
    const Ended ended = stemware(scratch, { "run", file, "--set", setting });
    EXPECT_EQ(ended.exit_code, 1);
    EXPECT_THAT(ended.err, testing::HasSubstr("7777...")) << ended.err.substr(0, 1000);
    EXPECT_LT(ended.err.size(), 300u);
  }
}

} // namespace
} // namespace stemware::test
