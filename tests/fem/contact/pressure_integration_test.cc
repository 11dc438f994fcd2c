#include "fem/contact/rough_interface.h"
#include "tests/fem/revolution/revolution_case.h"

#include <gtest/gtest.h>

using namespace stemware::revolution_tests;

namespace
{

/// Returns the nodal forces int p N_i r dr dtheta by the midpoint rule with @p n_points per line, within @p
/// reach [m] of the middle of the rim. The error at contact edges is quadratic in the spacing.
template <typename Law>
Eigen::VectorXd point_sums(const ContactSurface &surface, const Law &law,
                           const Eigen::VectorXd &normal_displacement, unsigned int n_points, double reach)
{
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(surface.n_nodes());
  for (const ContactLine &line : surface.lines)
  {
    const double inner = line.position.row(0).norm(), outer = line.position.row(2).norm();
    Eigen::Vector3d displacement;
    for (unsigned int sample = 0; sample < 3; ++sample)
      displacement(sample) = normal_displacement(line.nodes[sample]);
    const double first = std::max(0., (0.03 - reach - inner) / (outer - inner));
    const double last = std::min(1., (0.03 + reach - inner) / (outer - inner));
    for (unsigned int point = 0; last > first && point < n_points; ++point)
    {
      const double t = first + (last - first) * (point + 0.5) / n_points;
      const Eigen::Vector3d shape((1 - t) * (1 - 2 * t), 4 * t * (1 - t), t * (2 * t - 1));
      const double radius = inner + t * (outer - inner);
      const double area = radius * line.azimuth_width * (outer - inner) * (last - first) / n_points;
      const double force = law.pressure(-shape.dot(line.gap + displacement)) * area;
      for (unsigned int sample = 0; sample < 3; ++sample)
        forces(line.nodes[sample]) += force * shape(sample);
    }
  }
  return forces;
}

Eigen::VectorXd bent(const ContactSurface &surface, double depth)
{
  Eigen::VectorXd displacement(surface.n_nodes());
  for (Eigen::Index i = 0; i < displacement.size(); ++i)
  {
    const double x = surface.node_position(i, 0), y = surface.node_position(i, 1);
    const double across = (surface.node_position.row(i).norm() - 0.03) / 0.002;
    displacement(i) = depth * (-1 - 0.7 * x / 0.03 + 0.3 * y / 0.03 + 0.2 * across - 0.1 * across * across);
  }
  return displacement;
}

template <typename Law>
double error_of(const Law &law, const GlassProfile &profile, unsigned int land_cells, double depth,
                double reach = 1)
{
  MeridianResolution resolution = equal_cells();
  resolution.land_cells = land_cells;
  const RevolutionCase foot(profile, foot_compliance(profile, resolution, { 2, 1 }), 3);
  const ContactSurface &surface = foot.body.contact_surface();
  const Eigen::VectorXd displacement = bent(surface, depth);
  ContactForces contact;
  make_law(law, surface)->evaluate(displacement, contact);
  const Eigen::VectorXd expected = point_sums(surface, law, displacement, 30000, reach);
  return (contact.forces - expected).cwiseAbs().maxCoeff() / expected.cwiseAbs().maxCoeff();
}

} // namespace

// The point sums have an error of about 1e-9, or 1e-8 for a RoughInterface.
TEST(PressureIntegration, AgreesWithPointSumsForAWinklerInterface)
{
  for (const unsigned int land_cells : { 2u, 8u, 40u })
  {
    EXPECT_LT(error_of(WinklerInterface(1e10), GlassProfile(), land_cells, 6e-6), 5e-9) << land_cells;
    EXPECT_LT(error_of(WinklerInterface(1e10), flat_profile(), land_cells, 6e-6), 5e-9) << land_cells;
  }
}

/// The spring is as stiff as for a HardInterface, and the contact lies within a single cell.
TEST(PressureIntegration, AgreesWithPointSumsForAStiffSpring)
{
  for (const unsigned int land_cells : { 2u, 8u, 40u })
    EXPECT_LT(error_of(WinklerInterface(1e15), GlassProfile(), land_cells, 1e-8, 2e-5), 5e-9) << land_cells;
}

TEST(PressureIntegration, AgreesWithPointSumsForARoughInterface)
{
  for (const double decay_length : { 1e-7, 1e-6, 1e-5 })
    for (const double depth : { -3 * decay_length, 2 * decay_length, 20 * decay_length })
      for (const unsigned int land_cells : { 2u, 8u, 40u })
        for (const GlassProfile &profile : { GlassProfile(), flat_profile() })
          EXPECT_LT(error_of(RoughInterface(1e9, decay_length), profile, land_cells, depth), 2e-8)
            << land_cells << " cells, s = " << decay_length << ", pressed in by " << depth;
}
