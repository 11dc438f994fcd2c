#include "tests/fem/foot_case.h"

#include <gtest/gtest.h>

using namespace stemware::fem;
using namespace stemware::fem_tests;

namespace
{
constexpr double degrees = 3.14159265358979323846 / 180;

/// Harmonics of a foot and a load turned together by @p angle, seen from the turned frame: (a_n, b_n) / a_0
/// of n = 0 ... 8.
std::vector<double> turned_harmonics(double angle)
{
  FootCase foot(flat_profile(), { 24, 4, 1 }, {}, {}, angle);
  const ContactLoad load = foot.solve_on_winkler(1e10, load_at(1.3, angle));
  std::vector<double> result;
  for (unsigned int n = 0; n <= 8; ++n)
  {
    result.push_back((load.a(n) * std::cos(n * angle) + load.b(n) * std::sin(n * angle)) / load.a(0));
    result.push_back((load.b(n) * std::cos(n * angle) - load.a(n) * std::sin(n * angle)) / load.a(0));
  }
  return result;
}

double largest_difference(const std::vector<double> &left, const std::vector<double> &right)
{
  double largest = 0;
  for (unsigned int i = 0; i < left.size(); ++i)
    largest = std::max(largest, std::abs(left[i] - right[i]));
  return largest;
}
} // namespace

TEST(Symmetry, FootAndLoadTurnedTogether)
{
  const std::vector<double> straight = turned_harmonics(0);
  for (const double angle : { 90., 180., 270., 10. })
    EXPECT_LT(largest_difference(straight, turned_harmonics(angle * degrees)), 1e-9) << angle << " degrees";
}

TEST(Symmetry, LoadTurnedOnTheSameMesh)
{
  // The mesh repeats every 90 degrees; in between, only its accuracy keeps the harmonics.
  FootCase foot(flat_profile(), { 24, 4, 1 });
  const ContactLoad straight = foot.solve_on_winkler(1e10, load_at(1.3));
  for (const auto &[angle, tolerance] :
       { std::pair<double, double>{ 90, 1e-9 }, { 180, 1e-9 }, { 10, 1e-3 } })
  {
    const ContactLoad load = foot.solve_on_winkler(1e10, load_at(1.3, angle * degrees));
    for (unsigned int n = 1; n <= 6; ++n)
      EXPECT_NEAR(std::hypot(load.a(n), load.b(n)) / load.a(0), std::abs(straight.a(n)) / straight.a(0),
                  tolerance)
        << angle << " degrees, n = " << n;
  }
}
