#include "fem/contact/line_integral.h"
#include "tests/ulps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace stemware::fem;

namespace
{
ContactLine radial_line(double azimuth)
{
  ContactLine line;
  const double width = 1e-3;
  for (int s = 0; s < 3; ++s)
  {
    const double radius = 0.028 + 0.002 * s;
    line.position.row(s) << radius * std::cos(azimuth), radius * std::sin(azimuth);
    line.transverse_tangent.row(s) << -radius * width * std::sin(azimuth), radius * width * std::cos(azimuth);
  }
  return line;
}
} // namespace

TEST(LineIntegral, FindsTheIntervalsWhereAQuadraticIsPositive)
{
  // Samples of (xi - 0.5)(xi + 0.25) at -1, 0, 1.
  const PositiveSegments two(Eigen::Vector3d(1.125, -0.125, 0.625));
  ASSERT_EQ(two.n_segments, 2u);
  EXPECT_NEAR(two.segments[0].end, -0.25, stemware::ulps(18, 0.25));
  EXPECT_NEAR(two.segments[1].begin, 0.5, stemware::ulps(9, 0.5));

  const PositiveSegments inner(Eigen::Vector3d(-1.125, 0.125, -0.625));
  ASSERT_EQ(inner.n_segments, 1u);
  EXPECT_NEAR(inner.segments[0].begin, -0.25, stemware::ulps(18, 0.25));
  EXPECT_NEAR(inner.segments[0].end, 0.5, stemware::ulps(9, 0.5));

  EXPECT_EQ(PositiveSegments(Eigen::Vector3d(1, 1, 1)).n_segments, 1u);
  EXPECT_EQ(PositiveSegments(Eigen::Vector3d(-1, -1, -1)).n_segments, 0u);
  EXPECT_EQ(PositiveSegments(Eigen::Vector3d::Zero()).n_segments, 0u);

  // A linear function, and a nearly linear function for which the textbook formula suffers from cancellation.
  EXPECT_NEAR(PositiveSegments(Eigen::Vector3d(-1, 0.5, 2)).segments[0].begin, -1. / 3,
              stemware::ulps(14, 0.33));
  EXPECT_NEAR(PositiveSegments(Eigen::Vector3d(-1 + 1e-14, 0.5, 2 + 1e-14)).segments[0].begin, -1. / 3,
              1e-13);
}

TEST(LineIntegral, AgreesWithTheMidpointRuleOnRandomPenetrations)
{
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  constexpr unsigned int n_points = 400000;
  for (unsigned int sample = 0; sample < 20; ++sample)
  {
    const ContactLine line = radial_line(uniform(generator));
    const Eigen::Vector3d depth(uniform(generator), uniform(generator), uniform(generator));
    Eigen::Vector3d exact = Eigen::Vector3d::Zero();
    for_each_loaded_point(AreaElement(line), depth,
                          [&](const LinePoint &point)
                          {
                            EXPECT_GT(point.area, 0);
                            const Eigen::Vector3d shape = line_shape(point.xi);
                            exact += shape * shape.dot(depth) * point.area;
                          });
    Eigen::Vector3d brute = Eigen::Vector3d::Zero();
    for (unsigned int i = 0; i < n_points; ++i)
    {
      const double xi = -1 + 2 * (i + 0.5) / n_points;
      const Eigen::Vector3d shape(xi * (xi - 1) / 2, (1 - xi) * (1 + xi), xi * (xi + 1) / 2);
      const double radius = 0.030 + 0.002 * xi;
      brute += shape * std::max(0., shape.dot(depth)) * radius * 1e-3 * 0.004 / n_points;
    }
    // The midpoint rule has an error of 1e-10 at kinks, relative to integrals of about 1e-7.
    EXPECT_LT((exact - brute).norm(), 2e-10 * 1.2e-7) << "sample " << sample;
  }
}
