// Contact/Goal of a solid foot, whose estimates and meshes are judged by the body of revolution. With MPI.
#include "fem/pipeline/analysis/refinement/goal_error.h"
#include "fem/pipeline/analysis/refinement/goal_mesh.h"
#include "fem/pipeline/analysis/spin.h"
#include "fem/pipeline/coupling/study_load.h"

#include <gtest/gtest.h>

#include <cmath>

namespace stemware::pipeline
{

namespace
{

/// A foot that lifts off; few lines and load harmonics, which are not the mesh's.
Study lifting_foot()
{
  Study study;
  study.glass.profile.shape = fem::GlassShape::foot;
  study.table.foundation_modulus = 1e12;
  study.motion.orbit.force_offset *= 1.6;
  study.contact.harmonics = 24;
  study.contact.azimuth_lines = 256;
  study.contact.load_harmonics = 12;
  return study;
}

double value_of(Study study, Goal goal, unsigned int refinements)
{
  study.contact.refinements = refinements;
  fem::ComplianceCache cache;
  const BalancedLoad load = find_load(study, study_foot(study, cache));
  if (goal == Goal::a2)
    return load.report().rings.a(2) / load.report().rings.a(0);
  return terminal_spin(load, study.motion.orbit, 0, false).spin.omega;
}

GoalError error_of(const Study &study)
{
  fem::ComplianceCache cache;
  const auto foot = study_foot(study, cache);
  const BalancedLoad load = find_load(study, foot);
  const double omega = terminal_spin(load, study.motion.orbit, 0, false).spin.omega;
  return goal_error(study, *foot, load, omega, study.contact.goal).value();
}

} // namespace

// Oracle: the body of revolution on a mesh that leaves a tenth of the smallest error judged, by the next
// coarser one.
TEST(SolidGoal, EstimatesAreTheErrorsAgainstTheBodyOfRevolution)
{
  Study study = lifting_foot();
  const Study of_revolution = study;
  study.contact.body = BodyKind::solid;
  study.contact.resolution = { 24, 2, 1 };
  for (const Goal goal : { Goal::terminal_spin, Goal::a2 })
  {
    SCOPED_TRACE(static_cast<int>(goal));
    study.contact.goal = goal;
    study.contact.halved.clear();
    const double exact = value_of(of_revolution, goal, 2);
    EXPECT_NEAR(value_of(of_revolution, goal, 1), exact, 1e-7 * (goal == Goal::a2 ? 1 : std::abs(exact)));
    const GoalError first = error_of(study);
    study.contact.goal_tolerance = std::abs(0.2 * first.error.correction / first.value);
    fem::ComplianceCache cache;
    Study meshed = meshed_for_goal(study, cache);
    ASSERT_GE(meshed.contact.halved.size(), 1u);
    const GoalError last = error_of(meshed);
    for (const GoalError &found : { first, last })
    {
      const double error = exact - found.value;
      EXPECT_NEAR(found.error.correction / error, 1, 0.2) << "error " << error;
    }
    EXPECT_LT(std::abs(exact - last.value), 0.3 * std::abs(exact - first.value));
  }
}

} // namespace stemware::pipeline
