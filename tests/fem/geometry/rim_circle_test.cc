#include "fem/geometry/rim_circle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace stemware::fem
{
namespace
{

using Polyline = std::vector<SectionVertex>;

/// Returns the underside of a foot: an arc of radius @p crown [m] at r = 30.012 mm, with straight flanks. @p
/// n_land points lie on the land of width @p land [m], more points on both sides.
Polyline rounded_rim(double land, unsigned int n_land, double crown)
{
  constexpr double arc = 1.1e-3, step = 2e-4; // half-width of the arc, spacing of points on the flanks [m]
  const auto height = [=](double offset)
  {
    const double x = std::min(std::abs(offset), arc), lift = std::sqrt(crown * crown - x * x);
    return crown - lift + (std::abs(offset) - x) * arc / lift;
  };
  Polyline polyline = { { 0, 0.303, 1 } };
  const auto add = [&](double offset)
  {
    polyline.push_back(
      { 0.030012 + offset, 0.3 + height(offset), static_cast<unsigned int>(polyline.size() + 1) });
  };
  for (double offset = -land / 2 - 12 * step; offset < -land / 2; offset += step)
    add(offset);
  for (unsigned int i = 0; i < n_land; ++i)
    add(land * ((i + 0.5) / n_land - 0.5));
  for (double offset = land / 2 + 0.3 * step; offset < land / 2 + 8 * step; offset += step)
    add(offset);
  return polyline;
}

Polyline scattered(Polyline polyline, double radial, double vertical, unsigned int seed)
{
  std::mt19937 generator(seed);
  std::normal_distribution<double> error;
  for (std::size_t i = 1; i < polyline.size(); ++i)
  {
    polyline[i].radius += radial * error(generator);
    polyline[i].height += vertical * error(generator);
  }
  return polyline;
}

Polyline arc_of_six_points()
{
  Polyline polyline = { { 0, 0.503, 1 } };
  for (const double angle : { -0.5, -0.2, -0.05, 0.1, 0.3, 0.5 })
    polyline.push_back({ 0.03123 + 0.0021 * std::sin(angle), 0.5 + 0.0021 * (1 - std::cos(angle)), 2 });
  polyline.push_back({ 0.036, 0.502, 3 });
  return polyline;
}

TEST(RimCircle, FitsTheCircleThroughThePointsInEitherOrder)
{
  Polyline polyline = arc_of_six_points();
  for (unsigned int direction = 0; direction < 2; ++direction)
  {
    const auto circle = fit_rim_circle(polyline, 0.004);
    ASSERT_TRUE(circle);
    EXPECT_NEAR(circle->contact_radius, 0.03123, 1e-12);
    EXPECT_NEAR(circle->crown_radius, 0.0021, 1e-12);
    EXPECT_EQ(circle->n_points, 6u);
    EXPECT_LT(circle->rms_distance, 1e-14);
    std::reverse(polyline.begin(), polyline.end());
  }
}

TEST(RimCircle, IsNotFittedToFlatOrTooFewPoints)
{
  EXPECT_FALSE(fit_rim_circle({}, 0.004));
  EXPECT_FALSE(
    fit_rim_circle({ { 0, 0.002 }, { 0.028, 0 }, { 0.029, 0 }, { 0.030, 0 }, { 0.036, 0.001 } }, 0.004));
  EXPECT_FALSE(fit_rim_circle({ { 0, 0.002 }, { 0.028, 0 }, { 0.029, 0.0001 }, { 0.036, 0.001 } }, 0.004));
}

/// A thin foot has points of its top just above the rim.
TEST(RimCircle, UsesTheUndersideOnly)
{
  Polyline polyline = arc_of_six_points();
  for (const double radius : { 0.034, 0.032, 0.031, 0.030, 0.005 })
    polyline.push_back({ radius, 0.5015, 4 });
  const auto circle = fit_rim_circle(polyline, 0.004);
  ASSERT_TRUE(circle);
  EXPECT_EQ(circle->n_points, 6u);
  EXPECT_NEAR(circle->crown_radius, 0.0021, 1e-12);
}

/// The arc equals a parabola to a relative error of 2e-4. The errors e = (1, -4, 6, -4, 1) u at five
/// equidistant points are orthogonal to every parabola and do not change the fit. Their sum of squares is 70
/// u^2.
TEST(RimCircle, ReportsTheRmsDistanceOfItsPoints)
{
  constexpr double crown = 0.1, u = 1e-7, mm = 1e-3;
  const double errors[] = { 1, -4, 6, -4, 1 };
  Polyline polyline = { { 0, 0.01, 1 } };
  for (int i = -2; i <= 2; ++i)
    polyline.push_back(
      { 0.03 + i * mm, crown - std::sqrt(crown * crown - i * i * mm * mm) + errors[i + 2] * u, 2 });
  polyline.push_back({ 0.04, 0.01, 3 });
  const auto circle = fit_rim_circle(polyline, 6 * mm);
  ASSERT_TRUE(circle);
  EXPECT_NEAR(circle->contact_radius, 0.03, 1e-8);
  EXPECT_NEAR(circle->crown_radius, crown, 1e-4 * crown);
  EXPECT_EQ(circle->n_points, 5u);
  EXPECT_NEAR(circle->rms_distance, u * std::sqrt(70. / 5), 1e-3 * circle->rms_distance);
}

/// The scatter of the heights grows from 20 to 40 um in steps of 0.1 um. Points must enter and leave the fit
/// continuously, even if another point becomes the lowest.
TEST(RimCircle, DependsContinuouslyOnItsPoints)
{
  const Polyline rim = rounded_rim(1.7e-3, 10, 3e-3);
  double largest = 0;
  for (unsigned int seed = 0; seed < 5; ++seed)
  {
    const Polyline errors = scattered(rim, 0, 1, seed);
    double before = 0;
    for (unsigned int i = 0; i <= 200; ++i)
    {
      Polyline polyline = rim;
      for (std::size_t j = 1; j < rim.size(); ++j)
        polyline[j].height += (20e-6 + 0.1e-6 * i) * (errors[j].height - rim[j].height);
      const auto circle = fit_rim_circle(polyline, 1.7e-3);
      ASSERT_TRUE(circle) << i;
      if (i > 0)
        largest = std::max(largest, std::abs(circle->contact_radius - before));
      before = circle->contact_radius;
    }
  }
  // A jump of a single point into the fit would change the contact radius by at least 20 um.
  EXPECT_LT(largest, 2e-6);
}

TEST(RimCircle, DuplicatePointsDoNotChangeTheFit)
{
  const Polyline rim = scattered(rounded_rim(1.7e-3, 10, 3e-3), 0, 20e-6, 3);
  Polyline doubled;
  for (std::size_t i = 0; i < rim.size(); ++i)
    doubled.insert(doubled.end(), i % 2 == 0 ? 1 : 2, rim[i]);
  const auto once = fit_rim_circle(rim, 1.7e-3), twice = fit_rim_circle(doubled, 1.7e-3);
  ASSERT_TRUE(once && twice);
  EXPECT_EQ(twice->contact_radius, once->contact_radius);
  EXPECT_EQ(twice->crown_radius, once->crown_radius);
  EXPECT_EQ(twice->n_points, once->n_points);
}

} // namespace
} // namespace stemware::fem
