// Small functions between contact and results: values at nodes, marked cells, step lengths, pressure maps.
#include "fem/contact/contact_demand.h"
#include "fem/contact/contact_goal.h"
#include "fem/contact/contact_load.h"
#include "fem/contact/line_search.h"
#include "fem/contact/pressure_map.h"
#include "ring_model/friction_functionals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>
#include <vector>

using namespace stemware::fem;

TEST(ContactDemand, ValuesAtNodesAreThoseOfUnitForcesOnThem)
{
  // The second node mirrors the first one, the others share its azimuth, as far as rounding goes, or not.
  const std::vector<double> radii = { 0.0297, 0.03, 0.0303 };
  const auto functional =
    stemware::ring::friction_functionals(stemware::ring::CoulombLaw(0.3), radii, 8, -4., 0.35).side;
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

TEST(MeshError, MarksTheLargestCellsAndAllThatAreEqual)
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

TEST(LineSearch, FindsTheZeroOfACurvedSlope)
{
  // exp(s) - exp(zero) has its zero at `zero`; the bracket ends within two per cent.
  const auto step = [](double zero, bool may_go_beyond)
  {
    const auto slope = [zero](double s) { return std::exp(s) - std::exp(zero); };
    return line_search_step(slope, slope(0), slope(1), 0, may_go_beyond);
  };
  for (const double zero : { 0.1, 0.4, 0.7 })
    for (const bool may_go_beyond : { false, true })
      EXPECT_NEAR(step(zero, may_go_beyond), zero, 0.02 * zero) << may_go_beyond;
  EXPECT_NEAR(step(1.6, true), 1.6, 0.02 * 1.6);
  EXPECT_EQ(step(1.6, false), 1);
  EXPECT_EQ(step(2.5, true), 2);
  EXPECT_EQ(step(1.001, true), 1);
}

namespace
{

/// Radial lines between 29 and 31 mm at @p n_azimuths azimuths, two lines each, with own nodes.
ContactSurface radial_lines(unsigned int n_azimuths)
{
  ContactSurface surface;
  surface.lines_are_radial = true;
  surface.n_sectors = n_azimuths;
  surface.node_position.resize(6 * n_azimuths, 2);
  surface.node_gap = Eigen::VectorXd::Zero(6 * n_azimuths);
  for (unsigned int j = 0; j < 2 * n_azimuths; ++j)
  {
    ContactLine line;
    line.azimuth = 0.3 + 2 * M_PI * (j / 2) / n_azimuths;
    line.samples_are_nodes = true;
    line.gap.setZero();
    for (unsigned int i = 0; i < 3; ++i)
    {
      const double radius = 0.029 + 0.0005 * (2 * (j % 2) + i);
      line.nodes.push_back(3 * j + i);
      line.position.row(i) << radius * std::cos(line.azimuth), radius * std::sin(line.azimuth);
      surface.node_position.row(3 * j + i) = line.position.row(i);
    }
    surface.lines.push_back(line);
  }
  return surface;
}

} // namespace

TEST(PressureMap, OfRadialLinesCoversTheLoadedLand)
{
  // A penetration that is quadratic along the lines, another one at each azimuth; the pressure is its cube.
  const ContactSurface surface = radial_lines(5);
  const auto depth = [](double radius, double azimuth)
  { return 1 + 0.5 * std::cos(azimuth) + 50 * (radius - 0.029) * (1 + 400 * (radius - 0.03)); };
  Eigen::VectorXd displacement(surface.n_nodes());
  for (unsigned int i = 0; i < surface.n_nodes(); ++i)
    displacement(i) = -depth(surface.node_position.row(i).norm(),
                             std::atan2(surface.node_position(i, 1), surface.node_position(i, 0)));
  const PressureMap map = pressure_map_of_lines(surface, displacement, [](double d) { return d * d * d; });
  EXPECT_TRUE(map.is_grid);
  ASSERT_EQ(map.cuts.size(), 5u);
  for (unsigned int c = 0; c < 5; ++c)
  {
    const auto &cut = map.cuts[c];
    EXPECT_NEAR(cut.front().radius, 0.029, 1e-12);
    EXPECT_NEAR(cut.back().radius, 0.031, 1e-12);
    for (const PressurePoint &point : cut)
    {
      EXPECT_NEAR(point.azimuth, 0.3 + 2 * M_PI * c / 5, 1e-12);
      EXPECT_NEAR(point.pressure, std::pow(depth(point.radius, point.azimuth), 3), 1e-10) << point.radius;
    }
  }
}

TEST(PointForces, TurnCounterClockwise)
{
  const std::vector<PointForce> turned = rotated_by({ { 3, 4, 7 }, { -1, 2, 5 } }, 0.5);
  ASSERT_EQ(turned.size(), 2u);
  for (const auto &[i, x, y, force] : { std::tuple(0, 3., 4., 7.), std::tuple(1, -1., 2., 5.) })
  {
    const double azimuth = std::atan2(y, x) + 0.5, radius = std::hypot(x, y);
    EXPECT_NEAR(turned[i].x, radius * std::cos(azimuth), 1e-15 * radius * 4);
    EXPECT_NEAR(turned[i].y, radius * std::sin(azimuth), 1e-15 * radius * 4);
    EXPECT_EQ(turned[i].force, force);
  }
}
