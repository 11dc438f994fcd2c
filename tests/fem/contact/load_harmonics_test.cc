#include "fem/contact/load_harmonics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

using namespace stemware::fem;

namespace
{
constexpr double pi = 3.14159265358979323846;

/// lambda(theta) = 0.5 + 0.3 cos + 0.1 sin + 0.05 cos 2 - 0.02 sin 3, sampled as @p n forces on a circle.
std::vector<PointForce> ring_of_forces(unsigned int n, double radius)
{
  std::vector<PointForce> forces;
  for (unsigned int i = 0; i < n; ++i)
  {
    const double theta = 2 * pi * (i + 0.3) / n;
    const double lambda = 0.5 + 0.3 * std::cos(theta) + 0.1 * std::sin(theta) + 0.05 * std::cos(2 * theta) -
                          0.02 * std::sin(3 * theta);
    forces.push_back({ radius * std::cos(theta), radius * std::sin(theta), lambda * 2 * pi / n });
  }
  return forces;
}
} // namespace

TEST(RingStack, HarmonicsOfAKnownLoad)
{
  const LoadHarmonics load = harmonics_of(ring_of_forces(40, 0.03), 4);
  const double a[] = { 0.5, 0.3, 0.05, 0, 0 };
  const double b[] = { 0, 0.1, 0, -0.02, 0 };
  for (unsigned int n = 0; n <= 4; ++n)
  {
    EXPECT_NEAR(load.a[n], a[n], 1e-15) << n;
    EXPECT_NEAR(load.b[n], b[n], 1e-15) << n;
  }
  EXPECT_NEAR(load.normal_force, pi, 1e-14);
  EXPECT_NEAR(load.moment_x, pi * 0.03 * 0.1, 1e-16);
  EXPECT_NEAR(load.moment_y, -pi * 0.03 * 0.3, 1e-16);
  EXPECT_NEAR(load.ring_radius, 0.03, 1e-16);
  EXPECT_NEAR(load.mean_radius, 0.03, 1e-16);
}

TEST(RingStack, RingRadiusCarriesTheMomentOfTwoRings)
{
  // Two rings of different radius and first harmonic: the moment over pi times the summed first harmonic lies
  // between their radii.
  std::vector<PointForce> forces = ring_of_forces(40, 0.028);
  for (const PointForce &force : ring_of_forces(40, 0.034))
    forces.push_back(force);
  const LoadHarmonics load = harmonics_of(forces, 2);
  EXPECT_NEAR(load.ring_radius, 0.031, 1e-15);
  EXPECT_NEAR(std::hypot(load.moment_x, load.moment_y),
              pi * load.ring_radius * std::hypot(load.a[1], load.b[1]), 1e-16);
}

TEST(RingStack, WithoutMomentTheRadiusIsTheLimit)
{
  std::vector<PointForce> forces;
  for (unsigned int i = 0; i < 24; ++i)
    for (const double radius : { 0.028, 0.034 })
      forces.push_back({ radius * std::cos(pi * i / 12), radius * std::sin(pi * i / 12), 1 });
  const LoadHarmonics load = harmonics_of(forces, 2);
  EXPECT_NEAR(load.ring_radius, (0.028 * 0.028 + 0.034 * 0.034) / (0.028 + 0.034), 1e-15);
  EXPECT_NEAR(load.mean_radius, 0.031, 1e-15);
}

TEST(RingStack, RefusesNoLoad)
{
  EXPECT_THROW(harmonics_of({}, 2), std::invalid_argument);
}

TEST(ResolvedFriction, AtRestIsTheMomentOfTheLoad)
{
  const std::vector<PointForce> forces = ring_of_forces(40, 0.03);
  const LoadHarmonics load = harmonics_of(forces, 1);
  const ResolvedFriction friction = resolved_friction(forces, 0.3, 0, 0.35);
  EXPECT_NEAR(friction.force_x, -0.3 * load.normal_force, 1e-15);
  EXPECT_NEAR(friction.force_y, 0, 1e-16);
  EXPECT_NEAR(friction.torque, 0.3 * load.moment_x, 1e-17);
}

TEST(ResolvedFriction, TakesEnergyAndDampsThePureSpin)
{
  const std::vector<PointForce> forces = ring_of_forces(40, 0.03);
  for (const double omega : { -30., -3., 4., 40. })
  {
    const ResolvedFriction friction = resolved_friction(forces, 0.3, omega, 0.35);
    EXPECT_LT(friction.force_x * 0.35 + friction.torque * omega, 0) << omega;
  }
  const ResolvedFriction spin = resolved_friction(forces, 0.3, 5, 0);
  EXPECT_NEAR(spin.torque, -0.3 * 0.03 * pi, 1e-15);
}
