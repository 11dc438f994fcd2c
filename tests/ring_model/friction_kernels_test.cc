#include "ring_model/friction_kernels.h"
#include "ring_model/load/constants.h"
#include "tests/ring_model/reference.h"
#include "tests/taylor_remainder.h"

#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/multiprecision/cpp_dec_float.hpp>

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace stemware::ring
{
namespace
{
using Real =
  boost::multiprecision::number<boost::multiprecision::cpp_dec_float<50>, boost::multiprecision::et_off>;

/// Computes P_n and K_n for n <= 64 from their integrals with 50 digits. The panels are halved towards the
/// angle of least slip (psi = 0 or pi) until they are shorter than | |eps| - 1 |, about the distance of the
/// integrand's complex singularity from this angle.
class QuadratureOracle
{
public:
  explicit QuadratureOracle(double slip_ratio)
  {
    const Real eps(slip_ratio), pi = boost::math::constants::pi<Real>();
    const bool at_pi = slip_ratio < 0.; // the slip is smallest at psi = pi for eps < 0
    const double distance = std::abs(std::abs(slip_ratio) - 1.);
    std::vector<Real> edges;
    for (int i = 16; i >= 1; --i)
      edges.push_back(pi * i / 16);
    while (distance > 0. && edges.back() > distance)
      edges.push_back(edges.back() / 2);
    edges.push_back(Real(0));

    using Rule = boost::math::quadrature::gauss<Real, 30>;
    for (std::size_t panel = 0; panel + 1 < edges.size(); ++panel)
    {
      const Real middle = (edges[panel] + edges[panel + 1]) / 2, half = (edges[panel] - edges[panel + 1]) / 2;
      for (std::size_t i = 0; i < Rule::abscissa().size(); ++i)
        for (const int sign : { -1, 1 })
        {
          const Real from_least = middle + sign * half * Rule::abscissa()[i];
          add_point(eps, at_pi ? Real(pi - from_least) : from_least, 2 * half * Rule::weights()[i]);
        }
    }
  }

  Real P[65];
  Real K[65];

private:
  void add_point(const Real &eps, const Real &psi, const Real &weight)
  {
    const Real c = cos(psi), s = sin(psi / 2);
    const Real slip = sqrt((1 - eps) * (1 - eps) + 4 * eps * s * s), pull = (c - eps) / slip;
    Real cosine = 1, below = c;
    for (unsigned int n = 0; n <= 64; ++n)
    {
      P[n] += weight * slip * cosine;
      K[n] += weight * pull * cosine;
      const Real above = 2 * c * cosine - below;
      below = cosine;
      cosine = above;
    }
  }
};

TEST(FrictionKernels, AgreeWithReferenceCases)
{
  for (const auto &row : reference()["kernels"])
  {
    const double eps = row["eps"];
    const auto kernels = FrictionKernels(eps, 1., 12);
    const double tolerance = 1e-14 * std::max(1., row["P"][0].get<double>());
    for (unsigned int n = 0; n <= 12; ++n)
    {
      EXPECT_NEAR(kernels.P(n), row["P"][n].get<double>(), tolerance) << "eps " << eps << ", n " << n;
      EXPECT_NEAR(kernels.K(n), row["K"][n].get<double>(), tolerance) << "eps " << eps << ", n " << n;
      EXPECT_NEAR(kernels.U(n), row["U"][n].get<double>(), tolerance) << "eps " << eps << ", n " << n;
    }
  }
}

TEST(FrictionKernels, AgreeWithFiftyDigitQuadrature)
{
  // U_n (for |eps| <= 1) and K_n (for |eps| > 1) change sign near |eps| = 1, where their relative error is
  // unbounded. Therefore |P_n| is added to the scale of the tolerance.
  const double tolerance = 1.5e-14;
  std::vector<double> slip_ratios{ 0.1, 0.5, 0.75, 0.9, 1., -1., 2., 10., -0.97, -1.02 };
  for (const double distance : { 1e-12, 1e-10, 1e-8, 1e-6, 1e-4, 1e-3, 0.01, 0.018, 0.02, 0.04, 0.08 })
  {
    slip_ratios.push_back(1. - distance);
    slip_ratios.push_back(1. + distance);
  }
  slip_ratios.push_back(-1. + 1e-12);
  slip_ratios.push_back(-1. - 1e-12);
  double worst = 0.;
  for (const double eps : slip_ratios)
  {
    const QuadratureOracle exact(eps);
    const auto kernels = FrictionKernels(eps, 1., 64);
    for (unsigned int n = 0; n <= 64; ++n)
    {
      const Real U = exact.P[n] + eps * exact.K[n];
      const double scale = std::abs(static_cast<double>(exact.P[n]));
      const double near_one = n >= 2 && std::abs(std::abs(eps) - 1.) < 0.3 ? scale : 0.;
      const auto check = [&](const char *name, double value, const Real &expected, double extra)
      {
        const double size = std::abs(static_cast<double>(expected)) + extra;
        const double error = std::abs(static_cast<double>(value - expected));
        // The absolute error of the 50-digit integrals is 1e-40.
        EXPECT_LE(error, tolerance * size + 1e-40)
          << name << n << "(" << ::testing::PrintToString(eps) << ")";
        if (size > 1e-20)
          worst = std::max(worst, error / size);
      };
      check("P_", kernels.P(n), exact.P[n], 0.);
      check("K_", kernels.K(n), exact.K[n], std::abs(eps) > 1. ? near_one : 0.);
      check("U_", kernels.U(n), U, std::abs(eps) <= 1. ? near_one : 0.);
    }
  }
  std::cout << "largest relative error " << worst << " over " << slip_ratios.size()
            << " slip ratios, n <= 64\n";
  RecordProperty("largest_relative_error", std::to_string(worst));
}

TEST(FrictionKernels, AgreeWithTheirLimitsAtSmallAndZeroSlipRatios)
{
  // Limits for eps -> 0: K_n -> kappa_n eps^{n-1}, P_n -> -kappa_n eps^n / n, U_n -> (n-1)/n kappa_n eps^n.
  // The next terms are smaller by eps^2.
  const auto &kappa = reference()["kernel_small_eps"]["kappa"];
  const double eps = 1e-8;
  const auto kernels = FrictionKernels(eps, 1., 12);
  expect_relative(kernels.K(0), -pi * eps, 1e-15, "K_0");
  expect_relative(kernels.U(0), 2. * pi, 1e-15, "U_0");
  expect_relative(kernels.U(1), -pi / 4. * eps * eps * eps, 1e-14, "U_1");
  for (unsigned int n = 1; n <= 12; ++n)
  {
    const double k = kappa[n - 1], power = std::pow(eps, n - 1);
    expect_relative(kernels.K(n), k * power, 1e-14, "K_" + std::to_string(n));
    expect_relative(kernels.P(n), -k / n * power * eps, 1e-14, "P_" + std::to_string(n));
    if (n >= 2)
      expect_relative(kernels.U(n), (n - 1.) / n * k * power * eps, 1e-14, "U_" + std::to_string(n));
  }
  const auto rest = FrictionKernels(0., 1., 128);
  EXPECT_DOUBLE_EQ(rest.P(0), 2. * pi);
  EXPECT_DOUBLE_EQ(rest.K(1), pi);
  for (unsigned int n = 2; n <= 128; ++n)
    EXPECT_TRUE(rest.P(n) == 0. && rest.K(n) == 0. && rest.U(n) == 0.) << n;
}

TEST(FrictionKernels, SatisfyParityDualityAndRecurrenceAtRandomSlipRatios)
{
  test::Numbers numbers(20260101);
  for (unsigned int trial = 0; trial < 400; ++trial)
  {
    const double eps = std::exp(numbers.between(-4., 4.));
    const auto plus = FrictionKernels(eps, 1., 40), minus = FrictionKernels(-eps, 1., 40),
               dual = FrictionKernels(1. / eps, 1., 40);
    for (unsigned int n = 0; n <= 40; ++n)
    {
      const double sign = n % 2 == 0 ? 1. : -1., scale = 1e-14 * std::max(1., eps);
      EXPECT_EQ(minus.P(n), sign * plus.P(n));
      EXPECT_EQ(minus.K(n), -sign * plus.K(n));
      EXPECT_EQ(minus.U(n), sign * plus.U(n));
      EXPECT_NEAR(plus.P(n), eps * dual.P(n), scale);
      EXPECT_NEAR(plus.K(n), -dual.U(n), 1e-14);
      // Identities: U_n = P_n + eps K_n, and (2n+3) P_{n+1} = 2n (eps + 1/eps) P_n - (2n-3) P_{n-1}.
      EXPECT_NEAR(plus.U(n), plus.P(n) + eps * plus.K(n), 4. * scale);
      if (n >= 1 && n < 40)
      {
        EXPECT_NEAR((2. * n + 3.) * eps * plus.P(n + 1),
                    2. * n * (eps * eps + 1.) * plus.P(n) - (2. * n - 3.) * eps * plus.P(n - 1),
                    1e-13 * n * eps * std::max(1., eps * eps))
          << "eps " << eps << ", n " << n;
      }
    }
  }
}

TEST(FrictionKernels, KIsMinusTheDerivativeOfP)
{
  const auto values = [](double eps, auto kernel)
  {
    const auto kernels = FrictionKernels(eps, 1., 12);
    Eigen::VectorXd all(13);
    for (unsigned int n = 0; n <= 12; ++n)
      all(n) = kernel(kernels, n);
    return all;
  };
  const auto P = [](const FrictionKernels &kernels, unsigned int n) { return kernels.P(n); };
  const auto minus_K = [](const FrictionKernels &kernels, unsigned int n) { return -kernels.K(n); };
  for (const double eps : { -3., -0.6, 0., 0.05, 0.27, 0.5, 0.9, 1.1, 2., 8. })
    EXPECT_TRUE(
      taylor::is_derivative([&](double h) { return values(eps + h, P); }, values(eps, minus_K), 0.05))
      << eps;
}

TEST(FrictionKernels, AreIndependentOfTheNumberOfHarmonics)
{
  for (const double eps : { 1e-3, 0.4, 0.69, 0.72, 0.95, 0.985, 0.999, 1.004, 3. })
  {
    const auto all = FrictionKernels(eps, 1., 256);
    for (const unsigned int n_max : { 0u, 1u, 2u, 5u, 33u, 100u })
    {
      const auto some = FrictionKernels(eps, 1., n_max);
      for (unsigned int n = 0; n <= n_max; ++n)
      {
        EXPECT_NEAR(some.P(n), all.P(n), 2e-14 * std::abs(all.P(n))) << eps << " " << n_max << " " << n;
        EXPECT_NEAR(some.K(n), all.K(n),
                    2e-14 * (std::abs(all.K(n)) + std::abs(all.P(n)) / std::max(1., eps)));
        EXPECT_NEAR(some.U(n), all.U(n),
                    2e-14 * (std::abs(all.U(n)) + std::abs(all.P(n)) * (n == 1 ? 0. : 1.)));
      }
    }
  }
}

TEST(FrictionKernels, RefuseZeroAndInvalidVelocities)
{
  EXPECT_THROW(FrictionKernels(0., 0., 3), std::invalid_argument);
  EXPECT_THROW(FrictionKernels(1., -1., 3), std::invalid_argument);
  EXPECT_THROW(FrictionKernels(std::numeric_limits<double>::quiet_NaN(), 1., 3), std::invalid_argument);
  EXPECT_THROW(FrictionKernels(1., std::numeric_limits<double>::infinity(), 3), std::invalid_argument);
}
} // namespace
} // namespace stemware::ring
