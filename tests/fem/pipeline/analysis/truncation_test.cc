// One table of truncations: in balance, or of the load of rest.
#include "fem/pipeline/analysis/truncation.h"
#include "fem/pipeline/coupling/study_load.h"
#include "tests/fem/pipeline/analysis/quick_studies.h"
#include "tests/fem/pipeline/analysis/solved_study.h"

#include <gtest/gtest.h>

#include <cmath>

namespace stemware::pipeline
{
namespace
{

using namespace stemware::test;

TruncationStudy truncations_of(const Study &study, const std::vector<double> &omega = {})
{
  fem::ComplianceCache cache;
  const auto foot = study_foot(study, cache);
  return study_truncations(study, foot, *find_load(study, foot), omega, cache);
}

TEST(Truncation, RowsOfAGivenLoad)
{
  const Study study = study_of_given_load();
  fem::ComplianceCache cache;
  const TruncationStudy result =
    study_truncations(study, nullptr, *given_load(rich_load()), { -1, -5 }, cache);
  const ring::Motion &motion = study.motion.orbit;
  std::vector<unsigned int> orders;
  for (const SpinRow &row : result.rows)
  {
    orders.push_back(row.harmonics);
    const ring::RingStack kept = rich_load().truncated(row.harmonics);
    EXPECT_NEAR(row.terminal->omega, ring::terminal_spin(kept, motion).omega, 1e-10) << row.harmonics;
    ASSERT_EQ(row.torques.size(), 2u);
    EXPECT_NEAR(row.torques[0],
                ring::coulomb_wrench(motion.friction_coefficient, kept, -1, motion.orbit_speed).torque,
                1e-16);
    EXPECT_NEAR(row.torques[1],
                ring::coulomb_wrench(motion.friction_coefficient, kept, -5, motion.orbit_speed).torque,
                1e-16);
    EXPECT_EQ(row.spin_up.size(), result.time.size());
  }
  EXPECT_EQ(orders, (std::vector<unsigned int>{ 1, 2, 3, 4, 6, 8, 9 }));
  EXPECT_DOUBLE_EQ(*result.harmonics.absolute,
                   result.all().terminal->omega - result.rows.front().terminal->omega);
  EXPECT_EQ(result.torque.harmonics, (std::vector<unsigned int>{ 1, 2, 3 }));
  EXPECT_LT(result.torque_slope, 0);
}

TEST(Truncation, TorquesAreShownAtHalfAndAllOfTheSpinUnlessSpinsAreGiven)
{
  fem::ComplianceCache cache;
  const TruncationStudy result =
    study_truncations(study_of_given_load(), nullptr, *given_load(rich_load()), {}, cache);
  const double terminal = result.all().terminal->omega;
  EXPECT_EQ(result.omega, (std::vector<double>{ terminal / 2, terminal }));
}

TEST(Truncation, AFlatLandOnALinearSupportHasNoEffectOfHarmonics)
{
  for (const LoadCoupling coupling : { LoadCoupling::one_way, LoadCoupling::two_way })
  {
    const TruncationStudy result = truncations_of(flat_land_on_a_mat(coupling));
    EXPECT_NEAR(*result.harmonics.absolute, 0, 1e-9);
    EXPECT_NEAR(*result.harmonics.relative, 0, 1e-9);
    for (const SpinRow &row : result.rows)
      EXPECT_NEAR(*row.relative_change, 0, 1e-9) << row.harmonics;
  }
}

TEST(Truncation, HasTheRowsOfTheBudget)
{
  const Study study = quick_contact_study();
  const TruncationStudy result = truncations_of(study);
  fem::ComplianceCache cache;
  const Budget budget = test::whole_budget(study, cache);
  ASSERT_EQ(result.budget.size(), budget.rows.size());
  for (std::size_t i = 0; i < budget.rows.size(); ++i)
  {
    EXPECT_TRUE(result.budget[i].step == budget.rows[i].step) << i;
    EXPECT_EQ(result.budget[i].name, budget.rows[i].name);
    EXPECT_NEAR(*result.budget[i].omega_terminal, *budget.rows[i].omega_terminal, 1e-9) << i;
  }
}

TEST(Truncation, FirstHarmonicInBalanceOnAThinRing)
{
  Study study = quick_contact_study();
  study.glass.profile.land_width = 2e-4;
  study.glass.profile.crown_radius = 0;
  study.glass.material.young_modulus = 7e13;
  study.motion.tilt = false;
  study.contact.friction_coupling = FrictionCoupling::none;
  // The closed form of a first harmonic in balance, docs/theory/closures.md.
  EXPECT_NEAR(truncations_of(study).rows.front().terminal->omega, -3.67874799852576, 1e-4);
}

} // namespace
} // namespace stemware::pipeline
