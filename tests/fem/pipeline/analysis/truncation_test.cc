// The answer by the number of harmonics: in balance, or of the load of rest.
#include "fem/pipeline/analysis/budget.h"
#include "fem/pipeline/coupling/study_load.h"
#include "fem/pipeline/feet/make_foot.h"
#include "tests/fem/pipeline/analysis/quick_studies.h"
#include "tests/fem/pipeline/analysis/solved_study.h"

#include <gtest/gtest.h>

#include <cmath>

namespace stemware::pipeline
{
namespace
{

using namespace stemware::test;

std::vector<LoadedRow> truncations_of(const Study &study)
{
  fem::ComplianceCache cache;
  const auto foot = study_foot(study, cache);
  return rows_by_harmonics(study, foot, *find_load(study, foot), spin_question(study),
                           ThreadedExecutor(cache))
    .by_harmonics;
}

TEST(Truncation, BoundsHold)
{
  Study study = quick_contact_study();
  study.motion.orbit.centre_of_mass_height = 0.1; // lift-off
  const std::vector<LoadedRow> rows = truncations_of(study);
  const double omega = rows.back().row.terminal->omega;
  for (const LoadedRow &loaded : rows)
  {
    const ring::Answer &row = loaded.row;
    // There the torque of all harmonics vanishes: what is left is that of the harmonics left out.
    const double torque = std::abs(yaw_torque(*loaded.load, study.motion.orbit, omega));
    EXPECT_LE(torque, *row.bound + 1e-13) << row.harmonics;
    EXPECT_TRUE(row.harmonics != 1 || torque > 1e-6); // the bound bounds something
  }
  EXPECT_TRUE(rows.front().row.pulls()); // the first harmonic alone
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
  EXPECT_NEAR(truncations_of(study).front().row.terminal->omega, -3.67874799852576, 1e-4);
}

} // namespace
} // namespace stemware::pipeline
