#include "fem/pipeline/base/failures.h"
#include "fem/pipeline/study/data_files.h"
#include "fem/pipeline/study/study_checks.h"
#include "fem/pipeline/study/study_file.h"
#include "tests/fem/pipeline/matchers.h"
#include "tests/fem/pipeline/program_runner.h"
#include "tests/fem/pipeline/refusal.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fmt/format.h>

namespace stemware::pipeline
{
namespace
{

using test::ScratchFolder;

/// Points (r, z) of a foot with a flat land from 28 to 32 mm [mm].
const std::string plain_foot = "0, 2\n20, 2\n28, 0\n32, 0\n34, 1\n34, 3\n16, 4\n6, 8\n4, 16\n0, 16\n";
const std::string millimetres = "r (mm), z (mm)\n";

Study study_of(const ScratchFolder &scratch, const std::string &points, const std::vector<std::string> &more)
{
  std::vector<std::string> overrides = { "Glass/Shape=profile",
                                         "Glass/Profile file=" + scratch.write("my_foot.csv", points) };
  overrides.insert(overrides.end(), more.begin(), more.end());
  return read_study("", overrides);
}

Study study_of(const std::string &points,
               const std::vector<std::string> &more = { "Glass/Crown radius=0.003" })
{
  return study_of(ScratchFolder(), points, more);
}

std::string profile_refusal(const std::string &points,
                            const std::vector<std::string> &more = { "Glass/Crown radius=0.003" })
{
  return test::sentence_of([&] { study_of(points, more); });
}

TEST(ProfileFile, FitsTheRimUnlessItsRadiiAreGiven)
{
  std::string points = "0,3\n20,3\n";
  for (int i = -5; i <= 5; ++i)
    points += fmt::format("{},{}\n", 29.5 + 0.2 * i, 2.5 - std::sqrt(2.5 * 2.5 - 0.04 * i * i));
  points = millimetres + points + "34,2\n34,4\n6,8\n5,16\n0,16\n";
  const std::string land = "Glass/Land width=0.0021";
  const Study fitted = study_of(points, { land });
  EXPECT_NEAR(fitted.glass.profile.contact_radius, 0.0295, 1e-12);
  EXPECT_NEAR(fitted.glass.profile.crown_radius, 0.0025, 1e-9);
  ASSERT_TRUE(fitted.glass.rim_circle);
  EXPECT_EQ(fitted.glass.rim_circle->n_points, 11u);
  EXPECT_THAT(profile_note(fitted.glass),
              testing::HasSubstr("18 points; contact radius 0.0295 m, crown radius 0.0025 m"));
  EXPECT_THAT(profile_note(fitted.glass), testing::HasSubstr("through 11 points"));

  const Study given = study_of(points, { land, "Glass/Contact radius=0.0296", "Glass/Crown radius=0.004" });
  EXPECT_EQ(given.glass.profile.contact_radius, 0.0296);
  EXPECT_EQ(given.glass.profile.crown_radius, 0.004);
  EXPECT_THAT(profile_note(given.glass), testing::Not(testing::HasSubstr("circle")));
  EXPECT_FALSE(given.glass.rim_circle);
  EXPECT_EQ(profile_note(GlassSection()), "");
}

/// Returns the points of a foot with a rim at r = 29.5 mm of the crown radius 2.5 mm. The heights of the ten
/// points on the land have alternating errors of @p error [mm].
std::string scattered_foot(double error)
{
  std::string points = millimetres + "0,3\n20,3\n";
  for (int i = -5; i < 5; ++i)
  {
    const double offset = 0.2 * (i + 0.5);
    const double height = 2.5 - std::sqrt(2.5 * 2.5 - offset * offset) + (i % 2 == 0 ? error : -error);
    points += fmt::format("{},{}\n", 29.5 + offset, height);
  }
  return points + "34,2\n34,4\n6,8\n5,16\n0,16\n";
}

TEST(ProfileFile, RefusesBadFiles)
{
  const std::vector<std::pair<std::string, std::string>> bad = {
    { "", "has no rows" },
    { millimetres + "# nothing\n", "has no rows" },
    { "r,z\n" + plain_foot, "line 2: r = 0 m, z = 2 m" },
    { millimetres + "0, 2\n20, 6\n28, 0\n32, 0\n34, 1\n34, 3\n16, 4\n6, 8\n4, 16\n0, 16\n", "(line 3)" },
  };
  for (const auto &[points, words] : bad)
  {
    const std::string sentence = profile_refusal(points);
    EXPECT_THAT(sentence, testing::HasSubstr(words));
    EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
    EXPECT_EQ(sentence.back(), '.') << sentence;
    EXPECT_LT(sentence.size(), 500u) << sentence;
  }
  EXPECT_THAT(profile_refusal(millimetres + plain_foot, {}), testing::HasSubstr("circle"));
  EXPECT_THAT(profile_refusal(millimetres + plain_foot, { "Glass/Crown radius=0", "Glass/Land width=0.002" }),
              testing::HasSubstr("r = 0.028 m (line 4)"));
  EXPECT_THROW(read_study("", { "Glass/Shape=profile" }), BadInput);
  EXPECT_THROW(read_study("", { "Glass/Shape=profile", "Glass/Profile file=missing.csv" }), BadInput);
}

TEST(ProfileFile, ListsEntriesOfOtherShapesAsUnused)
{
  const Study study =
    study_of(millimetres + plain_foot,
             { "Glass/Crown radius=0.003", "Glass/Foot radius=0.05", "Glass/Fillet radius=0.002" });
  EXPECT_EQ(unused_entries(entries_of(study)),
            (std::vector<std::string>{ "Glass/Foot radius", "Glass/Fillet radius" }));
  EXPECT_EQ(unused_entries(entries_of(read_study("", { "Glass/Profile file=missing.csv" }))),
            std::vector<std::string>{ "Glass/Profile file" });
}

/// The study file of a results folder contains every entry, so the rim of a repeated study is given, not
/// fitted.
TEST(ProfileFile, WrittenStudyIsReadIdentically)
{
  const ScratchFolder scratch;
  const Study study = study_of(scratch, millimetres + plain_foot, { "Glass/Crown radius=0.003" });
  const Study again = read_study(scratch.write("again.prm", study_as_prm(study)), {});
  EXPECT_EQ(study_as_prm(again), study_as_prm(study));

  const Study fitted = study_of(scratch, scattered_foot(0.001), { "Glass/Land width=0.0021" });
  const Study repeated = read_study(scratch.write("again.prm", study_as_prm(fitted)), {});
  EXPECT_EQ(study_as_prm(repeated), study_as_prm(fitted));
  ASSERT_TRUE(fitted.glass.rim_circle);
  EXPECT_EQ(profile_note(repeated.glass), profile_note(fitted.glass));
}

} // namespace
} // namespace stemware::pipeline
