#include "fem/pipeline/analysis/budget.h"
#include "fem/pipeline/analysis/ring_quantities.h"
#include "fem/pipeline/analysis/variant.h"
#include "fem/pipeline/coupling/make_foot.h"
#include "fem/pipeline/coupling/study_load.h"
#include "ring_model/load/constants.h"
#include "ring_model/self_consistent_ring.h"
#include "tests/fem/pipeline/analysis/quick_studies.h"
#include "tests/fem/pipeline/analysis/solved_study.h"
#include "tests/fem/pipeline/mat_study.h"
#include "tests/fem/pipeline/matchers.h"
#include "tests/ulps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace stemware::pipeline
{
namespace
{

using namespace stemware::test;
using Texts = std::vector<std::string>;

/// Returns step, name and number of harmonics of every row: "4 harmonics 2" is step 4, the row named
/// harmonics, with 2 harmonics.
Texts rows_of(const Budget &budget)
{
  Texts rows;
  for (const BudgetRow &row : budget.rows)
    rows.push_back(label_of(row.step) + " " + row.name + " " +
                   (row.harmonics ? std::to_string(*row.harmonics) : "all"));
  return rows;
}

Texts names_without(const Study &study, const Model &model = {})
{
  Texts names;
  for (const Variant &variant : variants_without({ { study, {}, model } }))
    names.push_back(variant.name);
  return names;
}

StudyRows rows_of(const Study &study, const ring::RingStack &load, const Executor &executor)
{
  return rows_by_harmonics({ study, nullptr, executor }, given_load(load), Depth::full,
                           budget_variants({ study }, false));
}

Budget budget_of(const Study &study, const ring::RingStack &load)
{
  fem::ComplianceCache cache;
  return find_budget(study_spin({ study, nullptr, ThreadedExecutor(cache) }, given_load(load)).rows);
}

Budget budget_of(const Study &study)
{
  fem::ComplianceCache cache;
  return find_budget(test::whole_spin_study(study, ThreadedExecutor(cache)).rows);
}

/// Returns the labels expected for a foot in contact: @p rows, then one row per truncation order above 1.
Texts contact_rows(const Study &study, Texts rows)
{
  fem::ComplianceCache cache;
  const std::vector<unsigned int> orders =
    truncation_orders(find_load(study, study_foot(study, foot_maker(cache))).n_harmonics());
  for (std::size_t i = 1; i < orders.size(); ++i)
    rows.push_back(std::to_string(i + 3) + " harmonics " +
                   (i + 1 < orders.size() ? std::to_string(orders[i]) : "all"));
  return rows;
}

TEST(Budget, RelativeHarmonicEffectIsUndefinedForAGlassAtRestOrReversed)
{
  const double unit = 0.35 / 0.03;
  const HarmonicEffect effect = harmonic_effect(-3.5, -3.43, unit);
  EXPECT_NEAR(*effect.absolute, 0.07, ulps(2, 3.5));
  EXPECT_NEAR(*effect.relative, -0.02, ulps(5, 1));
  EXPECT_TRUE(harmonic_effect(1.1e-9 * unit, 1, unit).relative);
  const HarmonicEffect of_rounding = harmonic_effect(0.9e-9 * unit, 1e-12, unit);
  EXPECT_TRUE(of_rounding.absolute);
  EXPECT_FALSE(of_rounding.relative);
  // A difference below 1e-9 `unit` is set to zero, because it consists of rounding errors. The relative
  // effect on a glass that rests or reverses its spin is undefined.
  EXPECT_EQ(relative_to(-3.5, 0.9e-9 * unit, unit), 0.);
  EXPECT_FALSE(harmonic_effect(-10.55, 0.9e-9 * unit, unit).relative);
  EXPECT_NEAR(*harmonic_effect(-10.55, 0.9e-9 * unit, unit).absolute, 10.55, 1e-7);
  EXPECT_FALSE(relative_to(-1, 1.5, unit));
  EXPECT_NEAR(*relative_to(-1, 0.5, unit), -0.5, ulps(5, 1));
  EXPECT_FALSE(harmonic_effect(std::nullopt, -3, unit).absolute);
  EXPECT_FALSE(harmonic_effect(-3, std::nullopt, unit).absolute);
  EXPECT_FALSE(harmonic_effect(-3, std::nullopt, unit).relative);
}

TEST(Budget, SpinScaleAgreesWithItsFormulaAndIsTheSpinUnitWithoutAMoment)
{
  // The scale is v / R times the moment ratio of the centripetal force, 2 |moment| / (weight R).
  Study study = test::mat_study();
  const ring::Motion &motion = study.motion.orbit;
  const auto expected = [&]
  {
    const double moment = motion.force_offset * motion.mass * motion.orbit_speed * motion.orbit_speed /
                          motion.orbit_radius,
                 radius = study.glass.profile.contact_radius;
    return 2 * std::abs(moment) / (motion.mass * motion.gravity * radius) * motion.orbit_speed / radius;
  };
  for (const double speed : { 0.35, 0.1, 0.01 })
  {
    study.motion.orbit.orbit_speed = speed;
    EXPECT_NEAR(study.spin_scale(), expected(), 1e-12 * expected()) << speed;
  }
  study.motion.orbit.orbit_speed = 1e-4; // lower limit of the scale: 1e-6 v/R
  EXPECT_NEAR(study.spin_scale() / (1e-6 * study.spin_unit()), 1, 1e-13);
  study.motion.orbit.force_offset = 0; // the moment vanishes
  EXPECT_EQ(study.spin_scale(), study.spin_unit());
  EXPECT_EQ(study_of_given_load().spin_scale(), study_of_given_load().spin_unit());
}

TEST(Budget, LiquidActsAsAPointMassAtItsMetacentreOrWithoutLeanAtItsCentre)
{
  Study filled = test::quick_contact_study();
  ring::Motion &motion = filled.motion.orbit;
  motion.mass = 0.15;
  motion.liquid = { 0.15, 1000, 0.03, 0.09 };
  const double level = 0.15 / (1000 * ring::pi * 0.03 * 0.03), up = 0.03 * 0.03 / (4 * level),
               slope = 0.35 * 0.35 / 0.15 / motion.gravity, middle = 0.09 + level / 2;
  const auto empty = [&](double of_liquid) // spin with the liquid as a point mass at the height of_liquid [m]
  {
    Study study = test::quick_contact_study();
    study.motion.orbit.mass = 0.3;
    study.motion.orbit.centre_of_mass_height = (0.08 + of_liquid) / 2;
    study.motion.orbit.force_offset = 0.03 - study.motion.orbit.centre_of_mass_height;
    return test::SolvedStudy(study).omega();
  };
  const double omega = test::SolvedStudy(filled).omega();
  EXPECT_NEAR(omega / empty(middle + up * (1 + slope * slope / 2)), 1, 1e-9);
  for (const Variant &variant : variants_without({ filled }))
    if (variant.name == "lean of the liquid")
    {
      const double level_surface = test::SolvedStudy(variant.study).omega();
      EXPECT_NEAR(level_surface / empty(middle), 1, 1e-9);
      EXPECT_GT(std::abs(omega / level_surface - 1), 0.01);
      return;
    }
  FAIL() << "no row without the lean of the liquid";
}

TEST(Budget, ListsRowsForAGivenLoadWithAndWithoutAGripTorque)
{
  Study study = study_of_given_load();
  const Budget budget = budget_of(study, rich_load());
  EXPECT_EQ(rows_of(budget),
            (Texts{ "1 paper 1", "3 where the foot touches 1", "4 harmonics 2", "5 harmonics 3",
                    "6 harmonics 4", "7 harmonics 6", "8 harmonics 8", "9 harmonics all" }));
  EXPECT_TRUE(budget.without.empty());
  study.motion.grip_torque = 1e-4;
  EXPECT_EQ(rows_of(budget_of(study, rich_load())).at(1), "2a grip 1");
}

TEST(Budget, ListsRowsAndSpinsForAFirstHarmonicLoadAGivenMomentAndAGripTorque)
{
  Study study = test::mat_study();
  study.load.source = LoadSource::first_harmonic;
  Budget budget = budget_of(study);
  EXPECT_EQ(rows_of(budget), (Texts{ "1 paper 1", "2 moment balance 1" }));
  EXPECT_NEAR(*budget.rows[0].omega_terminal, -3.12055870152586, 1e-10); // from docs/theory/closures.md
  EXPECT_NEAR(*budget.rows[1].omega_terminal, -3.67874799852576, 1e-10);
  EXPECT_TRUE(budget.without.empty());
  fem::ComplianceCache cache;
  EXPECT_EQ(harmonic_effect(test::whole_spin_study(study, ThreadedExecutor(cache)).rows).absolute, 0.);

  study.load.moment_ratio = 1.3;
  EXPECT_EQ(rows_of(budget_of(study)).back(), "2 given moment 1");
  EXPECT_EQ(budget_of(study).rows.back().status, ring::Status::formal);

  study.load.moment_ratio = -1;
  study.motion.grip_torque = 2e-4;
  budget = budget_of(study);
  EXPECT_EQ(rows_of(budget), (Texts{ "1 paper 1", "2 moment balance 1", "2a grip 1" }));
  EXPECT_NEAR(*budget.rows[1].omega_terminal, -3.67874799852576, 1e-10);
  const ring::SelfConsistentRing ring(ring::Closure::full, study.motion.orbit, 0.03);
  EXPECT_NEAR(ring.torque(*budget.rows[2].omega_terminal), -2e-4, 1e-12); // friction balances the grip
}

TEST(Budget, ListsRowsForFourModelsOfAFootInContact)
{
  Study study = quick_contact_study();
  EXPECT_EQ(rows_of(budget_of(study)), contact_rows(study, { "1 paper 1", "2 moment balance 1",
                                                             "3 where the foot touches 1", "3a tilt 1" }));
  study.motion.tilt = false;
  study.motion.grip_torque = 1e-4;
  EXPECT_EQ(rows_of(budget_of(study)), contact_rows(study, { "1 paper 1", "2 moment balance 1", "2a grip 1",
                                                             "3 where the foot touches 1" }));
  study.motion.grip_torque = 0;
  study.load.coupling = LoadCoupling::one_way;
  EXPECT_EQ(rows_of(budget_of(study)),
            contact_rows(study, { "1 paper 1", "2 moment balance 1", "3 where the foot touches 1" }));
  study.motion.tilt = true;
  study.load.moment_ratio = 0.5;
  EXPECT_EQ(rows_of(budget_of(study)),
            contact_rows(study, { "1 paper 1", "2 given moment 1", "3 where the foot touches 1" }));
}

TEST(Truncation, FirstHarmonicOfAThinStiffRingGivesTheSpinOfTheClosedForm)
{
  Study study = quick_contact_study();
  study.glass.profile.land_width = 2e-4;
  study.glass.profile.crown_radius = 0;
  study.glass.material.young_modulus = 7e13;
  study.motion.tilt = false;
  study.contact.friction_coupling = FrictionCoupling::none;
  const BudgetRow row = budget_of(study).rows[2];
  EXPECT_EQ(row.name, "where the foot touches");
  EXPECT_NEAR(*row.omega_terminal, -3.67874799852576, 1e-4); // from docs/theory/closures.md
}

TEST(Budget, ListsOneVariantPerEffectThatOmitsThisEffect)
{
  Study study = test::mat_study();
  EXPECT_EQ(names_without(study), (Texts{ "friction in the foot", "elasticity of the foot",
                                          "compliance of the interface", "tilt" }));
  study.motion.grip_torque = 1e-4;
  study.glass.waviness = { { 3, 1e-6, 0 } };
  study.table.substrate = TableSubstrate::elastic;
  EXPECT_EQ(names_without(study), (Texts{ "friction in the foot", "friction in the substrate",
                                          "elasticity of the foot", "elasticity of the substrate",
                                          "compliance of the interface", "tilt", "grip", "waviness" }));
  for (const Variant &variant : variants_without({ study }))
    EXPECT_EQ(names_without(variant.study, variant.model).size(),
              7u -
                (variant.name == "elasticity of the foot" || variant.name == "elasticity of the substrate"))
      // Each variant lacks one of the eight effects. A variant with a rigid body also lacks the deformation
      // of this body by friction.
      << variant.name;
  study = test::mat_study();
  study.table.interface = TableInterface::hard;
  study.contact.friction_coupling = FrictionCoupling::none;
  study.motion.closure = ring::Closure::paper;
  EXPECT_EQ(names_without(study), Texts{ "elasticity of the foot" });
  study.contact.body = BodyKind::solid;
  EXPECT_TRUE(names_without(study).empty());
  study.load.source = LoadSource::file;
  EXPECT_TRUE(names_without(study).empty());
}

TEST(Budget, FindsWhetherAnyBodyOrInterfaceIsCompliant)
{
  Study study = test::mat_study();
  study.table.interface = TableInterface::hard;
  EXPECT_TRUE(has_compliance(study));
  EXPECT_FALSE(has_compliance({ study, {}, test::rigid_foot() }));
  study.table.substrate = TableSubstrate::elastic;
  EXPECT_TRUE(has_compliance({ study, {}, test::rigid_foot() }));
  study.table = {};
  EXPECT_TRUE(has_compliance({ study, {}, test::rigid_foot() })); // compliance of the Winkler interface
}

TEST(Budget, DifferencesAddUpToTheTotal)
{
  fem::ComplianceCache cache;
  const SpinStudy spin = test::whole_spin_study(quick_contact_study(), ThreadedExecutor(cache));
  const Budget budget = find_budget(spin.rows);
  EXPECT_FALSE(budget.rows.front().difference);
  double sum = *budget.rows.front().omega_terminal, of_harmonics = 0;
  for (std::size_t i = 1; i < budget.rows.size(); ++i)
  {
    ASSERT_TRUE(budget.rows[i].difference) << budget.rows[i].name << budget.rows[i].reason;
    sum += *budget.rows[i].difference;
    of_harmonics += budget.rows[i].name == "harmonics" ? *budget.rows[i].difference : 0;
  }
  EXPECT_NEAR(sum, *budget.rows.back().omega_terminal, 1e-12);
  EXPECT_NEAR(of_harmonics, *harmonic_effect(spin.rows).absolute, 1e-12);
  ASSERT_EQ(budget.without.size(), 4u);
  for (const WithoutRow &row : budget.without)
  {
    ASSERT_TRUE(row.omega_terminal) << row.name << row.reason;
    EXPECT_NEAR(*row.difference, *row.omega_terminal - *budget.rows.back().omega_terminal, 1e-12) << row.name;
  }
}

TEST(Budget, ReportsTheTorquesOfEveryRow)
{
  const Study study = study_of_given_load();
  const ring::Motion &motion = study.motion.orbit;
  const Budget budget = budget_of(study, rich_load());
  const double terminal = *budget.rows.back().omega_terminal;
  for (const BudgetRow &row : budget.rows)
    if (row.step.number != 1)
      for (std::size_t i = 0; i < 3; ++i)
      {
        const ring::RingStack kept = rich_load().truncated(row.harmonics.value_or(9));
        const double omega = terminal * static_cast<double>(i) / 2;
        EXPECT_NEAR(*row.torques[i],
                    ring::coulomb_wrench(motion.friction_coefficient, kept, omega, motion.orbit_speed).torque,
                    ulps(17, 0.028))
          << row.name << " " << i;
      }
  EXPECT_NEAR(*budget.rows.front().torques[0],
              motion.friction_coefficient * ring::required_moment_at_rest(ring::Closure::paper, motion).x(),
              1e-14);
}

TEST(Budget, ReportsAGlassHeldByTheGrip)
{
  Study study = test::mat_study();
  study.load.source = LoadSource::first_harmonic;
  study.motion.grip_torque = 0.01; // the torque at rest is 0.0037 N m
  const Budget budget = budget_of(study);
  EXPECT_EQ(budget.rows.back().name, "grip");
  EXPECT_EQ(budget.rows.back().omega_terminal, 0.);
  EXPECT_THAT(budget.rows.back().reason, testing::HasSubstr(" 0.003675 N m"));
  EXPECT_THAT(budget.rows.back().reason, testing::HasSubstr("Motion/Grip torque = 0.01 N m"));
  EXPECT_EQ(budget.rows.front().reason, "");
}

TEST(Budget, AFailedRowKeepsItsReasonAndInvalidatesOnlyTheDifferencesToIt)
{
  const Study study = study_of_given_load();
  fem::ComplianceCache cache;
  StudyRows rows = rows_of(study, rich_load(), ThreadedExecutor(cache));
  LoadedRow &second = rows.by_harmonics[1];
  second = {};
  second.row.harmonics = 2;
  second.row.status = ring::Status::tips;
  second.row.reason = "it tips";
  const Budget budget = find_budget(rows);
  const BudgetRow &failed = budget.rows[2];
  EXPECT_EQ(failed.harmonics, 2u);
  EXPECT_FALSE(failed.omega_terminal);
  EXPECT_FALSE(failed.difference);
  EXPECT_FALSE(failed.torques[0]);
  EXPECT_EQ(failed.status, ring::Status::tips);
  EXPECT_EQ(failed.reason, "it tips");
  EXPECT_TRUE(budget.rows[3].omega_terminal);
  EXPECT_FALSE(budget.rows[3].difference); // the previous row failed
  EXPECT_TRUE(budget.rows[4].difference);
  EXPECT_TRUE(budget.rows[4].reason.empty());
}

TEST(Budget, MarksRowsWithTensileLoads)
{
  Study study = quick_contact_study();
  study.load.moment_ratio = 1.4; // causes lift-off
  const Budget budget = budget_of(study);
  for (const BudgetRow &row : budget.rows)
  {
    const bool is_cut = row.step.number != 1 && row.harmonics.value_or(4) < 3;
    EXPECT_TRUE(!is_cut || row.status == ring::Status::formal) << row.name;
  }
  EXPECT_EQ(budget.rows.front().status, ring::Status::full_contact);
  EXPECT_EQ(budget.rows.back().status, ring::Status::lift_off);
  EXPECT_EQ(budget_of(study_of_given_load(), { { 0.47, 0, 0.5 }, { 0, -0.3, 0 }, 0.03 }).rows.back().status,
            ring::Status::formal);
}

} // namespace
TEST(Budget, WavyRimWithoutInterfaceComplianceSpinsAsOnAHardTable)
{
  Study study = quick_contact_study();
  study.glass.waviness = { { 3, 1e-7, 0 } };
  study.load.coupling = LoadCoupling::one_way;
  study.contact.friction_coupling = FrictionCoupling::none;
  const Budget budget = budget_of(study);
  const auto row =
    std::find_if(budget.without.begin(), budget.without.end(),
                 [](const WithoutRow &without) { return without.name == "compliance of the interface"; });
  ASSERT_NE(row, budget.without.end());
  ASSERT_TRUE(row->omega_terminal) << row->reason;
  study.table.interface = TableInterface::hard;
  fem::ComplianceCache cache;
  const ring::Answer hard = solve_rows({ { study } }, nullptr, {}, ThreadedExecutor(cache)).front().row;
  ASSERT_TRUE(hard.terminal) << hard.reason;
  EXPECT_GT(hard.terminal->ripple, 0);
  EXPECT_NEAR(*row->omega_terminal, *hard.omega_terminal(), 1e-3 * std::abs(*hard.omega_terminal()));
}

} // namespace stemware::pipeline
