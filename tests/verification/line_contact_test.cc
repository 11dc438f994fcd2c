// A rigid crowned ring pressed into a thick elastic disc by a hard interface, against line contact on a
// half-space whose width follows the load: the leading order in width / radius, with and without lift-off.
// Kind of the reference: closed form, solved here on the same azimuth lines.
#include "fem/contact/hard_interface.h"
#include "fem/revolution/compliance_cache.h"
#include "fem/revolution/revolution_foot.h"
#include "tests/fem/reference_load.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace stemware::fem_tests;

namespace
{

/// Half-width of the contact over the ring's radius, at the mean load.
constexpr double slenderness = 0.01;
constexpr unsigned int n_harmonics = 16;

/// x = q / mean q on the azimuth lines with x (L - ln x) + S[x] = w_0 + w_1 cos(theta) where x > 0, S cos(n
/// theta) = -4 sum_{k <= n} 1/(2k - 1) cos(n theta), L = 2 ln(16 R/b_0) + 1: the displacement of an elastic
/// half-space under a Hertz line load of half-width b_0 sqrt(x). As in the program, all harmonics beyond the
/// highest have one S, that of MeridianOptions::beyond(). Newton's method on the lines that carry load.
class LineContact
{
public:
  LineContact(double moment_ratio, unsigned int n_lines)
      : n_lines(n_lines)
      , self_influence(2 * std::log(16 / slenderness) + 1)
      , influence(n_lines, n_lines)
      , load(n_lines)
  {
    for (unsigned int i = 0; i < n_lines; ++i)
    {
      load(i) = std::max(1 + moment_ratio * std::cos(azimuth(i)), 0.02);
      for (unsigned int j = 0; j < n_lines; ++j)
        influence(i, j) = influence_at(azimuth(i) - azimuth(j));
    }
    solve(moment_ratio);
  }

  /// a_n / a_0.
  double harmonic(unsigned int n) const
  {
    double sum = 0;
    for (unsigned int i = 0; i < n_lines; ++i)
      sum += 2 * load(i) * std::cos(n * azimuth(i)) / n_lines;
    return sum;
  }

  double loaded_share() const { return static_cast<double>((load.array() > 0).count()) / n_lines; }

private:
  double azimuth(unsigned int line) const { return 2 * M_PI * line / n_lines; }

  /// S of one harmonic.
  static double eigenvalue(unsigned int n)
  {
    double sum = 0;
    for (unsigned int k = 1; k <= n; ++k)
      sum += 1 / (2. * k - 1);
    return -4 * sum;
  }

  /// S for a unit load on the line at @p angle = 0.
  double influence_at(double angle) const
  {
    const double beyond = eigenvalue(MeridianOptions{ 2, n_harmonics }.beyond());
    double value = angle == 0 ? beyond : 0;
    for (unsigned int n = 0; n <= n_harmonics; ++n)
      value += (n == 0 ? 1 : 2) * (eigenvalue(n) - beyond) * std::cos(n * angle) / n_lines;
    return value;
  }

  void solve(double moment_ratio)
  {
    Eigen::Vector2d motion(self_influence, 0);
    for (unsigned int step = 0; step < 50; ++step)
    {
      std::vector<int> lines;
      for (unsigned int i = 0; i < n_lines; ++i)
        if (load(i) > 0)
          lines.push_back(static_cast<int>(i));
      const Eigen::Index n = static_cast<Eigen::Index>(lines.size());
      const Eigen::VectorXd x = load(lines);
      Eigen::MatrixX2d motions(n, 2);
      for (Eigen::Index i = 0; i < n; ++i)
        motions.row(i) << 1, std::cos(azimuth(static_cast<unsigned int>(lines[static_cast<std::size_t>(i)])));
      Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n + 2, n + 2);
      matrix.topLeftCorner(n, n) = influence(lines, lines);
      matrix.diagonal().head(n).array() += self_influence - x.array().log() - 1;
      matrix.topRightCorner(n, 2) = -motions;
      matrix.bottomLeftCorner(2, n) = motions.transpose() / n_lines;
      Eigen::VectorXd condition_residual(n + 2);
      condition_residual << influence(lines, lines) * x +
                              x.cwiseProduct(Eigen::VectorXd(self_influence - x.array().log())) -
                              motions * motion,
        motions.transpose() * x / n_lines - Eigen::Vector2d(1, moment_ratio / 2);
      const Eigen::VectorXd correction = -matrix.partialPivLu().solve(condition_residual);
      load(lines) = (x + correction.head(n)).cwiseMax(0.);
      motion += correction.tail<2>();
    }
  }

  const unsigned int n_lines;
  const double self_influence; ///< L
  Eigen::MatrixXd influence;
  Eigen::VectorXd load;
};

/// A rigid ring whose rounding makes the Hertz contact on a disc of ten times its radius slenderness * radius
/// wide.
LoadHarmonics press_ring(double moment_ratio, unsigned int n_lines)
{
  Substrate substrate;
  substrate.disc.radius = substrate.disc.thickness = 0.3;
  const double modulus =
    substrate.material.young_modulus / (1 - std::pow(substrate.material.poisson_ratio, 2));
  RevolutionSetup setup;
  setup.foot_is_rigid = true;
  const double half_width = slenderness * setup.profile.contact_radius;
  const double line_load = weight / (2 * M_PI * setup.profile.contact_radius);
  setup.profile.crown_radius = half_width * half_width * M_PI * modulus / (4 * line_load);
  setup.table = { std::make_shared<HardInterface>(), substrate };
  setup.meridian.n_harmonics = n_harmonics;
  setup.n_lines = n_lines;
  setup.fineness = 4; // cells of b / 16: a_2 is 0.7 % of a_0, and cells of b / 4 leave 2e-4 a_0 of noise
  static ComplianceCache cache; // the same bodies in every test
  RevolutionFoot foot(setup.resolved_for(weight), cache);
  return foot.solve(load_at(moment_ratio)).load;
}

} // namespace

TEST(LineContact, OracleReproducesTheTable)
{
  // Values for L = 15.7555, here 15.75552; the weakly nonlinear a_2 is m^2 / (4 (L - 19/3)) = 0.0066.
  const LineContact contact(0.5, 33);
  EXPECT_NEAR(contact.harmonic(2), .006875214728468, 2e-7);
  EXPECT_NEAR(contact.harmonic(3), -4.504165011245e-4, 2e-8);
  EXPECT_NEAR(contact.harmonic(4), 5.06792626489e-5, 5e-9);
}

TEST(LineContact, CrownedRingCarriesAllRound)
{
  const LineContact expected(0.5, 64);
  const LoadHarmonics load = press_ring(0.5, 64);
  EXPECT_EQ(load.contact_fraction, 1);
  // 0.0069 to a hundredth, the ratio of width and radius; the others to the noise of the edges that pass from
  // cell to cell.
  EXPECT_NEAR(load.a[0][2] / load.a[0][0], expected.harmonic(2), 6e-5);
  for (unsigned int n = 3; n <= 6; ++n)
    EXPECT_NEAR(load.a[0][n] / load.a[0][0], expected.harmonic(n), 1.5e-5) << "n = " << n;
}

TEST(LineContact, CrownedRingLiftsOff)
{
  const LineContact expected(1.3, 64);
  const LoadHarmonics load = press_ring(1.3, 64);
  EXPECT_EQ(load.contact_fraction, expected.loaded_share());
  EXPECT_EQ(load.contact_fraction, 45. / 64);
  // 0.2099, -0.0924, 0.0278, 0.0085, -0.0189: to half a hundredth of the largest.
  for (unsigned int n = 2; n <= 6; ++n)
    EXPECT_NEAR(load.a[0][n] / load.a[0][0], expected.harmonic(n), 1e-3) << "n = " << n;
}

TEST(LineContact, LinesBeyondTheHarmonicsChangeNothingWithoutLiftOff)
{
  const LoadHarmonics few = press_ring(0.5, 2 * n_harmonics + 1);
  const LoadHarmonics many = press_ring(0.5, 8 * n_harmonics);
  for (unsigned int n = 2; n <= 8; ++n)
    EXPECT_NEAR(few.a[0][n] / few.a[0][0], many.a[0][n] / many.a[0][0], 1.5e-5) << "n = " << n;
}

/// Published: NAFEMS R0094, contact benchmark 1. A steel cylinder of radius 50 mm on aluminium under 35 kN/mm
/// touches on a half-width of 6.21 mm with 3585.37 MPa.
TEST(LineContact, HalfWidthOfTheMeshIsHertzs)
{
  RevolutionSetup setup;
  setup.profile.crown_radius = 0.05;
  setup.material = { 210e9, 0.3 };
  setup.table = { std::make_shared<HardInterface>(), Substrate{ {}, { 70e9, 0.3 } } };
  const double line_load = 35e6;
  const double half_width = hertz_half_width(setup, line_load * 2 * M_PI * setup.profile.contact_radius);
  EXPECT_NEAR(half_width, 6.21e-3, 5e-6);
  EXPECT_NEAR(2 * line_load / (M_PI * half_width) / 3585.37e6, 1, 1e-5);
}
