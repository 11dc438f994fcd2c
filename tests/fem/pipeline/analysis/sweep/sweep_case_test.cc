// Numbers of one case of a sweep.
#include "fem/pipeline/analysis/budget.h"
#include "fem/pipeline/analysis/sweep/sweep_case.h"
#include "tests/fem/pipeline/analysis/quick_studies.h"
#include "tests/fem/pipeline/analysis/solved_study.h"

#include <gtest/gtest.h>

namespace stemware::pipeline
{
namespace
{

using namespace stemware::test;

/// Values of a study by their names.
class SolvedCase
{
public:
  explicit SolvedCase(const Study &study)
  {
    fem::ComplianceCache cache;
    result = test::solve_case(study, cache);
  }
  const std::optional<double> &operator[](const std::string &name) const
  {
    return result.values.at(quantity_index(name));
  }

private:
  CaseResult result;
};

TEST(SweepCase, HasTheEffectOfHarmonicsOfTheBudget)
{
  for (const LoadCoupling coupling : { LoadCoupling::one_way, LoadCoupling::two_way })
  {
    Study study = quick_contact_study();
    study.load.coupling = coupling;
    fem::ComplianceCache cache;
    const Budget budget = test::whole_budget(study, cache);
    const SolvedCase solved(study);
    EXPECT_NEAR(*solved["absolute harmonic effect"], *budget.harmonics.absolute, 1e-9);
    EXPECT_NEAR(*solved["harmonic effect"], 100 * *budget.harmonics.relative, 1e-7);
    EXPECT_NEAR(*solved["terminal spin"] - *solved["terminal spin of the first harmonic alone"],
                *solved["absolute harmonic effect"], 1e-12);
  }
}

TEST(SweepCase, HasTheNamedDifferencesOfTheBudget)
{
  Study study = quick_contact_study();
  study.motion.grip_torque = 1e-4;
  fem::ComplianceCache cache;
  const Budget budget = test::whole_budget(study, cache);
  const SolvedCase solved(study);
  unsigned int n_compared = 0;
  for (const BudgetRow &row : budget.rows)
    if (row.name != "paper" && row.name != "harmonics")
    {
      EXPECT_NEAR(*solved[row.name], *row.difference, 1e-9) << row.name;
      ++n_compared;
    }
  EXPECT_EQ(n_compared, 4u); // moment balance, grip, where the foot touches, tilt
  study.motion.grip_torque = 0;
  study.motion.tilt = false;
  const SolvedCase without(study);
  EXPECT_FALSE(without["grip"]);
  EXPECT_FALSE(without["tilt"]);
}

TEST(SweepCase, SaysWhereTheFingersHoldTheGlass)
{
  Study study = quick_contact_study();
  EXPECT_FALSE(SolvedCase(study)["held by the grip"]);
  study.motion.grip_torque = 1e-4;
  EXPECT_EQ(SolvedCase(study)["held by the grip"], 0.);
  study.motion.grip_torque = 0.01; // the torque at rest is 0.0037 N m
  const SolvedCase held(study);
  EXPECT_EQ(held["held by the grip"], 1.);
  EXPECT_EQ(held["terminal spin"], 0.);
  EXPECT_FALSE(held["harmonic effect"]);
}

TEST(SweepCase, AGivenMomentLeavesNoBalanceToCompare)
{
  Study study = quick_contact_study();
  EXPECT_NEAR(*SolvedCase(study)["closure effect"], 17.8875, 1e-3); // per cent, of two first harmonics
  study.load.moment_ratio = 0.5;
  EXPECT_FALSE(SolvedCase(study)["closure effect"]);
}

TEST(SweepCase, AFlatLandOnALinearSupportHasNoEffectOfHarmonics)
{
  for (const LoadCoupling coupling : { LoadCoupling::one_way, LoadCoupling::two_way })
  {
    const SolvedCase solved(flat_land_on_a_mat(coupling));
    EXPECT_NEAR(*solved["absolute harmonic effect"], 0, 1e-9);
    EXPECT_NEAR(*solved["harmonic effect"], 0, 1e-7); // per cent
  }
}

TEST(SweepCase, NothingIsRelativeToAGlassThatDoesNotSpinUp)
{
  Study study = quick_contact_study();
  study.motion.orbit.force_offset = 0;
  study.motion.closure = ring::Closure::paper;
  const SolvedCase solved(study);
  EXPECT_NEAR(*solved["terminal spin"], 0, 1e-9);
  EXPECT_FALSE(solved["harmonic effect"]);
  EXPECT_FALSE(solved["closure effect"]);
}

} // namespace
} // namespace stemware::pipeline
