// The cases of a sweep: grids, samples, what is refused, and what tells one sweep from another.
#include "fem/pipeline/analysis/sweep/sweep_plan.h"
#include "fem/pipeline/study/study_file.h"
#include "fem/pipeline/support/failures.h"
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

namespace stemware::pipeline
{
namespace
{

using Values = std::vector<std::string>;

SweepPlan grid(const std::vector<std::string> &varied)
{
  SweepRequest request;
  request.varied = varied;
  return make_plan(request);
}

SweepPlan samples(const std::vector<std::string> &random, unsigned int n_samples)
{
  SweepRequest request;
  request.random = random;
  request.n_samples = n_samples;
  return make_plan(request);
}

TEST(SweepPlan, GridIsTheProductOfItsEntries)
{
  const SweepPlan plan = grid({ "Motion/Closure=paper,full", "Load/Moment ratio=0:1:3" });
  ASSERT_EQ(plan.cases.size(), 6u);
  EXPECT_EQ(plan.cases[0], (Values{ "paper", "0" }));
  EXPECT_EQ(plan.cases[1], (Values{ "paper", "0.5" }));
  EXPECT_EQ(plan.cases[5], (Values{ "full", "1" }));
  EXPECT_EQ(plan.entries[0].unit, "");
  EXPECT_EQ(plan.entries[1].unit, "1");
  EXPECT_EQ(grid({ "Table/Foundation modulus=1e8:1e9:2:log" }).entries[0].unit, "Pa/m");
  EXPECT_EQ(grid({ "Contact/Harmonics=4,8" }).entries[0].unit, "1");
}

TEST(SweepPlan, CasesAreTheBaseWithOtherValues)
{
  SweepPlan plan = grid({ "Motion/Mass=0.2,0.4", "Motion/Closure=hand,paper" });
  plan.base.motion.orbit.friction_coefficient = 0.7;
  const Study study = plan.study_of(2);
  EXPECT_EQ(study.motion.orbit.mass, 0.4);
  EXPECT_EQ(study.motion.closure, ring::Closure::hand);
  EXPECT_EQ(study.motion.orbit.friction_coefficient, 0.7);
  EXPECT_EQ(plan.base.motion.orbit.mass, Study().motion.orbit.mass);
}

TEST(SweepPlan, ACaseWhoseValuesDoNotGoTogetherSaysSoItself)
{
  const SweepPlan plan = grid({ "Contact/Load harmonics=8,200" });
  EXPECT_EQ(plan.study_of(0).contact.load_harmonics, 8u);
  try
  {
    plan.study_of(1);
    FAIL() << "more harmonics than the lines resolve were taken";
  }
  catch (const BadInput &refusal)
  {
    EXPECT_NE(std::string(refusal.what()).find("Contact/Load harmonics = 200 needs more than 400"),
              std::string::npos)
      << refusal.what();
  }
}

TEST(SweepPlan, SamplesAreValuesOfTheEntries)
{
  const SweepPlan plan = samples({ "Motion/Friction coefficient=0.2..0.4", "Motion/Mass=0.3+-5%" }, 50);
  ASSERT_EQ(plan.cases.size(), 50u);
  for (std::size_t i = 0; i < 50; ++i)
  {
    const Study study = plan.study_of(i);
    EXPECT_GT(study.motion.orbit.friction_coefficient, 0.2);
    EXPECT_LT(study.motion.orbit.friction_coefficient, 0.4);
    EXPECT_EQ(study.motion.orbit.mass, std::stod(plan.cases[i][1]));
  }
}

class BadPlan : public testing::TestWithParam<std::pair<SweepRequest, const char *>>
{
};

TEST_P(BadPlan, IsRefusedInOneSentence)
{
  const auto &[request, expected] = GetParam();
  try
  {
    make_plan(request);
    FAIL() << "taken";
  }
  catch (const BadInput &refusal)
  {
    const std::string sentence = refusal.what();
    EXPECT_NE(sentence.find(expected), std::string::npos) << sentence;
    EXPECT_EQ(sentence.find('\n'), std::string::npos);
  }
}

INSTANTIATE_TEST_SUITE_P(
  All, BadPlan,
  testing::Values(
    std::pair(SweepRequest{ {}, {}, 200, 1 }, "nothing to vary"),
    std::pair(SweepRequest{ { "Motion/Mass=1,2" }, { "Motion/Gravity=9..10" }, 200, 1 },
              "do not go together"),
    std::pair(SweepRequest{ { "Motion/Mas=1,2" }, {}, 200, 1 }, "did you mean Motion/Mass?"),
    std::pair(SweepRequest{ {}, { "Motion/Grvity=9..10" }, 200, 1 }, "did you mean Motion/Gravity?"),
    std::pair(SweepRequest{ { "Motion/Mass=1,2", "Motion/Mass=3,4" }, {}, 200, 1 },
              "varies Motion/Mass twice"),
    std::pair(
      SweepRequest{ { "Motion/Mass=1,2", "Motion/Gravity=9,10", "Motion/Orbit radius=1,2" }, {}, 200, 1 },
      "takes one or two"),
    std::pair(SweepRequest{ { "Motion/Mass=1:2:2000", "Motion/Gravity=1:2:2000" }, {}, 200, 1 },
              "has 4000000 cases, but at most 1000000 are possible"),
    std::pair(SweepRequest{ { "Motion/Mass=1:2:200", "Motion/Gravity=1:2:200" }, {}, 200, 1 },
              "or give --most-cases 40000"),
    std::pair(SweepRequest{ {}, { "Motion/Mass=1+-0.1" }, 20000, 1 }, "or give --most-cases 20000"),
    std::pair(SweepRequest{ { "Motion/Mass=200:400:3 mm" }, {}, 200, 1 }, "whole number of values"),
    std::pair(SweepRequest{ { "Motion/Mass=200:400 mm:3" }, {}, 200, 1 },
              "is a length, but a mass is needed"),
    std::pair(SweepRequest{ { "Motion/Mass=200 g:400:3" }, {}, 200, 1 },
              "a unit behind its first number only"),
    std::pair(SweepRequest{ {}, { "Motion/Mass=300 g+-15" }, 200, 1 }, "a unit behind its first number only"),
    std::pair(SweepRequest{ {}, { "Motion/Mass=300+-15 mm" }, 200, 1 }, "is a length, but a mass is needed"),
    std::pair(SweepRequest{ {}, { "Motion/Mass=1+-0.1" }, 1, 1 }, "--samples 1 is not allowed"),
    std::pair(SweepRequest{ { "Motion/Mass=0.1-0.5" }, {}, 200, 1 },
              "= 0.1-0.5 is not a number; did you mean \"Motion/Mass=0.1:0.5:5\"?"),
    std::pair(SweepRequest{ { "Motion/Mass=100 - 500 g" }, {}, 200, 1 },
              "did you mean \"Motion/Mass=100:500 g:5\"?"),
    std::pair(SweepRequest{ { "Motion/Force offset=-5e-2--1e-2" }, {}, 200, 1 },
              "did you mean \"Motion/Force offset=-5e-2:-1e-2:5\"?"),
    std::pair(SweepRequest{ { "Motion/Mass=0.1..0.5" }, {}, 200, 1 },
              "did you mean \"Motion/Mass=0.1:0.5:5\"?"),
    std::pair(SweepRequest{ { "Motion/Mass=0.1:0.5" }, {}, 200, 1 },
              "did you mean \"Motion/Mass=0.1:0.5:5\", five values?"),
    std::pair(SweepRequest{ { "Motion/Mass=1,abc,3" }, {}, 200, 1 },
              "--vary: Motion/Mass = abc is not allowed; give a number greater than 0"),
    std::pair(SweepRequest{ { "Motion/Mass=1,nan,3" }, {}, 200, 1 }, "Motion/Mass = nan is not allowed"),
    std::pair(SweepRequest{ { "Motion/Mass=1,,3" }, {}, 200, 1 }, "Motion/Mass = (nothing) is not allowed"),
    std::pair(SweepRequest{ { "Motion/Mass=0.3 kg,5 mm" }, {}, 200, 1 }, "is a length, but a mass"),
    std::pair(SweepRequest{ { "Glass/Shape=foot,step,cup" }, {}, 200, 1 },
              "Glass/Shape = cup is not allowed; give step, foot or profile"),
    std::pair(SweepRequest{ { "Load/Moment ratio=1.5,2.5" }, {}, 200, 1 },
              "Load/Moment ratio = 2.5 is not allowed"),
    std::pair(SweepRequest{ { "Motion/Mass=0:1:3" }, {}, 200, 1 }, "Motion/Mass = 0 is not allowed"),
    std::pair(SweepRequest{ { "Load/Moment ratio=1:2:3" }, {}, 200, 1 },
              "Load/Moment ratio = 2 is not allowed"),
    std::pair(SweepRequest{ { "Contact/Harmonics=4:16:6" }, {}, 200, 1 },
              "Contact/Harmonics = 6.4 is not allowed; give a whole number"),
    std::pair(SweepRequest{ { "Contact/Rings=5,40" }, {}, 200, 1 }, "Contact/Rings = 40 is not allowed"),
    std::pair(SweepRequest{ { "Motion/Mass=0.3:0.3:5" }, {}, 200, 1 }, "Motion/Mass = 0.3 stands twice"),
    std::pair(SweepRequest{ { "Motion/Mass=0.2 kg,0.3 kg,200 g" }, {}, 200, 1 }, "stands twice"),
    std::pair(SweepRequest{ { "Motion/Closure=paper,Paper" }, {}, 200, 1 },
              "Motion/Closure = Paper stands twice"),
    std::pair(SweepRequest{ { "Load/File=no_such.dat" }, {}, 200, 1 }, "no_such.dat does not exist"),
    std::pair(SweepRequest{ {}, { "Motion/Mass=-1..1" }, 200, 1 }, "of the spread (uniform, -1 to 1)"),
    std::pair(SweepRequest{ {}, { "Motion/Mass=0.3+-0.3" }, 200, 1 }, "which stays above 0"),
    std::pair(SweepRequest{ {}, { "Contact/Harmonics=4..16" }, 200, 1 }, "cannot be drawn from a spread"),
    std::pair(SweepRequest{ {}, { "Motion/Closure=1..2" }, 200, 1 }, "cannot be drawn from a spread")));

TEST(SweepPlan, ValuesWithUnitsAreThoseInSi)
{
  const auto values = [](const std::string &request) { return grid({ request }).entries.front().values; };
  EXPECT_EQ(values("Motion/Mass=200:400 g:3"), (Values{ "0.2", "0.3", "0.4" }));
  EXPECT_EQ(values("Motion/Mass=0.2 kg:400 g:3"), (Values{ "0.2", "0.3", "0.4" }));
  EXPECT_EQ(values("Motion/Mass=200, 250, 300 g"), (Values{ "0.2", "0.25", "0.3" }));
  EXPECT_EQ(values("Table/Foundation modulus=0.1:10 GPa/m:3:log"), (Values{ "1e8", "1e9", "1e10" }));
  const auto spread = [](const std::string &request) {
    return make_plan({ {}, { request }, 2, 1 }).spreads.front().description();
  };
  EXPECT_EQ(spread("Motion/Mass=300+-15 g"), "normal, mean 0.3, standard deviation 0.015");
  EXPECT_EQ(spread("Motion/Mass=300 g +- 5 %"), "normal, mean 0.3, standard deviation 0.015");
  EXPECT_EQ(spread("Table/Foundation modulus=10 GPa/m*/2"), "lognormal, median 1e10, factor 2");
  EXPECT_EQ(spread("Glass/Crown radius=2..4 mm"), "uniform, 0.002 to 0.004");
}

TEST(SweepPlan, IdentityTellsSweepsApart)
{
  const test::ScratchFolder scratch;
  const std::string load = scratch.write("load.dat", "# ring radius: 0.03 (m)\n0 0.5 0\n1 0 0.1\n");
  SweepPlan plan = grid({ "Motion/Mass=0.2,0.4" });
  plan.base.load.source = LoadSource::file;
  plan.base.load.file = load;
  const auto identity = identity_of(plan);
  EXPECT_EQ(identity_of(plan), identity);

  SweepPlan other_values = grid({ "Motion/Mass=0.2,0.5" });
  other_values.base = plan.base;
  EXPECT_NE(identity_of(other_values), identity);
  SweepPlan other_base = plan;
  other_base.base.motion.orbit.gravity = 1.62;
  EXPECT_NE(identity_of(other_base), identity);
  scratch.write("load.dat", "# ring radius: 0.03 (m)\n0 0.5 0\n1 0 0.2\n");
  EXPECT_NE(identity_of(plan), identity);
}

TEST(SweepPlan, SamplesOfAnotherSeedAreAnotherSweep)
{
  SweepRequest request;
  request.random = { "Motion/Mass=0.3+-5%" };
  request.n_samples = 3;
  const SweepPlan plan = make_plan(request);
  request.seed = 2;
  EXPECT_NE(identity_of(make_plan(request)), identity_of(plan));
  EXPECT_EQ(plan_as_json(plan)["entries"][0]["standard_deviation"], 0.015);
}

} // namespace
} // namespace stemware::pipeline
