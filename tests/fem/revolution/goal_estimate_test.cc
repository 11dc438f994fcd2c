#include "fem/contact/contact_goal.h"
#include "fem/contact/hard_interface.h"
#include "fem/contact/winkler_interface.h"
#include "fem/revolution/meshed_revolution_foot.h"
#include "tests/fem/reference_load.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <stdexcept>
#include <vector>

namespace stemware::revolution_tests
{

using namespace stemware::fem;
using namespace stemware::fem_tests;

namespace
{

ContactDemand demand_of(double m)
{
  ContactDemand demand = load_at(m, 0.5);
  demand.ring_radii = { 0.0295, 0.0305 };
  demand.n_harmonics = 4;
  return demand;
}

/// a_n + b_n of all rings together.
ContactGoal harmonic_goal(std::size_t n)
{
  ContactGoal goal;
  goal.ring_radii = demand_of(0).ring_radii;
  std::vector<double> one(n + 1, 0.);
  one[n] = 1;
  goal.of_load = { { one, one }, { one, one } };
  return goal;
}

struct Estimated
{
  double value;
  MeshError error;
};

Estimated estimated(const RevolutionSetup &setup, double m, std::size_t n, bool with_cells = false)
{
  MeshedRevolutionFoot foot(setup);
  const ContactState state = foot.solve(demand_of(m), { 10, {} });
  const ContactGoal goal = harmonic_goal(n);
  return { goal.of_load(state.load), foot.mesh_error(state, goal, with_cells).value() };
}

} // namespace

/// Few harmonics and lines on a coarse mesh: they are not the mesh's.
RevolutionSetup small_setup(GlassShape shape)
{
  RevolutionSetup setup;
  setup.profile.shape = shape;
  setup.friction_coefficient = 0.2;
  setup.n_lines = 64;
  setup.meridian.n_harmonics = 6;
  setup.fineness = 0.5;
  return setup;
}

// Oracle: the same number on a mesh of sixteen times the cells, without any estimate.
TEST(GoalEstimate, IsTheErrorOfASmoothFoot)
{
  RevolutionSetup setup = small_setup(GlassShape::foot).resolved_for(weight);
  const Estimated coarse = estimated(setup, 1.2, 2);
  setup.resolution.refinements += 2;
  const double error = estimated(setup, 1.2, 2).value - coarse.value;
  EXPECT_NEAR(coarse.error.correction, error, 0.1 * std::abs(error));
}

// Oracle: the same number on a mesh that is graded to the corners much further, without any estimate; the
// error that mesh itself has left is a thirtieth of the smallest judged.
TEST(GoalEstimate, IsTheErrorOnMeshesGradedToCornersAndTheEdgeOfTheContact)
{
  struct Case
  {
    const char *name;
    double crown_radius;
    std::shared_ptr<const InterfaceLaw> interface;
  };
  for (const Case &one : { Case{ "crown on a mat", 0.01, std::make_shared<WinklerInterface>() },
                           Case{ "flat land on a hard table", 0, std::make_shared<HardInterface>() } })
  {
    SCOPED_TRACE(one.name);
    RevolutionSetup setup = small_setup(GlassShape::step);
    if (one.crown_radius == 0)
      setup.profile = flat_profile();
    setup.table.interface = one.interface;
    setup = setup.resolved_for(weight);
    std::vector<Estimated> levels;
    for (unsigned int level = 0; level < 3; ++level)
    {
      levels.push_back(estimated(setup, 1.2, 2, true));
      setup.halved.push_back(levels.back().error.mark(0.8));
    }
    for (unsigned int level = 0; level < 3; ++level)
      setup.halved.push_back(estimated(setup, 1.2, 2, true).error.mark(0.95));
    const double truth = estimated(setup, 1.2, 2).value;
    for (const Estimated &level : levels)
      EXPECT_NEAR(level.error.correction / (truth - level.value), 1, 0.1);
    EXPECT_LT(std::abs(levels[2].error.correction), 0.4 * std::abs(levels[0].error.correction));
  }
}

// Closed form: a mark of the largest cells alone.
TEST(GoalEstimate, MarksTheFewestCellsWithTheShareAskedFor)
{
  MeshError error;
  error.foot_cells = { 1, 4, 2 };
  error.disc_cells = { 3, 0 };
  const MarkedCells marked = error.mark(0.65);
  EXPECT_EQ(marked.foot, std::vector<unsigned int>({ 1 }));
  EXPECT_EQ(marked.disc, std::vector<unsigned int>({ 0 }));
}

TEST(GoalEstimate, RefusesTheHighestDegree)
{
  RevolutionSetup setup = small_setup(GlassShape::foot);
  setup.meridian.degree = 4;
  EXPECT_THROW(estimated(setup.resolved_for(weight), 0.5, 2), std::invalid_argument);
}

} // namespace stemware::revolution_tests
