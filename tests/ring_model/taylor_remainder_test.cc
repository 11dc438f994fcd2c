// The check of derivatives itself, on functions with known remainders.
#include "tests/taylor_remainder.h"

namespace stemware::taylor
{
namespace
{

TEST(TaylorRemainder, FallsLikeTheSquareOfTheStepForADerivative)
{
  const auto sine = [](double h) { return std::sin(0.7 + h); };
  EXPECT_NEAR(slope_of_remainder(sine, std::cos(0.7), 0.1, 1e-16), 2, 0.02);
  EXPECT_TRUE(is_derivative(sine, std::cos(0.7), 0.1));
  // Inflection: the remainder is cubic.
  EXPECT_NEAR(slope_of_remainder([](double h) { return std::sin(h); }, 1., 0.5, 1e-16), 3, 0.02);
  // A kink in the slope: max(0, x)^2 / 2 at its foot.
  EXPECT_TRUE(is_derivative([](double h) { return std::pow(std::max(0., h), 2) / 2; }, 0., 0.1));
}

TEST(TaylorRemainder, FallsLikeTheStepForAnythingElse)
{
  const auto sine = [](double h) { return std::sin(0.7 + h); };
  for (const double error : { -2., -1., 0.1, 0.01, 1e-3 })
    EXPECT_FALSE(is_derivative(sine, std::cos(0.7) * (1 + error), 0.1)) << error;
  EXPECT_FALSE(is_derivative([](double h) { return std::abs(h); }, 0., 0.1));
  EXPECT_FALSE(is_derivative([](double h) { return std::sqrt(h); }, 0., 0.1)); // NaN nowhere, slope 1/2
  EXPECT_FALSE(is_derivative([](double) { return std::nan(""); }, 0., 0.1));
}

TEST(TaylorRemainder, OfALinearFunctionIsRounding)
{
  const auto line = [](double h) -> Eigen::VectorXd { return Eigen::Vector2d(3 + 2 * h, 1 - h); };
  EXPECT_TRUE(is_derivative(line, Eigen::VectorXd(Eigen::Vector2d(2, -1)), 0.1));
  EXPECT_FALSE(is_derivative(line, Eigen::VectorXd(Eigen::Vector2d(2, -1.001)), 0.1));
}

} // namespace
} // namespace stemware::taylor
