#include "fem/pipeline/analysis/refinement/goal_mesh.h"
#include "fem/pipeline/analysis/refinement/refinement_study.h"
#include "fem/pipeline/analysis/spin.h"
#include "fem/pipeline/coupling/study_load.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

namespace stemware::pipeline
{

namespace
{

/// A step section, with its re-entrant corners, that lifts off; few harmonics and lines, which are not the
/// mesh's.
Study lifting_step(Goal goal, double tolerance)
{
  Study study;
  study.glass.profile.shape = fem::GlassShape::step;
  study.table.foundation_modulus = 1e12;
  study.motion.orbit.force_offset *= 1.6;
  study.contact.harmonics = 4;
  study.contact.azimuth_lines = 48;
  study.contact.load_harmonics = 20;
  study.contact.goal = goal;
  study.contact.goal_tolerance = tolerance;
  return study;
}

struct Answer
{
  double spin = 0;
  double a2 = 0;
  double torque = 0; ///< at half of @p half_of
};

Answer answer_of(const Study &study, double half_of = 0)
{
  fem::ComplianceCache cache;
  const SharedLoad load = find_load(study, study_foot(study, cache));
  Answer answer;
  answer.spin = terminal_spin(*load, study.motion.orbit, 0, false).spin.omega;
  answer.a2 = load->report().rings.a(2) / load->report().rings.a(0);
  answer.torque = yaw_torque(*load, study.motion.orbit, half_of / 2);
  return answer;
}

GoalError error_of(const Study &study)
{
  fem::ComplianceCache cache;
  const auto foot = study_foot(study, cache);
  const SharedLoad load = find_load(study, foot);
  const double omega = terminal_spin(*load, study.motion.orbit, 0, false).spin.omega;
  return goal_error(study, *foot, *load, omega, study.contact.goal).value();
}

/// Of the goal on the mesh without halved cells.
double relative_error(Goal goal)
{
  const GoalError found = error_of(lifting_step(goal, 1));
  return std::abs(found.error.correction / found.value);
}

} // namespace

// Oracle: the same numbers on a mesh of far more cells, without any estimate. Of second order, and left out
// of the estimate, is some 1e-7 of a_0 and of mu N R, the less the finer the mesh.
TEST(GoalMesh, EstimatesAreTheErrorsOfSpinSecondHarmonicAndTorque)
{
  fem::ComplianceCache cache;
  const double least = relative_error(Goal::a2);
  const Study coarse = mesh_for_goal(lifting_step(Goal::a2, 0.4 * least), cache).study;
  const double half_of = answer_of(coarse).spin;
  const Answer truth = answer_of(mesh_for_goal(lifting_step(Goal::a2, 0.02 * least), cache).study, half_of);
  const Answer own = answer_of(coarse, half_of);
  const ring::Motion &motion = coarse.motion.orbit;
  const double radius = coarse.glass.profile.contact_radius;
  const auto check = [&](Goal goal, double error, double unit)
  {
    SCOPED_TRACE(static_cast<int>(goal));
    Study study = coarse;
    study.contact.goal = goal;
    EXPECT_NEAR(error_of(study).error.correction, error, 0.1 * std::abs(error) + 2e-7 * unit);
  };
  check(Goal::a2, truth.a2 - own.a2, 1);
  check(Goal::terminal_spin, truth.spin - own.spin, motion.orbit_speed / radius);
  check(Goal::torque, truth.torque - own.torque, motion.friction_at_rest() * motion.normal_force() * radius);
  EXPECT_GT(std::abs(truth.a2 - own.a2), 2e-6);
}

// Effectivity of the last three meshes, against two further ones and what is estimated to be missing there.
TEST(GoalMesh, EffectivityOnTheLastThreeMeshes)
{
  for (const Goal goal : { Goal::terminal_spin, Goal::a2 })
  {
    fem::ComplianceCache cache;
    const double tolerance = 0.15 * relative_error(goal);
    const Study study = mesh_for_goal(lifting_step(goal, tolerance), cache).study;
    ASSERT_GE(study.contact.halved.size(), 2u);
    const RefinementAxis axis = goal_axis(study, cache);
    ASSERT_EQ(axis.levels.size(), 5u);
    EXPECT_EQ(axis.own, 2u);
    std::vector<double> values, corrections;
    for (const RefinementLevel &level : axis.levels)
    {
      const GoalError found = error_of(level.study);
      values.push_back(found.value);
      corrections.push_back(found.error.correction);
    }
    for (std::size_t l = 0; l < 3; ++l)
      EXPECT_NEAR(corrections[l] / (values[l + 2] + corrections[l + 2] - values[l]), 1, 0.1);
    EXPECT_LE(std::abs(corrections[2]), tolerance * std::abs(values[2]));
  }
}

TEST(GoalMesh, LeavesAStudyWithoutAGoalAlone)
{
  fem::ComplianceCache cache;
  EXPECT_TRUE(mesh_for_goal(lifting_step(Goal::none, 1e-9), cache).study.contact.halved.empty());
  EXPECT_EQ(cache.n_computed(), 0u);
}

} // namespace stemware::pipeline
