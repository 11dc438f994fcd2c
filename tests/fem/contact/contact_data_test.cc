#include "fem/contact/contact_demand.h"
#include "fem/contact/contact_goal.h"
#include "fem/contact/contact_load.h"
#include "ring_model/friction_functionals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace stemware::fem;

TEST(ContactDemand, NodeValuesEqualTheFunctionalOfUnitForces)
{
  // node_values() evaluates nodes with equal or mirrored azimuths together.
  const std::vector<double> radii = { 0.0297, 0.03, 0.0303 };
  const auto functional =
    stemware::ring::friction_functionals(stemware::ring::coulomb_law(0.3), radii, 8, -4., 0.35).side;
  ContactSurface surface;
  surface.node_position.resize(7, 2);
  surface.node_gap = Eigen::VectorXd::Zero(7);
  const double places[7][2] = { { 0.7, 0.0298 }, { -0.7, 0.0299 }, { 0.7, 0.0301 }, { 0.7, 0.0302 },
                                { 2.4, 0.0298 }, { 2.4, 0.0301 },  { -2.4, 0.0302 } };
  for (unsigned int i = 0; i < 7; ++i)
    surface.node_position.row(i) << places[i][1] * std::cos(places[i][0]),
      places[i][1] * std::sin(places[i][0]);
  const Eigen::VectorXd values = node_values(surface, radii, functional);
  for (unsigned int i = 0; i < 7; ++i)
  {
    const ContactLoad unit =
      harmonics_of({ { surface.node_position(i, 0), surface.node_position(i, 1), 1 } }, 8, radii);
    EXPECT_NEAR(values(i), functional(unit), 1e-13) << i;
  }
}

TEST(MeshError, MarksTheCellsOfLargestErrorIncludingTies)
{
  const MeshError error = { 0, { 1, 5, 3, 5, 0.5, 0, 3 } };
  using Cells = std::vector<unsigned int>;
  EXPECT_EQ(error.mark(0), Cells{});
  EXPECT_EQ(error.mark(0.1), (Cells{ 1, 3 }));
  EXPECT_EQ(error.mark(0.5), (Cells{ 1, 3 }));
  EXPECT_EQ(error.mark(0.6), (Cells{ 1, 3, 2, 6 }));
  EXPECT_EQ(error.mark(0.95), (Cells{ 1, 3, 2, 6, 0 }));
  EXPECT_EQ(error.mark(1), (Cells{ 1, 3, 2, 6, 0, 4 }));
}
