// Sliding friction that deforms the foot, and the table. Kinds of reference: another program, and
// Boussinesq's and Cerruti's half-space under strips.
#include "fem/meridian/meshed_revolution_foot.h"
#include "tests/fem/revolution/revolution_case.h"
#include "tests/verification/calculix_foot.h"
#include "tests/verification/half_space_formulas.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

using namespace stemware::revolution_tests;

namespace
{

/// A flat rigid annulus that slides along x, without spin, over a mat on a half-space, loaded all over:
/// strips of constant pressure, harmonics 0 ... highest, one linear system. The table under the foot is
/// dragged along x, t_r = mu p cos(theta), t_theta = -mu p sin(theta).
class SlidingAnnulus
{
public:
  SlidingAnnulus(stemware::verification::Band land, const ElasticMaterial &material, double modulus,
                 double friction, double force, double moment)
      : land(land)
      , width((land.outer - land.inner) / n_strips)
  {
    constexpr int size = n_strips * (highest + 1);
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size + 2, size + 2);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(size + 2);
    const double drag = friction * (1 - 2 * material.poisson_ratio) / (4 * material.shear_modulus());
    // p / k - w_n = d0 (n = 0), d1 r (n = 1), w the rise of the table.
    for (int n = 0; n <= highest; ++n)
      for (int i = 0; i < n_strips; ++i)
      {
        const int row = at(n, i);
        const double r = radius(i);
        matrix(row, row) += 1 / modulus;
        for (int j = 0; j < n_strips; ++j)
        {
          const double s = radius(j);
          matrix(row, at(n, j)) += width * s * ring_kernel(n, r, s, i - j) /
                                   (M_PI * stemware::verification::plane_strain_modulus(material));
          // Harmonic n of the drag comes from the pressure's n - 1 and n + 1.
          const auto rise = [&](double radial, double azimuthal)
          {
            if (n == 0)
              return i < j ? 2 * radial : i == j ? radial : 0.;
            const double power = std::pow(std::min(r, s) / std::max(r, s), n);
            return power * (i < j ? radial + azimuthal : i > j ? azimuthal - radial : azimuthal);
          };
          if (n > 0)
            matrix(row, at(n - 1, j)) -= drag * width * (n == 1 ? rise(1, -1) : rise(0.5, -0.5));
          if (n < highest)
            matrix(row, at(n + 1, j)) -= drag * width * rise(0.5, n == 0 ? 0 : 0.5);
        }
        if (n == 0)
        {
          matrix(row, size) = -1;
          matrix(size, row) = 2 * M_PI * r * width;
        }
        if (n == 1)
        {
          matrix(row, size + 1) = -r;
          matrix(size + 1, row) = M_PI * r * r * width;
        }
      }
    right(size) = force;
    right(size + 1) = moment; // sum x f
    pressure = matrix.partialPivLu().solve(right).head(size);
  }

  /// a_n / a_0.
  double harmonic(int n) const
  {
    double amplitude = 0, mean = 0;
    for (int i = 0; i < n_strips; ++i)
    {
      amplitude += radius(i) * pressure(at(n, i));
      mean += radius(i) * pressure(at(0, i));
    }
    return amplitude / mean;
  }

private:
  static constexpr int n_strips = 40, highest = 5;

  static int at(int n, int i) { return n * n_strips + i; }
  double radius(int i) const { return land.inner + (i + 0.5) * width; }

  /// int cos(n phi) / rho dphi between two strips, at the distance whose logarithm is their mean.
  double ring_kernel(int n, double r, double s, int strips_apart) const
  {
    const auto twice_integrated = [](double x)
    { return x == 0 ? 0. : x * x / 2 * (std::log(std::abs(x)) - 1.5); };
    const double distance =
      width * std::exp(twice_integrated(strips_apart + 1) - 2 * twice_integrated(strips_apart) +
                       twice_integrated(strips_apart - 1));
    const double scale = distance / std::sqrt(r * s);
    const auto integrand = [&](double t)
    {
      const double phi = scale * std::sinh(t);
      return 2 * std::cos(n * phi) * scale * std::cosh(t) /
             std::hypot(distance, 2 * std::sqrt(r * s) * std::sin(phi / 2));
    };
    return stemware::verification::integral(integrand, 0, std::asinh(M_PI / scale), 6);
  }

  const stemware::verification::Band land;
  const double width;
  Eigen::VectorXd pressure;
};

} // namespace

TEST(FrictionCoupling, SecondHarmonicOfTheFlatFoot)
{
  RevolutionCase foot(flat_profile(), foot_compliance(flat_profile(), equal_cells(1)));
  // 4.0e-4, 3.45e-3 and 1.43e-2, by CalculiX.
  unsigned int n_compared = 0;
  for (const auto &expected : stemware::verification::CalculixFoot("flat").loads)
    if (expected.modulus && expected.friction > 0 && expected.spin_per_speed == 0)
    {
      foot.body.set_sliding(SlidingTraction{ expected.friction, 0 });
      const ContactLoad load = foot.solve_on_winkler(*expected.modulus, load_at(expected.moment_ratio));
      EXPECT_NEAR(load.a(2) / load.a(0) / expected.a[2], 1, 5e-3) << expected.name();
      EXPECT_NEAR(load.normal_force() / weight, 1, 1e-10);
      EXPECT_NEAR(load.moment().y() / load_at(expected.moment_ratio).moment_y, 1, 1e-9);
      ++n_compared;
    }
  EXPECT_EQ(n_compared, 3u);
}

// A rigid foot on wood: all of a_2 is the table's, and has the sign of a table that is dragged along, z up.
TEST(FrictionOfTheTable, DeformsItAsAHalfSpace)
{
  const ElasticMaterial wood{ 10e9, 0.2 };
  RevolutionSetup setup;
  setup.profile.crown_radius = 0;
  setup.foot_is_rigid = true;
  setup.table = { std::make_shared<WinklerInterface>(1e12), Substrate{ { 0.3, 0.3 }, wood } };
  setup.friction_coefficient = 0.3;
  setup.meridian.n_harmonics = 8;
  setup.n_lines = 64;
  MeshedRevolutionFoot foot(setup.resolved_for(weight));
  const ContactLoad load = foot.solve(load_at(0.4)).load;
  const SlidingAnnulus expected({ setup.profile.land_inner_radius(), setup.profile.land_outer_radius() },
                                wood, 1e12, 0.3, weight, -load_at(0.4).moment_y);
  EXPECT_EQ(load.contact_fraction, 1);
  EXPECT_NEAR(load.a(1) / load.a(0), expected.harmonic(1), 1e-4);
  EXPECT_NEAR(load.a(2) / load.a(0) / expected.harmonic(2), 1, 1e-2);
  EXPECT_NEAR(load.a(3) / load.a(0) / expected.harmonic(3), 1, 2e-2);
}
