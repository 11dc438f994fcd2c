#include "fem/pipeline/base/json.h"
#include "fem/pipeline/study/data_files.h"
#include "fem/pipeline/study/study_file.h"
#include "tests/fem/pipeline/matchers.h"
#include "tests/fem/pipeline/refusal.h"
#include "tests/fem/scratch_folder.h"

#include <gtest/gtest.h>

namespace stemware::pipeline
{
namespace
{

using test::TemporaryFile;

template <typename Read>
void expect_sentence_of(const Read &read, const std::string &part)
{
  const std::string sentence = test::sentence_of(read);
  EXPECT_THAT(sentence, testing::HasSubstr(part));
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

TEST(TextReader, ReadsUtf8WithAByteOrderMarkAndRefusesUtf16)
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

TEST(TextReader, NamesJsonErrorsAndThePositionOfSyntaxErrors)
{
  expect_refused_study("{\"Glass\": {\n  \"Contact radius\": 0.03,\n", ".json",
                       "line 3, column 1: the JSON ends");
  expect_refused_study("{\"Glass\": {\n  \"Contact radius\" 0.03}}\n", ".json", "line 2, column 23");
  expect_refused_study("[1, 2]", ".json", "is not a JSON object");
  expect_refused_study("{\"Motion\": {\"Mass\": 1e999}}", ".json", "double precision");
}

TEST(TextReader, RefusesDeeplyNestedJsonButNotBracketsInStrings)
{
  expect_refused_study("{\"Motion\": {\"Mass\": " + repeated("[", 490000) + "}}", ".json",
                       "nested more than 100");
  expect_refused_study(repeated("{\"a\":", 100000), ".json", "nested more than 100");
  EXPECT_EQ(
    parse_json("text", "{\"a\": \"" + repeated("[", 1000) + "\\\"[\"}")["a"].get<std::string>().size(),
    1002u);
}

TEST(TextReader, RefusesImpossibleNumbersButNotZero)
{
  const auto refuse = [](const std::string &assignment, const std::string &part)
  { expect_sentence_of([&] { read_study("", { assignment }); }, part); };
  refuse("Motion/Mass=1e300 Gg", "Motion/Mass = 1e306 kg is more than a billion times outside");
  refuse("Motion/Orbit radius=1e-300", "Motion/Orbit radius");
  refuse("Glass/Rim waviness=2: 1e308", "amplitudes below 1 m");
  EXPECT_EQ(read_study("", { "Motion/Grip torque=0" }).motion.grip_torque, 0);
}

TEST(TextReader, RefusesAProfileWithTooManyPoints)
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

} // namespace
} // namespace stemware::pipeline
