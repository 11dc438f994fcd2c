// What the scatter of a scanned rim does to the spin, against the spin of the rim that the points were
// scattered from, which is given by its two lengths and needs no points.
#include "fem/pipeline/analysis/profile_scatter.h"
#include "fem/pipeline/report/document.h"
#include "fem/pipeline/report/profile_results.h"
#include "fem/pipeline/study/profile_file.h"
#include "fem/pipeline/study/study_file.h"
#include "tests/fem/pipeline/analysis/solved_study.h"
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fmt/format.h>
#include <random>

namespace stemware::pipeline
{
namespace
{

constexpr double true_radius = 0.030, true_crown = 0.003;

/// A foot in mm whose 61 points have Gaussian errors of @p error mm in height: 45 on its underside, those of
/// the cookbook's foot on the top and the stem.
std::string scanned_foot(double error, unsigned int seed)
{
  std::mt19937 generator(seed);
  std::normal_distribution<double> scatter(0, error);
  std::string points = "r (mm), z (mm)\n0, 3\n";
  const auto crown = [](double offset) { return 3 - std::sqrt(9 - offset * offset); };
  const auto add = [&](double radius, double height)
  { points += fmt::format("{:.9g}, {:.9g}\n", radius, height + scatter(generator)); };
  for (int i = 1; i <= 22; ++i) // the hollow below, to where the rim's rounding begins
  {
    const double share = i / 22., begin = crown(0.9);
    add(28.8 * share + 0.3 * (share - share * share), begin + (3 - begin) * std::pow(1 - share * share, 2));
  }
  for (int i = 0; i < 14; ++i)
    add(29.17 + 0.128 * i, crown(29.17 + 0.128 * i - 30));
  for (int i = 0; i < 8; ++i)
    add(31.1 + 0.33 * i, 0.2 + 0.35 * (0.33 * i));
  points += "33.973, 1.543\n33.973, 1.957\n33.766, 2.316\n33.407, 2.523\n28, 3.39\n23, 4.131\n18, 4.872\n"
            "13.5, 5.54\n9.267, 6.167\n7.589, 6.733\n6.214, 7.847\n5.313, 9.371\n5.079, 10.228\n"
            "5, 11.113\n5, 17\n0, 17\n";
  return points;
}

/// A foot that is rigid, on few lines: a contact takes milliseconds.
Study quick_study(const std::string &file, const std::vector<std::string> &more = {})
{
  std::vector<std::string> entries = { "Glass/Shape=profile",      "Glass/Profile file=" + file,
                                       "Glass/Land width=0.0017",  "Contact/Harmonics=4",
                                       "Contact/Azimuth lines=64", "Contact/Load harmonics=8" };
  entries.insert(entries.end(), more.begin(), more.end());
  Study study = read_study("", entries);
  study.model.foot_is_rigid = true;
  return study;
}

/// Six scans of one foot: their spins scatter about that of the foot as their standard errors say.
TEST(ProfileScatter, SpinsOfScansScatterAsTheirErrorsSay)
{
  const test::ScratchFolder scratch;
  const std::string exact = scratch.write("exact.csv", scanned_foot(0, 0));
  const double truth =
    test::SolvedStudy(quick_study(exact, { "Glass/Contact radius=30 mm", "Glass/Crown radius=3 mm" }))
      .omega();
  constexpr unsigned int n_seeds = 6;
  double sum = 0, spread = 0;
  for (unsigned int seed = 1; seed <= n_seeds; ++seed)
  {
    test::SolvedStudy scan(quick_study(scratch.write("scan.csv", scanned_foot(0.02, seed))));
    const auto scatter = profile_scatter(scan.study, scan.row, scan.cache);
    ASSERT_TRUE(scatter && scatter->spin) << seed;
    const double deviation = (scan.omega() - truth) / *scatter->spin;
    sum += deviation * deviation;
    spread += std::pow(scan.omega() - truth, 2);
    RecordProperty(fmt::format("scan_{}", seed),
                   fmt::format("{:.4f} +- {:.4f}, {:.2f}", scan.omega(), *scatter->spin, deviation));
  }
  EXPECT_GT(std::sqrt(sum / n_seeds), 0.5);
  EXPECT_LT(std::sqrt(sum / n_seeds), 1.7);
  EXPECT_GT(std::sqrt(spread / n_seeds), 0.003); // hundreds of error bands
}

/// sigma^2 = g^T C g with derivatives that are found here, by one-sided differences of entries.
TEST(ProfileScatter, IsTheGradientTimesTheCovariance)
{
  const test::ScratchFolder scratch;
  test::SolvedStudy scan(quick_study(scratch.write("scan.csv", scanned_foot(0.002, 3))));
  const auto scatter = profile_scatter(scan.study, scan.row, scan.cache);
  ASSERT_TRUE(scatter && scatter->spin);
  const fem::RimCircle &circle = *scan.study.glass.rim_circle;
  const auto spin_at = [&](double radius, double crown)
  {
    return test::SolvedStudy(
             quick_study(scratch.path() / "scan.csv", { fmt::format("Glass/Contact radius={:.12g}", radius),
                                                        fmt::format("Glass/Crown radius={:.12g}", crown) }))
      .omega();
  };
  const double step = 1e-5;
  const double by_radius = (spin_at(circle.contact_radius + step, circle.crown_radius) - scan.omega()) / step;
  const double by_crown = (spin_at(circle.contact_radius, circle.crown_radius + step) - scan.omega()) / step;
  EXPECT_NEAR(*scatter->by_contact_radius, by_radius, 0.02 * std::abs(by_radius));
  EXPECT_NEAR(*scatter->by_crown_radius, by_crown, 0.03 * std::abs(by_crown));
  const double variance = by_radius * by_radius * circle.covariance[0][0] +
                          2 * by_radius * by_crown * circle.covariance[0][1] +
                          by_crown * by_crown * circle.covariance[1][1];
  EXPECT_NEAR(*scatter->spin, std::sqrt(variance), 0.03 * std::sqrt(variance));
}

TEST(ProfileScatter, ThereIsNoneOfARimThatIsGiven)
{
  const test::ScratchFolder scratch;
  const std::string file = scratch.write("scan.csv", scanned_foot(0.02, 1));
  test::SolvedStudy given(quick_study(file, { "Glass/Contact radius=30 mm", "Glass/Crown radius=3 mm" }));
  EXPECT_FALSE(profile_scatter(given.study, given.row, given.cache));
  EXPECT_TRUE(profile_facts(given.study, given.load.report(), {}, 1e-5).is_null());

  // Of one that is given, only the other counts.
  test::SolvedStudy half(quick_study(file, { "Glass/Contact radius=30 mm" }));
  const auto scatter = profile_scatter(half.study, half.row, half.cache);
  ASSERT_TRUE(scatter && scatter->spin);
  EXPECT_FALSE(scatter->by_contact_radius);
  EXPECT_NEAR(*scatter->spin,
              std::abs(*scatter->by_crown_radius) * half.study.glass.rim_circle->crown_radius_error(), 1e-12);
}

/// Over a contact 0.4 mm wide a crown of 3 mm rises by 7 um: 20 um of scatter hide that, 0.2 um do not.
TEST(ProfileScatter, CrownIsNotDeterminedWhereItRisesLessThanThePointsScatter)
{
  const test::ScratchFolder scratch;
  for (const double error : { 0.02, 0.0002 })
  {
    const Study study = quick_study(scratch.write("scan.csv", scanned_foot(error, 2)));
    LoadReport load;
    load.inner_radius = study.glass.profile.contact_radius - 0.2e-3;
    load.outer_radius = study.glass.profile.contact_radius + 0.2e-3;
    EXPECT_NEAR(sag_over_contact(study, load), 0.02e-6 / study.glass.profile.crown_radius, 1e-15);
    const nlohmann::ordered_json facts = { { "scattered_profile",
                                             profile_facts(study, load, ProfileScatter{ 0.035 }, 1.2e-5) } };
    const std::string remark = shown({ {}, facts }, "profile").report.answer;
    EXPECT_NE(remark.find(fitted_rim(study)), std::string::npos) << remark;
    EXPECT_NE(remark.find("± 0.035 rad/s (scatter of the profile, one standard error), beside a band of the "
                          "discretisation of ± 1.2e-05."),
              std::string::npos)
      << remark;
    const bool is_hidden = error > 1e-3;
    EXPECT_EQ(remark.find("crown is not determined") != std::string::npos, is_hidden) << remark;
    EXPECT_EQ(profile_summary(study, load, {})["crown_determined"], !is_hidden);
  }
}

} // namespace
} // namespace stemware::pipeline
