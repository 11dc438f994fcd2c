#include "fem/contact/contact_load.h"
#include "ring_model/load/constants.h"
#include "tests/ulps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

using stemware::ulps;
using namespace stemware::fem;

namespace
{
using stemware::ring::pi;

/// Returns @p n forces on a circle that sample lambda(theta) = 0.5 + 0.3 cos(theta) + 0.1 sin(theta) + 0.05
/// cos(2 theta) - 0.02 sin(3 theta).
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

TEST(ContactLoad, ReproducesTheHarmonicsOfAGivenDensity)
{
  const ContactLoad load = harmonics_of(ring_of_forces(40, 0.03), 4);
  const double a[] = { 0.5, 0.3, 0.05, 0, 0 };
  const double b[] = { 0, 0.1, 0, -0.02, 0 };
  for (unsigned int n = 0; n <= 4; ++n)
  {
    EXPECT_NEAR(load.a(n), a[n], ulps(9, a[0])) << n;
    EXPECT_NEAR(load.b(n), b[n], ulps(9, a[0])) << n;
  }
  EXPECT_NEAR(load.normal_force(), pi, 1e-14);
  EXPECT_NEAR(load.moment().x(), pi * 0.03 * 0.1, ulps(5, load.normal_force() * 0.03));
  EXPECT_NEAR(load.moment().y(), -pi * 0.03 * 0.3, ulps(5, load.normal_force() * 0.03));
  EXPECT_NEAR(load.radius(), 0.03, ulps(15, 0.03));
  EXPECT_NEAR(load.mean_radius, 0.03, ulps(15, 0.03));
}

TEST(ContactLoad, RadiusPreservesTheMomentOfTwoRings)
{

  std::vector<PointForce> forces = ring_of_forces(40, 0.028);
  for (const PointForce &force : ring_of_forces(40, 0.034))
    forces.push_back(force);
  const ContactLoad load = harmonics_of(forces, 2);
  EXPECT_NEAR(load.radius(), 0.031, ulps(15, 0.031));
  EXPECT_NEAR(std::hypot(load.moment().x(), load.moment().y()),
              pi * load.radius() * std::hypot(load.a(1), load.b(1)), ulps(5, load.normal_force() * 0.03));
}

TEST(ContactLoad, RadiusAtZeroMomentIsTheLimitForVanishingMoment)
{
  // Forces f (1 + c x) have the radius sum f r^2 / sum f r for every c.
  std::vector<PointForce> forces;
  for (unsigned int i = 0; i < 24; ++i)
    for (const double radius : { 0.028, 0.034 })
      forces.push_back({ radius * std::cos(pi * i / 12), radius * std::sin(pi * i / 12), 1 });
  const ContactLoad load = harmonics_of(forces, 2);
  EXPECT_NEAR(load.radius(), (0.028 * 0.028 + 0.034 * 0.034) / (0.028 + 0.034), ulps(15, 0.031));
  EXPECT_NEAR(load.mean_radius, 0.031, ulps(15, 0.031));
}

TEST(ContactLoad, ManyRingsDoNotAmplifyRoundingOutsideTheContact)
{
  // A force of 1e-16 N acts at five half-widths from the middle of the rings, where Lagrange polynomials of
  // 40 rings reach 1e39.
  std::vector<double> radii;
  for (int j = 39; j >= 0; --j)
    radii.push_back(0.030 + 0.0004 * std::cos(pi * (j + 0.5) / 40));
  const RingWeights weights(radii);
  const Eigen::VectorXd share = weights.at(0.032);
  EXPECT_NEAR(share.sum(), 1, 1e-12);
  EXPECT_NEAR(share.dot(Eigen::Map<const Eigen::VectorXd>(radii.data(), 40)), 0.032, 1e-14);
  EXPECT_LT(share.lpNorm<1>(), 10);
  const ContactLoad load = harmonics_of({ { 0.0301, 0, 1 }, { 0.032, 0, 1e-16 } }, 1, radii);
  double largest = 0;
  for (const auto &ring : load.rings())
    largest = std::max(largest, std::abs(ring.a[0]));
  EXPECT_LT(largest, 1);
}

TEST(ContactLoad, NRingsPreserveExactlyNRadialMomentsOfEveryHarmonic)
{
  // For k < n_rings, the ring loads lambda_j preserve the moments of the point forces f in every harmonic:
  // sum_j r_j^k lambda_j = sum f r^k.
  std::vector<PointForce> forces;
  for (unsigned int i = 0; i < 200; ++i)
  {
    const double theta = 2.4 * i;
    const double radius = 0.028 + 2e-5 * i;
    forces.push_back(
      { radius * std::cos(theta), radius * std::sin(theta), 0.01 * (1 + 0.3 * std::sin(7. * i)) });
  }
  const std::vector<double> all_radii = { 0.0285, 0.0297, 0.0308, 0.0322 };
  for (unsigned int n_rings = 1; n_rings <= 4; ++n_rings)
  {
    const std::vector<double> radii(all_radii.begin(), all_radii.begin() + n_rings);
    const ContactLoad load = harmonics_of(forces, 6, radii);
    EXPECT_EQ(load.radii(), radii);
    ASSERT_EQ(load.rings().size(), n_rings);
    ASSERT_EQ(load.n_harmonics(), 6u);
    for (unsigned int k = 0; k < n_rings; ++k)
      for (unsigned int n = 0; n <= 6; ++n)
      {
        double even = 0, odd = 0, scale = 0;
        for (const PointForce &point : forces)
        {
          const double part = point.force * std::pow(std::hypot(point.x, point.y), k) / (n > 0 ? pi : 2 * pi);
          const double theta = std::atan2(point.y, point.x);
          even += part * std::cos(n * theta);
          odd += part * std::sin(n * theta);
          scale += part;
        }
        for (unsigned int j = 0; j < n_rings; ++j)
        {
          even -= std::pow(radii[j], k) * load.rings()[j].a[n];
          odd -= std::pow(radii[j], k) * load.rings()[j].b[n];
        }
        EXPECT_NEAR(even / scale, 0, 1e-11) << n_rings << " rings, moment " << k << ", harmonic " << n;
        EXPECT_NEAR(odd / scale, 0, 1e-11) << n_rings << " rings, moment " << k << ", harmonic " << n;
      }
    double missed = 0, scale = 0;
    for (const PointForce &point : forces)
      missed += point.force * std::pow(std::hypot(point.x, point.y) / 0.03, n_rings) / (2 * pi),
        scale += point.force;
    for (unsigned int j = 0; j < n_rings; ++j)
      missed -= std::pow(radii[j] / 0.03, n_rings) * load.rings()[j].a[0];
    EXPECT_GT(std::abs(missed) / scale, 1e-10) << n_rings;
  }
}

TEST(ContactLoad, MinimumIsFoundBetweenSamplesAndIsNotNegativeUnderCompression)
{
  // The minimum of 0.5 + 0.45 cos(theta - phase) is 0.05. The lowest sample exceeds the minimum by up to
  // 2e-3, and the minimum of a parabola through three samples has an error of 1e-5. The trigonometric
  // interpolation of equidistant samples is exact up to rounding.
  for (const unsigned int n : { 32u, 33u })
    for (const double phase : { 0., 0.1, 0.3, 0.5, 0.9 })
    {
      std::vector<AzimuthValue> pointwise;
      for (unsigned int i = 0; i < n; ++i)
        pointwise.push_back({ 2 * pi * i / n, 0.5 + 0.45 * std::cos(2 * pi * (i - phase) / n) });
      EXPECT_NEAR(least_load(pointwise), 0.05, 1e-14) << n << " " << phase;
    }
  const auto parabola = [](double theta) { return 0.2 + 3 * std::pow(theta - 3.05, 2); };
  EXPECT_NEAR(
    least_load({ { 0, 9 }, { 2.8, parabola(2.8) }, { 3.1, parabola(3.1) }, { 3.7, parabola(3.7) } }), 0.2,
    1e-13);
  // A compressive load has no negative minimum, even if the parabola through three samples has one.
  EXPECT_EQ(least_load({ { 0, 1 }, { 1, 1e-6 }, { 2, 0.9 }, { 4, 5 } }), 0);
  EXPECT_EQ(least_load({ { 0, 1 }, { 1, 0 }, { 2, 0.9 } }), 0);
}

TEST(ContactLoad, RingsRotateWithTheLoad)
{
  std::vector<PointForce> forces = ring_of_forces(40, 0.028);
  std::vector<PointForce> turned;
  const double angle = 0.7;
  for (const PointForce &force : ring_of_forces(30, 0.034))
    forces.push_back(force);
  for (const PointForce &force : forces)
    turned.push_back({ force.x * std::cos(angle) - force.y * std::sin(angle),
                       force.x * std::sin(angle) + force.y * std::cos(angle), force.force });
  const ContactLoad expected = harmonics_of(turned, 4, { 0.029, 0.033 });
  const ContactLoad load = harmonics_of(forces, 4, { 0.029, 0.033 }).rotated(angle);
  EXPECT_NEAR(load.moment().x(), expected.moment().x(), ulps(30, load.normal_force() * 0.03));
  EXPECT_NEAR(load.moment().y(), expected.moment().y(), ulps(30, load.normal_force() * 0.03));
  for (unsigned int j = 0; j < 2; ++j)
    for (unsigned int n = 0; n <= 4; ++n)
    {
      EXPECT_NEAR(load.rings()[j].a[n], expected.rings()[j].a[n], 1e-13);
      EXPECT_NEAR(load.rings()[j].b[n], expected.rings()[j].b[n], 1e-13);
    }
}

TEST(ContactLoad, RefusesInvalidRadiiAndAnEmptyLoad)
{
  const std::vector<PointForce> forces = ring_of_forces(40, 0.03);
  using Radii = std::vector<double>;
  for (const Radii &radii : { Radii{ 0.03, 0.03 }, Radii{ 0.031, 0.03 }, Radii{ -0.01, 0.03 },
                              Radii{ 0.03, std::nan("") }, Radii{ 0.03, INFINITY } })
    EXPECT_THROW(harmonics_of(forces, 2, radii), std::invalid_argument);
  EXPECT_THROW(harmonics_of({}, 2), std::invalid_argument);
}
