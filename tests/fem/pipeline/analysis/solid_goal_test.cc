// Reference: body of revolution. Runs with MPI.
#include "fem/pipeline/analysis/goal_mesh.h"
#include "fem/pipeline/analysis/threaded_executor.h"
#include "fem/pipeline/coupling/make_foot.h"
#include "fem/pipeline/coupling/study_load.h"
#include "ring_model/spin/answer.h"
#include "tests/fem/pipeline/mat_study.h"

#include <gtest/gtest.h>

#include <cmath>

namespace stemware::pipeline
{

namespace
{

/// Returns a study of a foot with lift-off. The numbers of lines and load harmonics are fixed, so that only
/// the mesh contributes to the error.
Study lifting_foot()
{
  Study study = test::mat_study();
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
  const BalancedLoad load = find_load(study, study_foot(study, foot_maker(cache)));
  if (goal == Goal::a2)
    return load.report().a(2) / load.report().a(0);
  return ring::answer(load, { study.motion.orbit }).value().omega_terminal().value();
}

GoalError error_of(const Study &study, const Discretisation &discretisation = {})
{
  fem::ComplianceCache cache;
  const auto foot = study_foot({ study, discretisation }, foot_maker(cache));
  const BalancedLoad load = find_load(study, foot);
  const double omega = ring::answer(load, { study.motion.orbit }).value().omega_terminal().value();
  return goal_error(*foot, load, omega, study.contact.goal, true).value();
}

} // namespace

// Short version of EstimatesAreCloseToTheErrorsAndEachRefinementHalvesTheErrorLong: a single mesh and a
// given moment.
TEST(SolidGoal, EstimatesAreCloseToTheErrorsAndALargerToleranceNeedsNoRefinement)
{
  for (const Goal goal : { Goal::a2, Goal::terminal_spin })
  {
    SCOPED_TRACE(static_cast<int>(goal));
    Study study = lifting_foot();
    study.load.moment_ratio = 1.1;
    study.contact.friction_coupling = FrictionCoupling::none;
    study.contact.goal = goal;
    const double exact = value_of(study, goal, 1);
    study.contact.body = BodyKind::solid;
    study.contact.resolution = { 24, 2, 1 };
    study.contact.degree = 1;
    const GoalError found = error_of(study);
    const double ratio = found.error.correction / (exact - found.value);
    EXPECT_GT(ratio, 0.8);
    EXPECT_LT(ratio, 1.25);
    // A tolerance above the estimated error needs no refinement.
    study.contact.goal_tolerance = 1.1 * std::abs(found.error.correction / found.value);
    fem::ComplianceCache cache;
    EXPECT_TRUE(mesh_for_goal(study, ThreadedExecutor(cache)).discretisation.halved_cells.empty());
  }
}

TEST(SolidGoal, KeepsTheMeshOfAStudyWithoutAGoal)
{
  Study study = lifting_foot();
  study.contact.body = BodyKind::solid;
  fem::ComplianceCache cache;
  const GoalOutcome meshed = mesh_for_goal(study, ThreadedExecutor(cache));
  EXPECT_TRUE(meshed.discretisation.halved_cells.empty());
  EXPECT_EQ(meshed.n_meshes, 0u);
}

// Reference: body of revolution, whose error is below a tenth of the smallest compared error.
TEST(SolidGoal, EstimatesAreCloseToTheErrorsAndEachRefinementHalvesTheErrorLong)
{
  Study study = lifting_foot();
  const Study of_revolution = study;
  study.contact.body = BodyKind::solid;
  study.contact.resolution = { 24, 2, 1 };
  for (const Goal goal : { Goal::terminal_spin, Goal::a2 })
  {
    SCOPED_TRACE(static_cast<int>(goal));
    study.contact.goal = goal;
    Discretisation mesh;
    const double exact = value_of(of_revolution, goal, 2);
    EXPECT_NEAR(value_of(of_revolution, goal, 1), exact, 1e-7 * (goal == Goal::a2 ? 1 : std::abs(exact)));
    double first = 0, value = 0;
    for (unsigned int n = 0; n < 3; ++n)
    {
      const GoalError found = error_of(study, mesh);
      const double error = exact - found.value;
      RecordProperty("ratio_" + std::to_string(static_cast<int>(goal)) + "_" + std::to_string(n),
                     std::to_string(found.error.correction / error));
      EXPECT_GT(found.error.correction / error, 0.8) << "mesh " << n << ", error " << error;
      EXPECT_LT(found.error.correction / error, 1.25) << "mesh " << n << ", error " << error;
      mesh.halved_cells.push_back(found.error.mark(0.8));
      if (n == 0)
      {
        first = error;
        value = found.value;
      }
      EXPECT_LT(std::abs(error), std::pow(0.5, n) * std::abs(first) * (1 + 1e-12));
    }
    if (goal != Goal::terminal_spin)
      continue;
    // A single refinement reaches a tolerance of 0.4 times the error of the first mesh.
    study.contact.goal_tolerance = std::abs(0.4 * first / value);
    fem::ComplianceCache cache;
    EXPECT_EQ(mesh_for_goal(study, ThreadedExecutor(cache)).discretisation.halved_cells.size(), 1u);
  }
}

} // namespace stemware::pipeline
