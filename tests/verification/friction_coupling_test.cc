// Sliding friction that deforms the foot: published figures, symmetries, and a closed form from the
// compliances.
#include "tests/fem/revolution/revolution_case.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

using namespace stemware::revolution_tests;

namespace
{

LoadHarmonics press_sliding(RevolutionCase &foot, double modulus, double friction, const Resultants &load,
                            double spin = 0)
{
  foot.body.set_sliding(SlidingTraction{ friction, spin });
  return foot.solve_on_winkler(modulus, load);
}

/// int N_i N_j r dr over the land by three-point Gauss quadrature on each quadratic element.
Eigen::MatrixXd mass(const Eigen::VectorXd &radii)
{
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(radii.size(), radii.size());
  const double points[] = { -std::sqrt(0.6), 0, std::sqrt(0.6) };
  const double weights[] = { 5. / 9, 8. / 9, 5. / 9 };
  for (Eigen::Index first = 0; first + 2 < radii.size(); first += 2)
    for (unsigned int q = 0; q < 3; ++q)
    {
      const double x = points[q];
      const double h = radii(first + 2) - radii(first);
      const Eigen::Vector3d shape(x * (x - 1) / 2, 1 - x * x, x * (x + 1) / 2);
      result.block<3, 3>(first, first) +=
        weights[q] * h / 2 * (radii(first + 1) + x * h / 2) * shape * shape.transpose();
    }
  return result;
}

class FrictionCoupling : public testing::Test
{
protected:
  const ContactCompliance compliance = foot_compliance(flat_profile(), equal_cells(1));
  RevolutionCase foot{ flat_profile(), compliance };
};

} // namespace

TEST_F(FrictionCoupling, SecondHarmonicOfTheFlatFoot)
{
  const double expected[] = { 4.0e-4, 3.45e-3, 1.43e-2 };
  const double moduli[] = { 1e9, 1e10, 1e11 };
  for (unsigned int i = 0; i < 3; ++i)
  {
    const LoadHarmonics load = press_sliding(foot, moduli[i], 0.3, load_at(0.4));
    EXPECT_NEAR(load.a[0][2] / load.a[0][0] / expected[i], 1, 0.01) << "k = " << moduli[i];
    EXPECT_NEAR(load.normal_force / weight, 1, 1e-10);
    EXPECT_NEAR(load.moment_y / load_at(0.4).moment_y, 1, 1e-9);
  }
}

TEST_F(FrictionCoupling, IsOddInFrictionAndDirectionAndTurnsIntoASine)
{
  const LoadHarmonics forward = press_sliding(foot, 1e10, 0.3, load_at(0.4));
  const LoadHarmonics negative = press_sliding(foot, 1e10, 0.3, load_at(0.4, M_PI));
  const LoadHarmonics left = press_sliding(foot, 1e10, 0.3, load_at(0.4, M_PI / 2));
  const LoadHarmonics right = press_sliding(foot, 1e10, 0.3, load_at(0.4, -M_PI / 2));
  const double size = forward.a[0][2];
  // The second order in mu breaks the oddness by mu kappa C, a few parts in ten thousand here.
  EXPECT_NEAR(negative.a[0][2] / size, -1, 1e-3);
  EXPECT_NEAR(left.b[0][2] / size, 1, 1e-3);
  EXPECT_NEAR(right.b[0][2] / size, -1, 1e-3);
  EXPECT_NEAR(left.a[0][2] / size, 0, 1e-3);
  const LoadHarmonics half = press_sliding(foot, 1e10, 0.15, load_at(0.4));
  EXPECT_NEAR(half.a[0][2] / size, 0.5, 1e-3);
  const LoadHarmonics weak = press_sliding(foot, 1e10, 0.3, load_at(0.2));
  EXPECT_NEAR(weak.a[0][2] / size, 0.5, 1e-3);
}

TEST_F(FrictionCoupling, FollowsTheFullContactLaw)
{
  // (1 + K C_2) f_2 = (mu/2) K (C_2^zr - C_2^ztheta) f_1 on the circles, K the mat's stiffness per radian; on
  // one circle a_2/a_1 = (mu/2) kappa X / (1 + kappa C_2).
  const double modulus = 1e10;
  const double friction = 1e-4;
  const LoadHarmonics load = press_sliding(foot, modulus, friction, load_at(0.4));
  const Eigen::Index n_radii = compliance.n_nodes();
  Eigen::VectorXd first = Eigen::VectorXd::Zero(n_radii);
  for (Eigen::Index j = 0; j < 256; ++j)
    first += foot.solution.forces.segment(j * n_radii, n_radii) *
             std::cos(2 * M_PI * static_cast<double>(j) / 256) / M_PI;
  const HarmonicCompliance &second = compliance.harmonics[2];
  const Eigen::MatrixXd stiffness = modulus * mass(compliance.radii);
  const Eigen::MatrixXd resistance = Eigen::MatrixXd::Identity(n_radii, n_radii) + stiffness * second.normal;
  const Eigen::VectorXd expected =
    friction / 2 * resistance.partialPivLu().solve(stiffness * (second.radial - second.azimuthal) * first);
  EXPECT_NEAR(load.a[0][2] / expected.sum(), 1, 1e-4);
}

TEST_F(FrictionCoupling, YawMakesBothSinesAndCosines)
{
  const LoadHarmonics load = press_sliding(foot, 1e11, 0.3, load_at(0.4), -0.5 / 0.03);
  EXPECT_GT(std::abs(load.b[0][2] / load.a[0][0]), 1e-3);
  EXPECT_GT(std::abs(load.a[0][2] / load.a[0][0]), 1e-3);
  // Opposite spin is the mirror image in the plane of travel.
  const LoadHarmonics mirrored = press_sliding(foot, 1e11, 0.3, load_at(0.4), 0.5 / 0.03);
  for (unsigned int n = 1; n <= 8; ++n)
  {
    EXPECT_NEAR(mirrored.a[0][n], load.a[0][n], 1e-9 * load.a[0][0]);
    EXPECT_NEAR(mirrored.b[0][n], -load.b[0][n], 1e-9 * load.a[0][0]);
  }
}

TEST_F(FrictionCoupling, WithoutFrictionNothingChanges)
{
  const LoadHarmonics plain = foot.solve_on_winkler(1e10, load_at(1.2));
  const LoadHarmonics none = press_sliding(foot, 1e10, 0, load_at(1.2));
  for (unsigned int n = 0; n <= 8; ++n)
    EXPECT_EQ(plain.a[0][n], none.a[0][n]);
}
