// The circle through the points of a rim, against circles that points were drawn from: by themselves, and
// with a known scatter, where the standard errors have to hold the truth as often as such errors do.
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

/// The underside of a foot [m]: an arc of @p crown about r = 30.012 mm, beside which it rises straight. @p
/// n_land points lie on the land of that width, others to both sides of it.
Polyline rounded_rim(double land, unsigned int n_land, double crown)
{
  constexpr double arc = 1.1e-3, step = 2e-4; // half of the arc's width, distance of the points beside it
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

/// The points with Gaussian errors of @p radial and @p vertical [m], other ones for each @p seed.
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

/// A circle and its points, exactly.
Polyline arc_of_six_points()
{
  Polyline polyline = { { 0, 0.503, 1 } };
  for (const double angle : { -0.5, -0.2, -0.05, 0.1, 0.3, 0.5 })
    polyline.push_back({ 0.03123 + 0.0021 * std::sin(angle), 0.5 + 0.0021 * (1 - std::cos(angle)), 2 });
  polyline.push_back({ 0.036, 0.502, 3 });
  return polyline;
}

TEST(RimCircle, IsTheOneThroughItsPoints)
{
  Polyline polyline = arc_of_six_points();
  for (unsigned int direction = 0; direction < 2; ++direction)
  {
    const auto circle = fit_rim_circle(polyline, 0.004);
    ASSERT_TRUE(circle);
    EXPECT_NEAR(circle->contact_radius, 0.03123, 1e-12);
    EXPECT_NEAR(circle->crown_radius, 0.0021, 1e-12);
    EXPECT_EQ(circle->points.size(), 6u);
    EXPECT_EQ(circle->n_repeated, 0u);
    EXPECT_FALSE(circle->has_scatter()); // it is rounding
    std::reverse(polyline.begin(), polyline.end());
  }
}

TEST(RimCircle, IsNotFittedToWhatIsFlatOrTooLittle)
{
  EXPECT_FALSE(fit_rim_circle({}, 0.004));
  EXPECT_FALSE(
    fit_rim_circle({ { 0, 0.002 }, { 0.028, 0 }, { 0.029, 0 }, { 0.030, 0 }, { 0.036, 0.001 } }, 0.004));
  EXPECT_FALSE(fit_rim_circle({ { 0, 0.002 }, { 0.028, 0 }, { 0.029, 0.0001 }, { 0.036, 0.001 } }, 0.004));
}

/// The top of a thin foot above its rim is no part of the land.
TEST(RimCircle, LooksAtTheUndersideOnly)
{
  Polyline polyline = arc_of_six_points();
  for (const double radius : { 0.034, 0.032, 0.031, 0.030, 0.005 })
    polyline.push_back({ radius, 0.5015, 4 });
  const auto circle = fit_rim_circle(polyline, 0.004);
  ASSERT_TRUE(circle);
  EXPECT_EQ(circle->points.size(), 6u);
  EXPECT_NEAR(circle->crown_radius, 0.0021, 1e-12);
}

/// An arc so shallow that it is a parabola to 2e-4: five points at -2 ... 2 mm with errors e = (1, -4, 6, -4,
/// 1) u have the same fit as without, sum e^2 = 70 u^2, and two degrees of freedom. All of them count fully,
/// and the covariance is the textbook's: of the slope at the middle s^2 / 10 mm^2, of half the curvature s^2
/// / 14 mm^4.
TEST(RimCircle, StandardErrorsAreThoseOfLeastSquares)
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
  EXPECT_NEAR(circle->freedom, 2, 1e-9);
  const double scatter = u * std::sqrt(70. / 2);
  EXPECT_NEAR(circle->scatter, scatter, 1e-3 * scatter);
  constexpr double student = 1.3213; // 84.13 % of t with 2 degrees of freedom
  EXPECT_NEAR(circle->contact_radius_error(), student * crown * scatter / (std::sqrt(10) * mm),
              1e-3 * circle->contact_radius_error());
  EXPECT_NEAR(circle->crown_radius_error(), student * crown * crown * 2 * scatter / (std::sqrt(14) * mm * mm),
              1e-3 * circle->crown_radius_error());
  ASSERT_EQ(circle->points.size(), 5u);
  for (unsigned int i = 0; i < 5; ++i)
    EXPECT_NEAR(circle->points[i].distance, errors[i] * u, 2e-3 * u) << i;
}

/// 500 scatters of the same rim. Of a normal error 68.3 % lie within one standard error and 95.4 % within
/// two; 500 draws of these shares have standard deviations of 2.1 % and 0.9 %.
TEST(RimCircle, ErrorsHoldTheTruthAsOftenAsTheySay)
{
  struct Scan
  {
    double land;
    unsigned int n_land;
    double radial, vertical; // errors [m]
  };
  constexpr unsigned int n_seeds = 500;
  constexpr double crown = 3e-3;
  for (const Scan &scan : { Scan{ 1.7e-3, 10, 0, 20e-6 }, Scan{ 1.7e-3, 10, 8e-6, 8e-6 },
                            Scan{ 2e-3, 14, 20e-6, 20e-6 }, Scan{ 1.7e-3, 60, 20e-6, 20e-6 } })
  {
    const Polyline rim = rounded_rim(scan.land, scan.n_land, crown);
    double radius_within[2] = {}, crown_within[2] = {};
    for (unsigned int seed = 0; seed < n_seeds; ++seed)
    {
      const auto circle = fit_rim_circle(scattered(rim, scan.radial, scan.vertical, seed), scan.land);
      ASSERT_TRUE(circle) << seed;
      ASSERT_TRUE(circle->has_scatter()) << seed;
      for (const int errors : { 1, 2 })
      {
        radius_within[errors - 1] +=
          std::abs(circle->contact_radius - 0.030012) < errors * circle->contact_radius_error();
        crown_within[errors - 1] +=
          std::abs(circle->crown_radius - crown) < errors * circle->crown_radius_error();
      }
    }
    for (const auto &within : { radius_within, crown_within })
    {
      const std::string which = (within == radius_within ? "contact radius" : "crown radius") +
                                std::string(" of ") + std::to_string(scan.n_land) + " points";
      EXPECT_GE(within[0] / n_seeds, 0.60) << which;
      EXPECT_LE(within[0] / n_seeds, 0.76) << which;
      EXPECT_GE(within[1] / n_seeds, 0.90) << which;
      EXPECT_LE(within[1] / n_seeds, 0.98) << which;
    }
  }
}

/// A scatter that grows by 0.1 um from scan to scan, from 20 to 40 um, moves the contact radius little each
/// time: no point enters or leaves by a jump, although another one becomes the lowest.
TEST(RimCircle, FollowsItsPointsWithoutJumps)
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
  // A point at the land's border that comes in by a jump moves it by 20 um and more.
  EXPECT_LT(largest, 2e-6);
}

TEST(RimCircle, PointsThatStandTwiceCountOnce)
{
  const Polyline rim = scattered(rounded_rim(1.7e-3, 10, 3e-3), 0, 20e-6, 3);
  Polyline doubled;
  for (std::size_t i = 0; i < rim.size(); ++i)
    doubled.insert(doubled.end(), i % 2 == 0 ? 1 : 2, rim[i]);
  const auto once = fit_rim_circle(rim, 1.7e-3), twice = fit_rim_circle(doubled, 1.7e-3);
  ASSERT_TRUE(once && twice);
  EXPECT_EQ(twice->contact_radius, once->contact_radius);
  EXPECT_EQ(twice->crown_radius, once->crown_radius);
  EXPECT_EQ(twice->covariance, once->covariance);
  EXPECT_EQ(twice->points.size(), once->points.size());
  EXPECT_EQ(once->n_repeated, 0u);
  EXPECT_NEAR(static_cast<double>(twice->n_repeated), static_cast<double>(once->points.size()) / 2, 1);
}

/// Three points are on their circle whatever their errors.
TEST(RimCircle, ThreePointsSayNothingAboutTheirScatter)
{
  const auto circle =
    fit_rim_circle({ { 0, 0.01 }, { 0.0295, 5e-5 }, { 0.030, 0 }, { 0.0305, 3e-5 }, { 0.04, 0.01 } }, 0.002);
  ASSERT_TRUE(circle);
  EXPECT_EQ(circle->points.size(), 3u);
  EXPECT_EQ(circle->freedom, 0);
  EXPECT_FALSE(circle->has_scatter());
}

} // namespace
} // namespace stemware::fem
