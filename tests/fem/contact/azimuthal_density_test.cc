#include "fem/contact/azimuthal_density.h"
#include "ring_model/load/constants.h"

#include <gtest/gtest.h>

#include <cmath>

using stemware::ring::pi;
using namespace stemware::fem;

namespace
{

double density_at(double azimuth)
{
  return 1 + 0.6 * std::cos(azimuth) + 0.3 * std::sin(azimuth);
}

ContactSurface lines_round_the_rim(unsigned int n_lines, double first)
{
  ContactSurface surface;
  for (unsigned int j = 0; j < n_lines; ++j)
  {
    ContactLine line;
    line.azimuth_width = 2 * pi / n_lines;
    line.azimuth = std::remainder(first + j * line.azimuth_width, 2 * pi);
    surface.lines.push_back(line);
  }
  return surface;
}

std::vector<double> forces_on(const ContactSurface &surface)
{
  std::vector<double> forces;
  for (const ContactLine &line : surface.lines)
    forces.push_back(density_at(line.azimuth) * line.azimuth_width);
  return forces;
}

} // namespace

TEST(AzimuthalDensity, EqualsTheDensityAtTheAzimuthsOfRadialLines)
{
  ContactSurface surface = lines_round_the_rim(40, 0.05);
  surface.lines_are_radial = true;
  const std::vector<AzimuthValue> density = density_of_lines(surface, forces_on(surface));
  ASSERT_EQ(density.size(), 40u);
  for (const AzimuthValue &place : density)
    EXPECT_NEAR(place.value, density_at(place.azimuth), 1e-12) << place.azimuth;
}

TEST(AzimuthalDensity, EqualsTheSectorMeanOnLinesThatAreNotRadial)
{
  // The mean of a first harmonic over a sector of the angle 2 h is the value at the middle of the sector
  // times sin(h) / h.
  ContactSurface surface = lines_round_the_rim(4000, pi / 4000);
  surface.n_sectors = 10;
  const std::vector<AzimuthValue> density = density_of_lines(surface, forces_on(surface));
  ASSERT_EQ(density.size(), 10u);
  const double half = pi / 10;
  for (const AzimuthValue &place : density)
    EXPECT_NEAR(place.value, 1 + (density_at(place.azimuth) - 1) * std::sin(half) / half, 1e-6)
      << place.azimuth;
}

TEST(AzimuthalDensity, EqualsTheSectorMeanOfNodalForces)
{
  const unsigned int n_nodes = 40;
  ContactSurface surface;
  surface.n_sectors = n_nodes / 2;
  surface.node_position.resize(n_nodes, 2);
  surface.node_gap = Eigen::VectorXd::Zero(n_nodes);
  Eigen::VectorXd forces(n_nodes);
  for (unsigned int i = 0; i < n_nodes; ++i)
  {
    const double azimuth = 0.05 + 2 * pi * i / n_nodes;
    surface.node_position.row(i) << 0.03 * std::cos(azimuth), 0.03 * std::sin(azimuth);
    forces(i) = density_at(azimuth) * 2 * pi / n_nodes;
  }
  const double mean = std::cos(pi / n_nodes); // each sector has two nodes
  for (const AzimuthValue &place : density_of_nodes(surface, forces))
    EXPECT_NEAR(place.value, 1 + (density_at(place.azimuth) - 1) * mean, 1e-12) << place.azimuth;
}
