// What the results of `run` say of a mesh that was made for a goal.
#include "fem/pipeline/result/verb_results.h"
#include "tests/fem/pipeline/result/hand_made_studies.h"

#include <gtest/gtest.h>

namespace stemware::pipeline
{
namespace
{

using namespace test;

TEST(RunByHand, GoalOfTheMesh)
{
  RunByHand by_hand;
  by_hand.study.contact.goal = Goal::terminal_spin;
  by_hand.study.contact.goal_tolerance = 2e-5;
  GoalOutcome &goal = by_hand.goal.emplace();
  goal.value = -3.5;
  goal.estimated_error = 3e-5;
  goal.n_meshes = 4;
  goal.n_cells = 1000;
  by_hand.bands.back().parts["mesh"] = 6e-5;
  const Results results = run_results(by_hand);
  const auto &summary = results.summary["goal"];
  EXPECT_EQ(summary["name"], "terminal spin");
  EXPECT_EQ(summary["value"], -3.5);
  EXPECT_EQ(summary["estimated_error"], 3e-5);
  EXPECT_EQ(summary["band_of_mesh"], 6e-5);
  EXPECT_EQ(summary["tolerance"], 2e-5);
  EXPECT_EQ(summary["meshes"], 4);
  EXPECT_EQ(summary["cells"], 1000);
  EXPECT_EQ(summary["unknowns"], by_hand.contact.foot->foot.n_unknowns);
  EXPECT_FALSE(made_run().summary.contains("goal")); // of a study without one
}

} // namespace
} // namespace stemware::pipeline
