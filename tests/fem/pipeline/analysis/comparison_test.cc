// Moment balances by loads by truncations, in process: which rows there are, and their effects of harmonics.
#include "fem/pipeline/analysis/comparison.h"
#include "fem/pipeline/coupling/study_load.h"
#include "fem/pipeline/document/spin_rows.h"
#include "tests/fem/pipeline/analysis/quick_studies.h"

#include <gtest/gtest.h>

#include <set>

namespace stemware::pipeline
{
namespace
{

using namespace stemware::test;

Comparison compare_quickly(const Study &study)
{
  fem::ComplianceCache cache;
  const std::shared_ptr<ElasticFoot> foot = study_foot(study, cache);
  Comparison comparison = compare_variants(study, compared_models(study), foot, cache);
  judge_models(study, foot, cache, comparison);
  return comparison;
}

std::vector<std::string> loads_of(const Comparison &comparison)
{
  std::vector<std::string> loads;
  for (const SpinRow &row : comparison.rows)
    if (row.closure == ring::Closure::full && row.all_harmonics)
      loads.push_back(row.load);
  return loads;
}

TEST(Comparison, HasEveryLoadThatTheStudyCanStandOn)
{
  Study study = quick_contact_study();
  std::vector<std::string> loads = { "first harmonic", "rigid flat rim",       "rigid round rim",
                                     "rigid foot",     "elastic foot at rest", "elastic foot" };
  const Comparison comparison = compare_quickly(study);
  EXPECT_EQ(loads_of(comparison), loads);
  for (const ring::Closure closure : { ring::Closure::paper, ring::Closure::hand, ring::Closure::full })
    for (const unsigned int n : { 1u, 2u, 3u })
      EXPECT_TRUE(comparison.find(closure, "elastic foot", n)) << n;
  for (const SpinRow &row : comparison.rows)
    EXPECT_EQ(row.reason, "") << row.load;
  EXPECT_EQ(comparison.rows.size(), 3u * (1 + 4 + 4 + 4 + 4 + 4)); // the same ones in every closure
  study.load.source = LoadSource::first_harmonic;
  loads.resize(3);
  EXPECT_EQ(loads_of(compare_quickly(study)), loads);
}

TEST(Comparison, OneWayAndTwoWayAgreeInTheClosurePaper)
{
  Study study = quick_contact_study();
  study.contact.friction_coupling = FrictionCoupling::none;
  const Comparison comparison = compare_quickly(study);
  EXPECT_NEAR(*comparison.find(ring::Closure::paper, "elastic foot")->omega_terminal(),
              *comparison.find(ring::Closure::paper, "elastic foot at rest")->omega_terminal(), 1e-10);
  EXPECT_GT(std::abs(*comparison.find(ring::Closure::full, "elastic foot")->omega_terminal() -
                     *comparison.find(ring::Closure::full, "elastic foot at rest")->omega_terminal()),
            0.1);
}

TEST(Comparison, AFlatLandOnALinearSupportHasNoEffectOfHarmonics)
{
  const Comparison comparison = compare_quickly(flat_land_on_a_mat(LoadCoupling::two_way));
  for (const ring::Closure closure : { ring::Closure::paper, ring::Closure::full })
    for (const char *load : { "rigid flat rim", "rigid foot", "elastic foot at rest", "elastic foot" })
    {
      const HarmonicEffect effect = comparison.harmonic_effect(closure, load);
      ASSERT_TRUE(effect.absolute) << load;
      EXPECT_NEAR(*effect.absolute, 0, 1e-9) << load;
      EXPECT_NEAR(*effect.relative, 0, 1e-9) << load;
    }
  const HarmonicEffect round = comparison.harmonic_effect(ring::Closure::full, "rigid round rim");
  EXPECT_GT(std::abs(*round.relative), 1e-4);
}

TEST(Comparison, HasTheBudgetOfTheStudyInBalance)
{
  Study study = quick_contact_study();
  study.load.coupling = LoadCoupling::one_way; // two-way is compared all the same
  const Comparison comparison = compare_quickly(study);
  std::vector<std::string> rows;
  for (const BudgetRow &row : comparison.budget)
    rows.push_back(label_of(row.step) + " " + row.name);
  EXPECT_EQ(rows, (std::vector<std::string>{ "1 paper", "2 moment balance", "3 where the foot touches",
                                             "3a tilt", "4 harmonics", "5 harmonics", "6 harmonics" }));
  EXPECT_EQ(comparison.budget.back().omega_terminal,
            comparison.find(ring::Closure::full, "elastic foot")->omega_terminal());
  EXPECT_EQ(comparison.budget[3].omega_terminal,
            comparison.find(ring::Closure::full, "elastic foot", 1)->omega_terminal());
  study.load.source = LoadSource::first_harmonic;
  EXPECT_EQ(compare_quickly(study).budget.size(), 2u);
}

TEST(Comparison, AFootThatTipsSaysSo)
{
  Study study = quick_contact_study();
  study.motion.orbit.centre_of_mass_height = 0.16; // a moment ratio above 2 in the closure full
  study.motion.closure = ring::Closure::paper;
  const Comparison comparison = compare_quickly(study);
  for (const char *load : { "rigid foot", "elastic foot at rest", "elastic foot" })
  {
    const SpinRow &row = *comparison.find(ring::Closure::full, load);
    EXPECT_EQ(row.standing, Standing::tips) << load;
    EXPECT_FALSE(row.reason.empty()) << load;
    EXPECT_EQ(row.harmonics, comparison.find(ring::Closure::paper, load)->harmonics) << load;
  }
  EXPECT_TRUE(comparison.find(ring::Closure::paper, "elastic foot")->terminal);
}

} // namespace
} // namespace stemware::pipeline
