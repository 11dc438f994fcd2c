// Text files from other programs and editors: byte order marks, decimal commas, broken and deep JSON, numbers
// that no glass has. Each is read, or refused with one sentence that names the place.
#include "fem/pipeline/study/data_files.h"
#include "fem/pipeline/study/study_file.h"
#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/json_text.h"
#include "tests/fem/temporary_file.h"

#include <boost/algorithm/string.hpp>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <unistd.h>

namespace stemware::pipeline
{
namespace
{

using fem_tests::TemporaryFile;

template <typename Read>
void expect_sentence_of(const Read &read, const std::string &part)
{
  std::string sentence;
  try
  {
    read();
  }
  catch (const BadInput &error)
  {
    sentence = error.what();
  }
  EXPECT_NE(sentence.find(part), std::string::npos) << "\"" << sentence << "\" lacks \"" << part << "\"";
  EXPECT_LT(sentence.size(), 400u);
}

void expect_refused_study(const std::string &text, const std::string &extension, const std::string &part)
{
  const TemporaryFile file(text, extension);
  expect_sentence_of([&] { read_study(file.name); }, part);
}

std::string repeated(const std::string &text, unsigned int n)
{
  std::string all;
  for (unsigned int i = 0; i < n; ++i)
    all += text;
  return all;
}

TEST(TextReader, SkipsAByteOrderMarkAndNamesUtf16)
{
  const std::string mark = "\xEF\xBB\xBF", study = "subsection Motion\n  set Mass = 0.3\nend\n";
  EXPECT_EQ(read_study(TemporaryFile(mark + study, ".prm").name).motion.orbit.mass, 0.3);
  EXPECT_EQ(read_study(TemporaryFile(mark + "{\"Motion\": {\"Mass\": 0.3}}", ".json").name).motion.orbit.mass,
            0.3);
  EXPECT_EQ(read_load_file(TemporaryFile(mark + "# ring radius: 0.03 (m)\n0 1 0\n1 0 -1\n", ".dat").name)
              .rings()
              .front()
              .radius,
            0.03);
  for (const std::string utf16 : { "\xFF\xFEs\0u\0b\0", "\xFE\xFF\0s\0u\0b" })
  {
    expect_refused_study(utf16, ".prm", "UTF-16");
    expect_refused_study(utf16, ".json", "UTF-16");
    expect_sentence_of([&] { read_load_file(TemporaryFile(utf16, ".dat").name); }, "UTF-16");
  }
}

TEST(TextReader, TakesSemicolonsWithDecimalCommas)
{
  const std::vector<FileColumn> columns = { { { "r" }, "m" }, { { "z" }, "m" } };
  const auto rows = [&](const std::string &text)
  { return read_column_file("Profile", TemporaryFile(text, ".csv").name, columns); };
  for (const std::string text : { "r (mm);z (mm)\r\n4,007;3,058\r\n-5;1,5e1\r\n",
                                  "4.007e-3; 3.058e-3\n-5e-3;0,015", "r mm\tz mm\n4,007\t3,058\n-5\t15\n" })
  {
    SCOPED_TRACE(text);
    ASSERT_EQ(rows(text).size(), 2u);
    EXPECT_DOUBLE_EQ(rows(text)[0].values[0], 4.007e-3);
    EXPECT_DOUBLE_EQ(rows(text)[0].values[1], 3.058e-3);
    EXPECT_DOUBLE_EQ(rows(text)[1].values[0], -5e-3);
    EXPECT_DOUBLE_EQ(rows(text)[1].values[1], 15e-3);
  }
  expect_sentence_of([&] { rows("4,007,3,058\n"); }, "the row has 4 cells");
  expect_sentence_of([&] { rows("1,000,5;2\n"); },
                     "line 1, column 1: \"1,000,5\" is not a number"); // thousands
  expect_sentence_of([&] { rows("x,y\n1,2\n"); }, "the header \"x, y\" does not name the columns r, z");
}

TEST(TextReader, SaysWhereJsonIsBroken)
{
  expect_refused_study("{\"Glass\": {\n  \"Contact radius\": 0.03,\n", ".json",
                       "line 3, column 1: the JSON ends");
  expect_refused_study("{\"Glass\": {\n  \"Contact radius\" 0.03}}\n", ".json", "line 2, column 23");
  expect_refused_study("[1, 2]", ".json", "is not a JSON object");
  expect_refused_study("{\"Motion\": {\"Mass\": 1e999}}", ".json", "no computer holds");
}

TEST(TextReader, RefusesJsonThatIsNestedDeeply)
{
  expect_refused_study("{\"Motion\": {\"Mass\": " + repeated("[", 490000) + "}}", ".json",
                       "nested more than 100");
  expect_refused_study(repeated("{\"a\":", 100000), ".json", "nested more than 100");
  EXPECT_EQ(
    parse_json("text", "{\"a\": \"" + repeated("[", 1000) + "\\\"[\"}")["a"].get<std::string>().size(),
    1002u); // not within strings
}

TEST(TextReader, NamesTheNumbersThatNoGlassHas)
{
  const auto refuse = [](const std::string &assignment, const std::string &part)
  { expect_sentence_of([&] { read_study("", { assignment }); }, part); };
  refuse("Motion/Mass=1e300 Gg", "Motion/Mass = 1e306 kg is more than a billion times outside");
  refuse("Motion/Orbit radius=1e-300", "Motion/Orbit radius");
  refuse("Glass/Rim waviness=2: 1e308", "amplitudes below 1 m");
  EXPECT_EQ(read_study("", { "Motion/Grip torque=0" }).motion.grip_torque, 0);
}

TEST(TextReader, LoadFilesAreOfOneRingAndAnyTablesLoad)
{
  const auto refuse = [](const std::string &text, const std::string &part)
  { expect_sentence_of([&] { read_load_file(TemporaryFile(text, ".dat").name); }, part); };
  const std::string ring = "# ring radius: 0.03 (m)\n";
  refuse(ring + "0 1 0\n# ring radius: 0.04 (m)\n1 0 -1\n", "line 3: the ring radius is given a second time");
  refuse("# ring radius: x (m)\n0 1 0\n1 0 -1\n", "line 1");
  refuse(ring + "0 1e308 0\n1 0 -1\n", "line 2: a coefficient of 1e308");
  refuse(ring + "0 0.4 0\n1 0 -0.1\n2 1e6 0\n", "line 4: a coefficient of 1e6");
  EXPECT_EQ(read_load_file(TemporaryFile(ring + "0 0.4 0\n1 0 -0.1\n2 400 0\n", ".dat").name).a(2), 400);
}

TEST(TextReader, AProfileOfTooManyPointsIsRefusedAtOnce)
{
  std::string zigzag = "r (mm), z (mm)\n0, 2\n";
  for (int i = 1; i < 60000; ++i)
    zigzag += std::to_string(i * 5e-4) + (i % 2 == 0 ? ", 2\n" : ", 2.1\n");
  const TemporaryFile file(zigzag, ".csv");
  expect_sentence_of(
    [&] {
      read_study("", { "Glass/Shape=profile", "Glass/Profile file=" + file.name });
    },
    "60000 points is finer");
}

TEST(TextReader, AllPathsStartAtTheStudyFile)
{
  // Which entries are paths, the entries say: a new one cannot be forgotten.
  const std::filesystem::path folder = testing::TempDir() + "stemware_paths_" + std::to_string(getpid());
  std::filesystem::create_directories(folder / "sub");
  std::ofstream(folder / "sub/study.prm")
    << "subsection Contact\n  set Body = solid\n  set Mesh file = foot.msh\nend\n";
  std::ofstream(folder / "sub/foot.msh") << "read later";
  const Study study = read_study((folder / "sub/study.prm").string());
  const std::string file = (folder / "sub/foot.msh").lexically_normal().string();
  EXPECT_EQ(study.contact.mesh_file, file);
  EXPECT_EQ(with_paths_from(folder / "results", study).contact.mesh_file, "../sub/foot.msh");
  EXPECT_EQ(files_of(study), std::vector<std::string>{ file });
  Study any;
  unsigned int n_paths = 0;
  for (const StudyEntry &entry : study_entries(any))
  {
    const std::string words = boost::to_lower_copy(entry.name);
    EXPECT_EQ(boost::ends_with(words, "file"), entry.path_value != nullptr) << entry.path();
    n_paths += entry.path_value != nullptr;
  }
  EXPECT_GE(n_paths, 5u);
  std::filesystem::remove_all(folder);
}

} // namespace
} // namespace stemware::pipeline
