// A drawn profile whose points scatter, in the results of `run`: answer, table, pictures and summary.json.
#include "fem/pipeline/report/profile_results.h"
#include "fem/pipeline/report/run_results.h"
#include "fem/pipeline/study/profile_file.h"
#include "fem/pipeline/study/study_file.h"
#include "tests/fem/pipeline/program_runner.h"
#include "tests/fem/pipeline/report/hand_made_studies.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace stemware::pipeline
{
namespace
{

using namespace test;

/// A run by hand of a foot that was drawn with seven points of its rim.
struct RunOfAProfile : RunByHand
{
  RunOfAProfile()
  {
    const ScratchFolder scratch;
    study.glass = read_study("", { "Glass/Shape=profile", "Glass/Land width=2 mm",
                                   "Glass/Profile file=" + scratch.write("foot.csv", points) })
                    .glass;
    report.foot->section = { { { 0.02, 0 }, { 0.034, 0 }, { 0.034, 0.002 }, { 0.02, 0.002 } } };
    report.load.inner_radius = 0.0298;
    report.load.outer_radius = 0.0302;
    spin.rows.back().terminal->omega = -3.71184;
    spin.profile_scatter = ProfileScatter{ 0.0351, 130., 54., "" };
  }

  Results results() const { return tabulate(study, report, spin, bands); }

  const std::string points =
    "r (mm), z (mm)\n0, 3\n20, 2\n29.2, 0.13\n29.5, 0.02\n29.8, 0.03\n30, 0.01\n30.2, -0.01\n30.5, 0.06\n"
    "30.8, 0.09\n34, 2\n34, 4\n6, 8\n5, 16\n0, 16\n";
};

TEST(ProfileResults, AnswerHasTheDigitsOfTheScatter)
{
  const RunOfAProfile run;
  const std::string answer = run.results().report.answer;
  EXPECT_NE(answer.find("is -3.712 ± 0.035 rad/s (scatter of the profile)"), std::string::npos) << answer;
  EXPECT_NE(answer.find("The rim follows from the points of its profile: R = "), std::string::npos) << answer;
  EXPECT_NE(answer.find(fitted_rim(run.study)), std::string::npos) << answer;
  EXPECT_NE(answer.find(", 7 points)."), std::string::npos) << answer;
  EXPECT_NE(answer.find("The crown is not determined"), std::string::npos) << answer;

  RunOfAProfile narrow;
  narrow.spin.profile_scatter->spin = 1e-7; // the band is wider
  EXPECT_EQ(narrow.results().report.answer.find("rad/s (scatter of the profile)"), std::string::npos);
}

TEST(ProfileResults, ScatterStandsBesideTheBands)
{
  const RunOfAProfile run;
  const Results results = run.results();
  const std::string console = console_tables(results);
  EXPECT_NE(console.find("scatter of the profile"), std::string::npos) << console;
  EXPECT_NE(console.find("3.6e-02"), std::string::npos) << console; // rounded up, as bands are
  const std::string section = report_lines(results, "The steps in numbers");
  EXPECT_NE(section.find("scatter of the profile"), std::string::npos) << section;

  // It is no row of the budget.
  EXPECT_EQ(results.findings.summary["budget"].size(), made_run().findings.summary["budget"].size());
  EXPECT_EQ(results.findings.key_figures["omega_terminal_profile_error"], 0.0351);
  EXPECT_FALSE(made_run().findings.key_figures.contains("omega_terminal_profile_error"));
}

TEST(ProfileResults, PointsAndCircleAreDrawn)
{
  const RunOfAProfile run;
  const Results results = run.results();
  const std::string circle = plot_data(results, "rim_circle");
  EXPECT_EQ(plot_of(results, "rim_residuals").data_file, "figures/rim_circle.dat");
  const fem::RimCircle &fitted = *run.study.glass.rim_circle;
  ASSERT_EQ(fitted.points.size(), 7u);
  EXPECT_NE(circle.find("0.0295"), std::string::npos) << circle;
  EXPECT_NE(circle.find("0.0302"), std::string::npos) << circle;
  const std::string foot = report_lines(results, "The section and the rim", true);
  EXPECT_NE(foot.find("points of the land | 7"), std::string::npos) << foot;
}

TEST(ProfileResults, SummaryHasTheCovariance)
{
  const RunOfAProfile run;
  const nlohmann::ordered_json profile = run.results().findings.summary["profile"];
  const fem::RimCircle &fitted = *run.study.glass.rim_circle;
  EXPECT_EQ(profile["contact_radius"], fitted.contact_radius);
  EXPECT_EQ(profile["covariance"][0][1], fitted.covariance[0][1]);
  EXPECT_EQ(profile["crown_radius_error"], fitted.crown_radius_error());
  EXPECT_EQ(profile["scatter"], fitted.scatter);
  EXPECT_EQ(profile["points"], 14);
  EXPECT_EQ(profile["rim_points"], 7);
  EXPECT_EQ(profile["omega_terminal_error"], 0.0351);
  EXPECT_EQ(profile["omega_by_contact_radius"], 130);
  EXPECT_EQ(profile["crown_determined"], false);
  EXPECT_NEAR(profile["sag_over_contact"].get<double>(), 0.02e-6 / fitted.crown_radius, 1e-15);
  EXPECT_FALSE(made_run().findings.summary.contains("profile"));
}

} // namespace
} // namespace stemware::pipeline
