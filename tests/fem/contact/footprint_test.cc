#include "fem/contact/footprint.h"
#include "fem/contact/stiff_spring.h"
#include "ring_model/load/constants.h"
#include "tests/ulps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace stemware::fem
{
namespace
{

const double full_turn = 2 * ring::pi;

/// Returns 72 radial cuts of 33 points each, up to @p reach [m] on both sides of r = 30 mm. @p pressure is a
/// function of azimuth and r - 30 mm.
PressureMap map_of(double reach, const std::function<double(double, double)> &pressure)
{
  PressureMap footprint;
  footprint.is_grid = true;
  for (unsigned int c = 0; c < 72; ++c)
  {
    const double azimuth = full_turn * c / 72;
    footprint.cuts.emplace_back();
    for (int i = -16; i <= 16; ++i)
    {
      const double x = reach * i / 16;
      footprint.cuts.back().push_back({ 0.03 + x, azimuth, pressure(azimuth, x) });
    }
  }
  return footprint;
}

/// The mean of a parabolic pressure is two thirds of the largest pressure of the cut.
TEST(Footprint, EdgesWidthsAndMeanAgreeWithAParabolicPressure)
{
  const auto half_width = [](double azimuth) { return 1.5e-4 + 0.5e-4 * std::cos(azimuth); };
  const PressureMap footprint = map_of(2.5e-4,
                                       [&](double azimuth, double x)
                                       {
                                         const double share = x / half_width(azimuth);
                                         return 9e4 * std::max(0., 1 - share * share);
                                       });
  const auto cuts = loaded_cuts(footprint);
  ASSERT_EQ(cuts.size(), 73u); // the first cut is repeated after a whole turn
  for (const auto &cut : cuts)
    for (const double radius : { cut.front().radius, cut.back().radius })
      EXPECT_NEAR(std::abs(radius - 0.03), half_width(cut.front().azimuth), 5e-6) << cut.front().azimuth;
  const FootprintMeasures measures = measures_of(footprint);
  EXPECT_EQ(measures.largest.pressure, 9e4);
  EXPECT_EQ(measures.largest.azimuth, 0);
  EXPECT_NEAR(measures.mean, 6e4, 1e3);
  EXPECT_NEAR(measures.widest, 4e-4, 1e-5);
  EXPECT_NEAR(measures.narrowest, 2e-4, 1e-5);
}

/// 99 % of a Gaussian load lie within 2.5758 standard deviations of the middle. The mean pressure on this
/// width is 0.99 sqrt(2 pi) / 5.1517 of the largest pressure.
TEST(Footprint, WidthContainsNinetyNinePercentOfALoadWithoutEdge)
{
  const double deviation = 40e-6;
  for (const double reach : { 3.6, 6. })
  {
    PressureMap footprint = map_of(reach * deviation, [=](double, double x)
                                   { return 9e4 * std::exp(-x * x / deviation / deviation / 2); });
    footprint.has_edge = false;
    const auto width = contact_width(footprint.cuts.front(), false);
    ASSERT_TRUE(width);
    EXPECT_NEAR((width->outer - width->inner) / deviation, 5.1517, 0.1) << reach;
    const ContactWidth band = loaded_band(footprint);
    EXPECT_NEAR(band.inner, width->inner, ulps(160, 0.03));
    EXPECT_NEAR(band.outer, width->outer, ulps(160, 0.03));
    EXPECT_NEAR((loaded_cuts(footprint)[0].back().radius - 0.03) / deviation, 5.1517 / 2, 0.05);
    EXPECT_NEAR(measures_of(footprint).mean, 9e4 * 0.99 * 2.5066 / 5.1517, 1e3);
  }
}

/// On one half of the rim, the outer half of the land is loaded; on the other half, only a single point at
/// the outer edge. In the cut through this point, the loaded width is zero. The mean must not become 0 / 0.
TEST(Footprint, MeanIsFiniteForASingleLoadedPointAndNanWithoutLoad)
{
  PressureMap footprint;
  footprint.is_grid = true;
  for (unsigned int c = 0; c < 36; ++c)
  {
    footprint.cuts.emplace_back();
    for (unsigned int i = 0; i < 33; ++i)
      // With these radii, interpolation rounds to a value outside the interval.
      footprint.cuts.back().push_back({ 0.0292807 + 0.0008256591 * i / 32, full_turn * c / 36,
                                        c < 18 ? (i >= 16 ? 6e4 : 0.) : (c == 30 && i == 32 ? 6e4 : 0.) });
  }
  const FootprintMeasures measures = measures_of(footprint);
  // The loaded width is 16.5 intervals. In the last half interval, the pressure falls linearly to zero.
  EXPECT_NEAR(measures.mean, 6e4 * 16.25 / 16.5, 300);
  EXPECT_EQ(measures.narrowest, 0);
  EXPECT_NEAR(measures.widest, 426e-6, 1e-6);
  const auto cuts = loaded_cuts(footprint);
  for (const PressurePoint &point : cuts[0])
    EXPECT_TRUE(std::isfinite(point.pressure));
  for (const PressurePoint &point : cuts[20])
    EXPECT_TRUE(std::isnan(point.pressure)); // the cut has no load
  for (auto &cut : footprint.cuts)
    for (PressurePoint &point : cut)
      point.pressure = 0;
  EXPECT_TRUE(std::isnan(measures_of(footprint).mean));
}

/// The parameters of p_0 (1 - x^2)^a are computed from the moments of the pressure on a line.
TEST(PressureProfile, RecoversTheParametersOfAGivenPressure)
{
  const double middle = 0.03, half_width = 2e-6, peak = 14e6, azimuth_width = 0.1;
  for (const double exponent : { 0.5, 0.8, 1. })
  {
    ContactSurface surface;
    surface.lines_are_radial = true;
    std::vector<Eigen::Vector3d> depths;
    constexpr int n = 400;
    for (int i = 0; i < n; ++i)
    {
      ContactLine line;
      Eigen::Vector3d depth;
      for (int s = 0; s < 3; ++s)
      {
        const double x = 1.2 * (2. * (i + s / 2.) / n - 1), radius = middle + half_width * x;
        line.position.row(s) << radius, 0;
        line.transverse_tangent.row(s) << 0, azimuth_width * radius;
        depth(s) = 1 - x * x;
      }
      line.azimuth_width = azimuth_width;
      surface.lines.push_back(line);
      depths.push_back(depth);
    }
    const auto profiles = profiles_of_cuts(
      surface, depths, [&](double depth) { return peak * std::pow(std::max(depth, 0.), exponent); });
    ASSERT_EQ(profiles.size(), 1u);
    const PressureProfile &profile = profiles.front();
    EXPECT_NEAR(profile.middle, middle, 1e-5 * half_width);
    EXPECT_NEAR(profile.half_width, half_width, 1e-4 * half_width) << exponent;
    EXPECT_NEAR(profile.exponent, exponent, 1e-3);
    EXPECT_NEAR(profile.peak, peak, 1e-4 * peak) << exponent;
    EXPECT_NEAR(profile.at(middle + 0.6 * half_width), peak * std::pow(0.64, exponent), 1e-3 * peak);
    EXPECT_EQ(profile.at(middle + 1.01 * half_width), 0);
  }
}

/// The edges are extrapolated from the square of the pressure. For a Hertz pressure, the square is a
/// parabola, so the extrapolated edges are exact even between two grid points.
TEST(PressureProfile, MapEndsAtTheContactEdges)
{
  const auto half_width = [](double azimuth) { return 1e-6 * (2 + std::cos(azimuth)); };
  std::vector<PressureProfile> profiles;
  for (unsigned int c = 0; c < 36; ++c)
  {
    const double azimuth = full_turn * c / 36;
    profiles.push_back({ azimuth, 0.03, half_width(azimuth), 0.5, c == 18 ? 0 : 1e6 });
  }
  const PressureMap map = pressure_map_of(profiles);
  EXPECT_TRUE(has_cells(map));
  EXPECT_NEAR(measures_of(map).widest, 6e-6, 1e-12);
  EXPECT_NEAR(measures_of(map).largest.pressure, 1e6, 1e-6);
  for (const auto &cut : map.cuts)
  {
    const auto width = contact_width(cut, true);
    const double azimuth = cut.front().azimuth;
    ASSERT_EQ(width.has_value(), std::cos(azimuth) > -0.999) << azimuth;
    if (width)
    {
      EXPECT_NEAR(width->outer - width->inner, 2 * half_width(azimuth), 1e-6 * half_width(azimuth))
        << azimuth;
    }
  }
}

} // namespace
} // namespace stemware::fem
