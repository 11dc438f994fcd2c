#include "fem/pipeline/study/study_checks.h"
#include "fem/pipeline/study/study_file.h"
#include "ring_model/failures.h"
#include "tests/fem/pipeline/matchers.h"
#include "tests/fem/pipeline/program_runner.h"
#include "tests/fem/pipeline/refusal.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace stemware::test
{
namespace
{

/// Expects that @p command writes no files, returns @p exit_code and prints one line with @p expected on
/// standard error.
void expect_refused(const ScratchFolder &scratch, const std::vector<std::string> &command,
                    const std::string &expected, int exit_code = 1)
{
  SCOPED_TRACE(testing::PrintToString(command));
  const auto before = names_in(scratch.path());
  const Ended ended = stemware(scratch, command);
  EXPECT_EQ(ended.exit_code, exit_code) << ended.err;
  EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
  EXPECT_EQ(ended.err.rfind("stemware: ", 0), 0u) << ended.err;
  EXPECT_THAT(ended.err, testing::HasSubstr(expected));
  EXPECT_THAT(ended.err, testing::Not(testing::HasSubstr("does not match the given pattern")));
  EXPECT_EQ(names_in(scratch.path()), before);
}

std::string study_refusal(const std::string &file, const std::vector<std::string> &overrides = {})
{
  try
  {
    return sentence_of([&] { pipeline::require_no_tipping_at_rest(pipeline::read_study(file, overrides)); });
  }
  catch (const ring::Tipping &falls)
  {
    return falls.what();
  }
}

TEST(BadInput, NamesTheErrorOfAStudyFile)
{
  for (const auto &[name, text, expected] : std::vector<std::tuple<std::string, std::string, std::string>>{
         { "empty.prm", "", "is empty" },
         { "blank.prm", " \n\t\n", "is empty" },
         { "binary.prm",
           std::string("\x7f"
                       "ELF\0\1\2",
                       7),
           "is not a text file" },
         { "study.txt", "# text\n", "neither .prm nor .json" },
         { "entry.prm", "subsection Glass\n  set Contact radus = 1\nend\n",
           "no entry \"Glass/Contact radus\"" },
         { "section.prm", "subsection Glas\n  set Contact radius = 1\nend\n", "no subsection \"Glas\"" },
         { "case.prm", "subsection motion\n  set Mass = 1\nend\n", "did you mean Motion?" },
         { "open.prm", "subsection Glass\n  set Contact radius = 0.03\n", "is not closed" },
         { "end.prm", "end\n", "no \"subsection\" above it" },
         { "no_set.prm", "subsection Glass\n  Contact radius = 1\nend\n", "is not a line of a study file" },
         { "no_value.prm", "subsection Glass\n  set Contact radius\nend\n", "write set ENTRY = VALUE" },
         { "negative.prm", "subsection Glass\n  set Contact radius = -0.03\nend\n",
           "Glass/Contact radius = -0.03 is not allowed; give a number greater than 0 (m)" },
         { "nothing.prm", "subsection Glass\n  set Contact radius =\nend\n",
           "Glass/Contact radius = (nothing) is not allowed" },
         { "value.json", "{\"Glass\": {\"Contact radius\": -1}}",
           "Glass/Contact radius = -1 is not allowed" } })
  {
    const ScratchFolder scratch;
    EXPECT_THAT(study_refusal(scratch.write(name, text)), testing::HasSubstr(expected)) << name;
  }
  const ScratchFolder scratch;
  expect_refused(scratch, { "run", scratch.write("empty.prm", "") }, "is empty");
}

TEST(BadInput, NamesTheErrorOfASetting)
{
  const std::string solid = "Contact/Body=solid", foot = "Glass/Shape=foot",
                    flat_foot = "Contact/Mesh file=" STEMWARE_MESHES "/flat_foot.msh";
  const ScratchFolder scratch;
  const std::string study =
    scratch.write("study.prm", "subsection Table\n  set Interface = Winkler\n  set Substrate = rigid\nend\n");
  scratch.write("cube.msh",
                "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n8\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n"
                "5 0 0 1\n6 1 0 1\n7 1 1 1\n8 0 1 1\n$EndNodes\n$Elements\n1\n1 5 2 0 1 1 2 3 4 5 6 7 8\n"
                "$EndElements\n");
  scratch.write("tipping.dat", "# ring radius: 0.03 (m)\n0 0.4 0\n1 0.9 0\n");
  for (const auto &[settings, expected] : std::vector<std::pair<std::vector<std::string>, std::string>>{
         { { "=0.03" }, "is not an assignment" },
         { { "Glass/Contact radius" }, "is not an assignment" },
         { { "Glass/Contact radius=inf" }, "is not allowed" },
         { { "Motion/Mass=0" }, "is not allowed" },
         { { "Motion/Gravity=1e400" }, "is not allowed" },
         { { "Motion/Closure=papper" }, "is not allowed" },
         { { "Motion/Euler step=1e-12" }, "use longer steps" },
         { { "Motion/Friction decay speed=0" }, "Motion/Friction decay speed = 0" },
         { { "Motion/Mass=0.3", "Motion/Mass=0.4" },
           "--set sets Motion/Mass twice, to \"Motion/Mass=0.3\" and \"Motion/Mass=0.4\"" },
         { { "Glass/Poisson ratio=0.5" }, "is not allowed" },
         { { "Glass/Crown radius=-1" }, "not less than 0" },
         { { "Glass/Stem radius=0.029" }, "Glass/Stem radius = 0.029 m does not fit the foot" },
         { { "Glass/Shape=round" }, "give step, foot or profile" },
         { { "Glass/Edge thickness=0" }, "greater than 0" },
         { { foot, "Glass/Fillet radius=0.02" }, "give a smaller fillet or a longer stem" },
         { { foot, "Glass/Stem height=0.003" }, "a longer stem" },
         { { "Table/Foundation modulus=nan" }, "is not allowed" },
         { { "Table/Decay length=0" }, "greater than 0" },
         { { "Load/Moment ratio=2" }, "tips at 2; give less" },
         { { "Glass/Crown radius=0", "Load/Moment ratio=2.2" }, "tips at 2.13333; give less" },
         { { "Load/File=nothing.dat" }, "Load/Source = file" },
         { { "Load/Source=file" }, "needs Load/File" },
         { { "Motion/Force offset=0.3" }, "The glass would tip: the hand needs a moment of" },
         { { "Motion/Force offset=-0.085" }, "0.005 m below the table" },
         { { "Motion/Hand height=-0.001" }, "0.001 m below the table" },
         { { "Motion/Hand height=0.04", "Motion/Force offset=-0.05" }, "contradict each other" },
         { { "Motion/Friction=0.2" }, "did you mean Motion/Friction coefficient?" },
         { { "Motion/Liquid mass=0.5" }, "the bowl overflows: the liquid reaches 0.13415 m" },
         { { "Motion/Liquid mass=1 g" }, "meets the bottom of the bowl" },
         { { "Contact/Azimuthal cells=10" }, "multiple of 4" },
         { { "Contact/Radial cells=3" }, "even" },
         { { "Contact/Degree=5" }, "from 1 to 4" },
         { { "Contact/Azimuth lines=3" }, "from 16 to 100000" },
         { { "Contact/Mesh file=" + study }, "is read by a solid body only" },
         { { solid, "Contact/Degree=3" }, "give 1 or 2" },
         { { solid, "Contact/Mesh file=nothing.msh" }, "nothing.msh does not exist" },
         { { solid, "Contact/Mesh file=." }, "is not a file" } })
    EXPECT_THAT(study_refusal(study, settings), testing::HasSubstr(expected)) << settings.back();
  // read_study() accepts these settings; the run refuses them later.
  for (const auto &[settings, expected] : std::vector<std::pair<std::vector<std::string>, std::string>>{
         { { "Load/Source=file", "Load/File=tipping.dat" }, "tips at 2" },
         { { "Contact/Azimuth lines=20" }, "lines" },
         { { solid, "Contact/Mesh file=study.prm" }, "is not a .msh file" },
         { { solid, "Contact/Mesh file=cube.msh" }, "has no contact zone" },
         { { solid, flat_foot, "Glass/Contact radius=0.3", "Glass/Foot radius=0.34" },
           "has a radius of 0.03" },
         { { solid, flat_foot, "Motion/Orbit speed=2" }, "the hull of the contact zone, 0.0309" } })
    expect_refused(scratch, with_settings({ "run", "study.prm" }, settings), expected);
}

TEST(BadInput, RefusesBadCommandsWithoutChangingFiles)
{
  const ScratchFolder scratch;
  const std::string ring = "Load/Source=first harmonic";
  const char *const own_files[] = { "study.prm", "mine.prm", "mine.msh", "own_profile.csv" };
  for (const char *name : own_files)
    scratch.write(name, "# mine\n");
  std::filesystem::create_directory(scratch / "results");
  scratch.write("results/summary.json", "{}");
  scratch.write("results/.stemware", "summary.json\n");
  scratch.write("results/my_note.txt", "mine");
  const auto before = all_files(scratch / "results");
  struct Refused
  {
    std::vector<std::string> command;
    std::string expected;
    int exit_code = 1;
  };
  const std::string around = "contains the folder where the program was started",
                    no_mark = "exists without a mark of Stemware",
                    note = "holds my_note.txt, which Stemware did not write; move it away";
  for (const auto &[command, expected, exit_code] : std::vector<Refused>{
         { {}, "say what to do: one of run" },
         { { "rum" }, "\"rum\" is not one of the verbs run" },
         { { "rum" }, "; did you mean run? See `stemware --help`" },
         { { "frobnicate" }, "; see `stemware --help`" },
         { { "run", "" }, "the name of the study is empty" },
         { { "run", "nothing.prm" }, "nothing.prm does not exist" },
         { { "run", "." }, "is not a file" },
         { { "run", "docs/cookbooks/lift_off.prm" }, "`stemware new --cookbook lift_off`" },
         { { "run", "study.prm", "--bogus" }, "--bogus" },
         { { "run", "study.prm", "--outptu", "there" },
           "\"--outptu\" is not expected by run; did you mean --output? See `stemware run --help`" },
         { { "run", "study.prm", "another.prm" }, "another.prm" },
         { { "run", "--quiet", "--set", "Motion/Mass=-1" }, "Mass" },
         { { "run", "--output", "" }, "the name of the folder is empty" },
         { { "sweep", "--output", "   " }, "the name of the folder is empty" },
         { { "run", "study.prm", "--output", "/proc/stemware" }, "cannot be written", 3 },
         { { "run", "study.prm", "--output", "study.prm/results" }, "cannot be written", 3 },
         { { "run", "study.prm", "--output", "study.prm" }, "not a folder", 3 },
         { { "run", "study.prm", "--output", "." }, "where the program was started", 3 },
         { { "run", "study.prm", "--output", "/" }, around, 3 },
         { { "run", "--output", "results", "--set", ring }, note, 3 },
         { { "truncate", "--output", "results", "--set", ring }, note, 3 },
         { { "converge", "--set", ring }, "no discretisation to refine" },
         { { "converge", "--levels", "9" }, "--levels" },
         { { "explore", "study.prm", "--output", "study.prm" }, no_mark, 3 },
         { { "explore", "--set", "Contact/Body=solid", "--set", "Table/Substrate=rigid" },
           "bodies of revolution" },
         { { "mesh", "study.prm", "--write", "mine.msh" }, no_mark, 3 },
         { { "mesh", "--write", "foot.stl" }, "ends in neither .msh nor .vtu" },
         { { "mesh", "--write", "no/such/folder/foot.msh" }, "cannot be written", 3 },
         { { "mesh", "--check", "mine.msh" }, "not a Gmsh .msh mesh" },
         { { "run", "--set", "Table/Substrate=rigid", "--set", "Contact/Body=solid", "--set",
             "Contact/Mesh file=mine.msh" },
           "not a Gmsh .msh mesh" },
         { { "new" }, "FILE is required" },
         { { "new", "" }, "The name of the study file is empty" },
         { { "new", "mine.prm" }, "exists without a mark of Stemware", 3 },
         { { "new", "x\nset Foo = 1.prm" }, "line end" },
         { { "new", "x\nset Foo = 1.prm", "--cookbook", "paper" }, "line end" },
         { { "new", "my.prm", "--glass", "flute" }, "champagne" },
         { { "new", "my.prm", "--glass", "bordaux" }, "Bordeaux" },
         { { "new", "my.prm", "--table", "oack" }, "oak" },
         { { "new", "my.prm", "--table", "glass" }, "window glass" },
         { { "new", "--cookbook", "own_profile" }, "own_profile.csv exists", 3 },
         { { "new", "--cookbook", "liftoff" }, "did you mean lift_off? There are bare_wood, " },
         { { "new", "--cookbook", "paper", "--glass", "Bordeaux" }, "--glass" } })
    expect_refused(scratch, command, expected, exit_code);
  EXPECT_EQ(all_files(scratch / "results"), before);
  for (const char *name : own_files)
    EXPECT_EQ(read_text(scratch / name), "# mine\n");
}

TEST(BadInput, ImplausibleValuesAreReportedBeforeTipping)
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
  EXPECT_LT(named, ended.err.find("The glass would tip")) << ended.err;
  EXPECT_THAT(ended.err, testing::HasSubstr("Motion/Orbit speed = 35 m/s (0.01 to 3 m/s)"));
  EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
}

TEST(BadInput, QuietOptionKeepsWarningsOnTheConsole)
{
  const ScratchFolder scratch;
  const std::vector<std::string> run = { "run", "--quiet", "--set", "Load/Source=first harmonic" };
  EXPECT_EQ(stemware(scratch, run).err, "");
  const Ended heavy = stemware(scratch, with_settings(run, { "Motion/Mass=300 kg" }));
  EXPECT_EQ(heavy.exit_code, 0);
  EXPECT_EQ(heavy.out, "");
  EXPECT_THAT(heavy.err, testing::HasSubstr("write 300 g"));
}

/// Runs a shell command, in which $S is the path of the program.
Ended shell(const ScratchFolder &scratch, const std::string &command)
{
  return RunningProgram({ "/bin/sh", "-c", "S=" STEMWARE_PROGRAM "; " + command }, scratch.path()).end();
}

TEST(BadInput, LackOfMemoryIsReportedInOneLine)
{
  const ScratchFolder scratch;
  std::size_t n_refused = 0;
  for (const char *study : { "", " --set Table/Substrate=rigid --set Contact/Body=solid" })
    for (const char *limit : { "600000", "700000", "1000000", "1200000" }) // virtual memory [kB]
    {
      SCOPED_TRACE(limit + std::string(study));
      // The libraries of a debug build need more than the smaller limits.
      const Ended ended = shell(
        scratch, std::string("ulimit -c 0; ulimit -v ") + limit +
                   "; $S --version >version 2>&1 || exit 0; $S run --quick --quiet --threads 1" + study);
      if (ended.exit_code == 0)
        continue;
      ++n_refused;
      EXPECT_EQ(ended.exit_code, 2) << ended.err;
      EXPECT_THAT(ended.err, testing::HasSubstr("memory"));
      EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
    }
  EXPECT_GE(n_refused, 1u);
}

TEST(BadInput, AFailedWriteToStandardOutputIsAnErrorUnlessNothingIsPrinted)
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
  EXPECT_EQ(shell(scratch, "$S run study.prm --quiet > /dev/full").exit_code, 0); // --quiet prints nothing
}

TEST(BadInput, RefusesInvalidUtf8BeforeTheComputation)
{
  const ScratchFolder scratch;
  scratch.write("latin\xe9.prm",
                "subsection Table\n  set Interface = Winkler\n  set Substrate = rigid\nend\n");
  scratch.write("study.prm", "# Verr\xe9\n"); // comments may contain any bytes
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

TEST(BadInput, LongInputIsShortenedInMessages)
{
  const ScratchFolder scratch;
  const std::string file = scratch.write(
                      "study.prm",
                      "subsection Table\n  set Interface = Winkler\n  set Substrate = rigid\nend\n"),
                    much(100000, '7');
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
