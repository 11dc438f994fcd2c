// What is said about cases whose results are known; sweep_results_test.cc has the tables.
#include "fem/pipeline/report/document.h"
#include "fem/pipeline/report/sweep_results.h"
#include "fem/pipeline/support/console.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <stdexcept>

namespace stemware::pipeline
{
namespace
{

CaseResult with_spin(double spin, double effect)
{
  CaseResult result;
  result.outcome = "converged";
  result.values.assign(sweep_quantities().size(), 0.5);
  result.values[quantity_index("terminal spin")] = spin;
  result.values[quantity_index("harmonic effect")] = effect;
  result.values[quantity_index("closure effect")] = std::nullopt;
  result.values[quantity_index(spin_of_fall)] = std::nullopt;
  result.values[quantity_index("moment ratio at which it falls over")] = std::nullopt;
  return result;
}

CaseResult failed(const std::string &message)
{
  CaseResult result;
  result.message = message;
  return result;
}

SweepPlan grid_of_four()
{
  SweepRequest request;
  request.varied = { "Load/Moment ratio=1,1.5", "Motion/Closure=paper,full" };
  return make_plan(request);
}

FinishedCases four_cases()
{
  return { { 0, with_spin(-3, 1) },
           { 1, with_spin(-5, -2) },
           { 2, failed("No contact, \"tipping\".") },
           { 3, with_spin(-4, 0.25) } };
}

/// What the report says first.
std::string answer_of(const SweepPlan &plan, const SweepFindings &findings)
{
  return shown({ {}, sweep_facts(plan, findings) }, "sweep_answer").report.answer;
}

TEST(SweepFindings, RangesNameTheirCases)
{
  const SweepFindings findings = find_out(grid_of_four(), four_cases());
  EXPECT_EQ(findings.n_failed, 1u);
  EXPECT_EQ(findings.first_failure, 2u);
  const QuantityFindings *spin = findings.about("terminal spin");
  ASSERT_NE(spin, nullptr);
  EXPECT_EQ(spin->n_values, 3u);
  EXPECT_EQ(spin->least, -5);
  EXPECT_EQ(spin->least_case, 1u);
  EXPECT_EQ(spin->most, -3);
  EXPECT_EQ(spin->most_case, 0u);
  EXPECT_FALSE(spin->band);
  EXPECT_EQ(findings.about("closure effect"), nullptr);
  const auto summary = tabulate(grid_of_four(), four_cases(), findings).findings.summary;
  EXPECT_EQ(summary["quantities"]["terminal spin"]["least_case"], 2);
  EXPECT_EQ(summary["sweep"]["failed"], 1);
  EXPECT_EQ(
    answer_of(grid_of_four(), findings),
    "In 3 cases the glass spins up to between -5 rad/s (Load/Moment ratio = 1, Motion/Closure = full) and -3 "
    "rad/s "
    "(Load/Moment ratio = 1, Motion/Closure = paper). The harmonics of the load beyond the first make it up "
    "to 1 % "
    "faster (Load/Moment ratio = 1, Motion/Closure = paper) and up to 2 % slower (Load/Moment ratio = 1, "
    "Motion/Closure = full). 1 of 4 cases failed; the column message of sweep.csv says why.");
}

TEST(SweepFindings, CasesThatFallOverAreNoFailures)
{
  const SweepPlan plan = grid_of_four();
  FinishedCases cases = {
    { 0, with_spin(-3, 1) }, { 1, with_spin(-5, 1) }, { 2, with_spin(-4, 1) }, { 3, with_spin(-6, 1) }
  };
  cases.at(3).values[quantity_index("terminal spin")] = std::nullopt;
  cases.at(3).values[quantity_index(spin_of_fall)] = -6;
  const SweepFindings findings = find_out(plan, cases);
  EXPECT_EQ(findings.n_failed, 0u);
  EXPECT_EQ(findings.about("terminal spin")->n_values, 3u);
  EXPECT_EQ(answer_of(plan, findings).substr(0, 133),
            "In 1 of 4 cases the glass stands at rest and falls over on the way (Load/Moment ratio = 1.5, "
            "Motion/Closure = full); it has no termin");
  EXPECT_FALSE(tabulate(plan, cases, findings).files.empty());
}

/// nan among the values of the plot of the terminal spin, in a sweep of an entry from -1 to 1; with the
/// caption in
/// @p caption.
std::size_t n_gaps(const std::function<double(double)> &spin_at,
                   const std::string &varied = "Motion/Force offset=-1:1:41", std::string *caption = nullptr)
{
  SweepRequest request;
  request.varied = { varied };
  const SweepPlan plan = make_plan(request);
  FinishedCases cases;
  for (std::size_t i = 0; i < plan.cases.size(); ++i)
  {
    const double spin = spin_at(std::stod(plan.cases[i][0]));
    cases[i] = std::isnan(spin) ? failed("It tips.") : with_spin(spin, 0);
  }
  for (const ReportSection &section : tabulate(plan, cases, find_out(plan, cases)).report.sections)
    for (const Plot &plot : section.plots)
      if (plot.name == "terminal_spin")
      {
        if (caption)
          *caption = plot.caption;
        std::size_t n = 0;
        for (auto at = plot.data.find(" nan"); at != std::string::npos; at = plot.data.find(" nan", at + 1))
          ++n;
        return n;
      }
  throw std::logic_error("the terminal spin has no plot");
}

TEST(SweepFindings, CurvesBreakWhereTheyJumpAndNowhereElse)
{
  const auto sign = [](double x) { return x > 0 ? 1. : x < 0 ? -1. : 0.; };
  EXPECT_EQ(n_gaps([](double x) { return 3 * x; }), 0u);
  EXPECT_EQ(n_gaps([](double x) { return std::tanh(8 * x); }), 0u); // steep, but seen
  EXPECT_EQ(n_gaps([](double x) { return std::abs(x); }), 0u);      // a kink
  EXPECT_EQ(n_gaps([](double x) { return 0.1 / (1.1 + x); }), 0u);  // steep at its end
  EXPECT_EQ(n_gaps([&](double x) { return 5 * sign(x) + x; }), 2u); // on both sides of a value at 0
  EXPECT_EQ(n_gaps([&](double x) { return 5 * sign(x - 0.01) + x; }), 1u);
  EXPECT_EQ(n_gaps([&](double x) { return 1e-15 * x + std::abs(sign(x - 0.01) + 2); }),
            0u); // no slope beside
}

TEST(SweepFindings, ACoarseCurveIsNotDrawnThroughAChangeOfSign)
{
  // The spin of the first harmonic of docs/cookbooks/hand_height.prm: every step through zero is seven times
  // the one before, and nothing lies behind.
  const auto hand = [](double height)
  {
    return height > 0.015    ? std::nan("")
           : height > 0.005  ? 8.
           : height > -0.005 ? 0
                             : -4.4 - 60 * (height + 0.01);
  };
  std::string caption;
  const std::string coarse = "Motion/Force offset=-0.08:0.02:11",
                    remark = "Points without a line: the spin changes";
  EXPECT_EQ(n_gaps(hand, coarse, &caption),
            3u + 2u); // a case that fails in three curves, both sides of 0 in one
  EXPECT_NE(caption.find(remark), std::string::npos) << caption;
  EXPECT_EQ(n_gaps([](double x) { return x > 0 ? 3. : -2.; }, "Motion/Force offset=-1,1"), 1u);
  EXPECT_EQ(n_gaps([](double x) { return 5 * x + 0.1; }, "Motion/Force offset=-1:1:4", &caption), 0u);
  EXPECT_EQ(caption.find(remark), std::string::npos) << caption;
  EXPECT_EQ(n_gaps([](double x) { return std::max(-3 * x, 0.); }, coarse), 0u); // comes to rest
}

TEST(SweepFindings, PerCentOfTheBalanceIsLeftOutWhereTheSpinChangesItsSign)
{
  const std::size_t closure = quantity_index("closure effect");
  FinishedCases cases = { { 0, with_spin(-3, 1) }, { 1, with_spin(2, 1) } };
  cases[0].values[closure] = 17.9;
  cases[1].values[closure] = 1135.8;
  for (const auto &[index, result] : reported(cases))
    EXPECT_FALSE(result.values[closure]) << index;
  cases[1].values[quantity_index("terminal spin")] = -2;
  EXPECT_EQ(reported(cases).at(1).values[closure], 1135.8);
}

TEST(SweepFindings, SpinsThatChangeSignAreComparedInRadiansPerSecond)
{
  SweepRequest request;
  request.varied = { "Motion/Force offset=-1,1" };
  SweepPlan plan = make_plan(request);
  FinishedCases cases = { { 0, with_spin(-3, 1e9) }, { 1, with_spin(2, -1e9) } };
  cases[0].values[quantity_index("absolute harmonic effect")] = 0.25;
  cases[1].values[quantity_index("absolute harmonic effect")] = -0.125;
  const SweepFindings findings = find_out(plan, cases);
  EXPECT_TRUE(findings.spin_changes_sign());
  EXPECT_EQ(
    answer_of(plan, findings),
    "In 2 cases the glass spins up to between -3 rad/s (Motion/Force offset = -1 m) and 2 rad/s "
    "(Motion/Force offset = 1 m). The harmonics of the load beyond the first change it by between -0.125 "
    "rad/s (Motion/Force offset = 1 m) and +0.25 rad/s (Motion/Force offset = -1 m). For scale: what the "
    "paper's moment balance leaves out changes the spin of a first-harmonic load by +0.5 rad/s.");
  plan.base.load.moment_ratio = 0.5; // no balance acts
  EXPECT_EQ(answer_of(plan, findings).find("paper's moment balance"), std::string::npos);
  EXPECT_FALSE(find_out(grid_of_four(), four_cases()).spin_changes_sign());
}

TEST(SweepFindings, SharesOfTheVarianceNeedAHundredSamples)
{
  SweepRequest request;
  request.random = { "Load/Moment ratio=0.5+-10%", "Motion/Mass=0.2..0.4" };
  for (const unsigned int n_samples : { 99u, 100u })
  {
    request.n_samples = n_samples;
    const SweepPlan plan = make_plan(request);
    FinishedCases cases;
    for (std::size_t i = 0; i < plan.cases.size(); ++i)
      cases[i] = with_spin(std::pow(std::stod(plan.cases[i][0]) - 0.5, 2), 0); // no line fits
    const SweepFindings findings = find_out(plan, cases);
    const auto &sensitivity = findings.about("terminal spin")->sensitivity;
    ASSERT_TRUE(sensitivity);
    EXPECT_LT(sensitivity->r_squared, 0.5);
    EXPECT_EQ(sensitivity->first_order.empty(), n_samples < 100);
    const Results results = tabulate(plan, cases, findings);
    EXPECT_EQ(results.report.answer.find("of the variance is due to") == std::string::npos, n_samples < 100);
    EXPECT_EQ(
      results.findings
        .summary["quantities"]["terminal spin"]["sensitivity"]["entries"]["Load/Moment ratio"]["first_order"]
        .is_null(),
      n_samples < 100);
  }
}

TEST(SweepFindings, SpreadsByFactorsCountInTheLogarithm)
{
  SweepRequest request;
  request.random = { "Table/Foundation modulus=1e10*/2", "Motion/Mass=0.2..0.4" };
  request.n_samples = 400;
  const SweepPlan plan = make_plan(request);
  FinishedCases cases;
  for (std::size_t i = 0; i < plan.cases.size(); ++i)
    cases[i] = with_spin(-3 - 0.1 * std::log(std::stod(plan.cases[i][0]) / 1e10), 0);
  const SweepFindings findings = find_out(plan, cases);
  const QuantityFindings *spin = findings.about("terminal spin");
  ASSERT_TRUE(spin != nullptr && spin->band && spin->sensitivity);
  EXPECT_NEAR(spin->sensitivity->r_squared, 1, 1e-12);
  EXPECT_NEAR(spin->sensitivity->regression[0], -1, 1e-12);
  EXPECT_NEAR(spin->sensitivity->regression[1], 0, 1e-12);
  EXPECT_NEAR(spin->band->deviation, 0.1 * std::log(2.), 0.1 * std::log(2.) * 4 / std::sqrt(800.));
  EXPECT_FALSE(findings.about("harmonic effect")->sensitivity);
  EXPECT_NE(answer_of(plan, findings).find("due to Table/Foundation modulus alone"), std::string::npos);
}

TEST(WorkProgress, DurationsAreRoundedUpwards)
{
  EXPECT_EQ(rough_duration(0.2), "1 s");
  EXPECT_EQ(rough_duration(89.5), "90 s");
  EXPECT_EQ(rough_duration(91), "2 min");
  EXPECT_EQ(rough_duration(3600), "60 min");
  EXPECT_EQ(rough_duration(7200), "2.0 h");
}

} // namespace
} // namespace stemware::pipeline
