#include "fem/contact/contact_goal.h"
#include "fem/contact/hard_interface.h"
#include "fem/revolution/revolution_foot.h"
#include "tests/fem/reference_load.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

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
  RevolutionFoot foot(setup.resolved_for(weight));
  const ContactState state = foot.solve(demand_of(m), { 10, {} });
  const ContactGoal goal = harmonic_goal(n);
  return { goal.of_load(state.load), foot.mesh_error(state, goal, with_cells).value() };
}

} // namespace

TEST(GoalEstimate, Probe)
{
  for (const int kind : { 0, 1, 2, 3, 4 })
    for (const double m : { 0.5, 1.2 })
      {
        RevolutionSetup setup;
        setup.friction_coefficient = 0.2;
        setup.n_lines = 64;
        if (kind == 1)
          setup.table.interface = std::make_shared<HardInterface>();
        if (kind == 2)
        {
          setup.profile = flat_profile();
          setup.table.interface = std::make_shared<HardInterface>();
        }
        if (kind == 3)
        {
          setup.table.interface = std::make_shared<HardInterface>();
          setup.table.substrate = Substrate();
        }
        if (kind == 4)
          setup.profile.shape = GlassShape::step;
        std::vector<Estimated> levels;
        std::vector<double> sums;
        for (unsigned int level = 0; level < 4; ++level)
        {
          if (kind == 1 || kind == 3)
            setup.fineness = std::pow(2., level - 1.);
          else
            setup.resolution.refinements = level;
          levels.push_back(estimated(setup, m, 2, true));
          double sum = 0;
          for (const double share : levels.back().error.foot_cells)
            sum += share;
          sums.push_back(sum);
        }
        for (std::size_t level = 0; level < 4; ++level)
          std::cerr << kind << " m " << m << " level " << level << " value " << levels[level].value << " est "
                    << levels[level].error.correction << " cells " << sums[level] << " true "
                    << levels.back().value + levels.back().error.correction - levels[level].value << " ratio "
                    << levels[level].error.correction /
                         (levels.back().value + levels.back().error.correction - levels[level].value)
                    << '\n';
      }
}

} // namespace stemware::revolution_tests
