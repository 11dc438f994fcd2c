#include "fem/pipeline/analysis/ring_quantities.h"
#include "fem/pipeline/analysis/sweep_case.h"
#include "fem/pipeline/result/number_format.h"
#include "fem/pipeline/result/sentences.h"
#include "tests/fem/pipeline/analysis/quick_studies.h"
#include "tests/fem/pipeline/analysis/solved_run.h"

#include <gtest/gtest.h>

#include <string>

namespace stemware::pipeline
{
namespace
{

using namespace test;

ring::Answer answer_with(unsigned int harmonics, double omega)
{
  ring::Answer row;
  row.harmonics = harmonics;
  row.at_rest = row.at_terminal = ring::RingState{ {}, ring::RingStack({ 0.5, 0.1 }, { 0, 0.2 }, 0.03) };
  row.at_rest->moment_ratio = 1.2;
  row.at_rest->friction.torque = -1e-3;
  row.terminal = ring::TerminalSpin{ omega, -1e-3, 0.3, true };
  row.status = ring::Status::lift_off;
  row.relative_change = 0;
  return row;
}

struct SpunStudy : StudyAnswer
{
  SpunStudy()
  {
    spin.rows.by_harmonics = { { {}, answer_with(1, -3.4) }, { {}, answer_with(2, -3.25) } };
    budget.emplace();
    budget->rows = { { { 1 }, "paper", 1, -3. },
                     { { 2 }, "moment balance", 1, -3.5, -0.5 },
                     { { 3 }, "where the foot touches", 1, -3.4, 0.1 },
                     { { 4 }, "harmonics", {}, -3.25, 0.15 } };
    budget->without = { { "tilt", -3.24, 0.01, "" },
                        { "grip", -3.3, -0.05, "" },
                        { "compliance of the interface", {}, {}, "not defined" } };
    budget->inputs = { { "0.05 more friction", 0.0801 } };
    bands = { { { "omega_terminal", "terminal spin", "rad/s", -3.25, 1e-9 }, 0.00123, -3.25 } };
  }

  std::string answer() const { return run_words(*this)["answer"]; }
};

void expect_all(const std::string &text, const std::vector<std::string> &numbers)
{
  for (const std::string &number : numbers)
    EXPECT_NE(text.find(number), std::string::npos) << number << " in " << text;
}

TEST(RunAnswer, ContainsTheNumbersOfTheAnalysis)
{
  // One turn takes 2 pi / |omega| = 1.93 s (paper: 2.09 s). Largest step of the budget: from -3 to -3.5
  // rad/s.
  expect_all(SpunStudy().answer(), { " 1.93 s", " 2.09 s", "-3.250 rad/s (± 1.3e-03 rad/s by", "-3.000 rad/s",
                                     "0.05 more friction by +0.08 rad/s", "4.41 % slower", "+0.15 rad/s",
                                     "-0.5 rad/s (16.7 % faster)" });
  SpunStudy falling;
  ring::Answer &all = falling.spin.rows.by_harmonics.back().row;
  all.fall = all.at_rest;
  all.fall->omega = -9.1234;
  all.fall->moment_ratio = 1.6789;
  all.at_rest->moment_ratio = 1.4321;
  all.at_rest->friction.torque = -0.0012345;
  all.terminal.reset();
  all.at_terminal.reset();
  all.status = ring::Status::tips;
  expect_all(falling.answer(), { "9.12 rad/s", "1.68", "1.432", "-0.001234 N m", "2.09 s" });
}

TEST(RunAnswer, ShowsTheHarmonicEffectAtLowOrbitSpeedsAndABoundIfItIsRoundingError)
{
  // The slip ratio is proportional to v^2 and only 8e-9 at 0.1 mm/s.
  Study study = quick_contact_study();
  std::optional<double> usual;
  for (const double speed : { 1e-2, 1e-4 })
  {
    SCOPED_TRACE(speed);
    study.motion.orbit.orbit_speed = speed;
    fem::ComplianceCache cache;
    const CaseResult solved = case_result(study, ThreadedExecutor(cache));
    const auto value = [&](const std::string &key) { return solved.value(key).value(); };
    const HarmonicEffect effect = { value("harmonic_effect"), value("harmonic_effect_relative") };
    EXPECT_NEAR(*effect.relative, usual.value_or(*effect.relative), 1e-5 * std::abs(*effect.relative));
    usual = effect.relative;
    const std::string sentence = harmonic_effect_sentence(study, effect);
    EXPECT_NE(sentence.find("% slower ("), std::string::npos) << sentence;
    EXPECT_TRUE(study.is_spin(*effect.absolute)); // above rounding, so the table shows the effect
    EXPECT_TRUE(study.is_spin(value("omega_terminal")));
  }
  // An upper bound replaces the percentage of a change below rounding.
  const HarmonicEffect none = harmonic_effect(-1e-11, -1e-11 - 1e-19, study.spin_scale());
  const std::string nothing = harmonic_effect_sentence(study, none);
  EXPECT_NE(nothing.find("less than 3.3e-18 rad/s."), std::string::npos) << nothing;
}

TEST(RunAnswer, OmitsThePercentageIfTheSpinChangesSign)
{
  SpunStudy turned;
  turned.budget->rows[1].omega_terminal = 3.5;
  turned.budget->rows[1].difference = 6.5; // the difference from -3 to a positive spin
  turned.spin.rows.by_harmonics.front().row.terminal->omega = 3.4;
  EXPECT_FALSE(harmonic_effect(turned.spin.rows).relative);
  EXPECT_NE(turned.answer().find("by -6.65 rad/s."), std::string::npos) << turned.answer();
  EXPECT_NE(turned.answer().find("\"moment balance\": +6.5 rad/s."), std::string::npos) << turned.answer();
}

TEST(RunAnswer, StatesTheSenseOfTheSpin)
{
  SpunStudy spun;
  const auto begins = [&](double omega, ring::OrbitSense sense)
  {
    spun.spin.rows.by_harmonics.back().row.terminal->omega = omega;
    spun.study.motion.orbit.orbit_sense = sense;
    const std::string answer = spun.answer();
    const auto sense_at = answer.find(" s, ") + 4;
    return answer.substr(sense_at, answer.find(". ") - sense_at);
  };
  using ring::OrbitSense;
  EXPECT_EQ(begins(-2, OrbitSense::counterclockwise), "clockwise, against its orbit");
  EXPECT_EQ(begins(2, OrbitSense::counterclockwise), "counter-clockwise, with its orbit");
  EXPECT_EQ(begins(-2, OrbitSense::clockwise), "clockwise, with its orbit");
  EXPECT_EQ(begins(2, OrbitSense::clockwise), "counter-clockwise, against its orbit");
}

TEST(RunAnswer, OmitsThePercentageIfThereIsNoSpin)
{
  SpunStudy resting;
  resting.spin.rows.by_harmonics.back().row.terminal->omega = 1e-13;
  EXPECT_EQ(resting.answer().find('%'), std::string::npos) << resting.answer();
  expect_all(resting.answer(), { "not spin" });
}

TEST(RunAnswer, PrintedIntervalContainsTheErrorBand)
{
  for (const double band : { 0.00123, 0.000996, 9.99e-5, 0.12, 3. })
    for (const double value : { -3.2549, -3.25451, 1.000049 })
    {
      const std::string text = format::with_band(value, band);
      const double printed = std::stod(text), half = std::stod(text.substr(text.find("± ") + 3));
      EXPECT_LE(printed - half, value - band + 1e-12) << text;
      EXPECT_GE(printed + half, value + band - 1e-12) << text;
      EXPECT_LE(half, 1.2 * band) << text;
    }
}

TEST(Remarks, WarnOnlyIfASoftLayerIsThickerThanTheContactIsWide)
{
  SolvedRun run(quick_contact_study());
  const auto remark = [&](double half_width)
  {
    run.contact.load.inner_radius = 0.03 - half_width;
    run.contact.load.outer_radius = 0.03 + half_width;
    return std::get<std::string>(run.results().console.front()).find("(Table/Layer thickness)") !=
           std::string::npos;
  };
  EXPECT_FALSE(remark(2e-4)); // layer thickness not given
  run.study.table.layer_thickness = 5e-3;
  EXPECT_TRUE(remark(2e-4));
  EXPECT_FALSE(remark(6e-3));
  run.study.table.interface = TableInterface::hard;
  EXPECT_FALSE(remark(2e-4));
}

TEST(Remarks, ReportTheScatterOfAProfileOnlyAboveRounding)
{
  SpunStudy run;
  const auto answer = [&] { return run.answer(); };
  const std::string page = "docs/cookbooks/own_profile.md";
  EXPECT_EQ(answer().find(page), std::string::npos);
  run.study.glass.rim_circle = fem::RimCircle{ 0.03, 0.003, 19e-6, 10 };
  EXPECT_NE(answer().find("19 µm rms"), std::string::npos) << answer();
  EXPECT_NE(answer().find(page), std::string::npos) << answer();
  run.study.glass.rim_circle->rms_distance = 1e-11; // scatter at rounding level
  EXPECT_EQ(answer().find(page), std::string::npos);
}

} // namespace
} // namespace stemware::pipeline
