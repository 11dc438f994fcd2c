// The foot of a wine glass: what its smooth section does to the accuracy, and limits where it is known
// otherwise.
#include "tests/fem/foot_case.h"
#include "tests/fem/geometry/profile_oracle.h"
#include "tests/fem/revolution/revolution_case.h"

#include <Eigen/Cholesky>
#include <boost/math/quadrature/gauss.hpp>
#include <gtest/gtest.h>

namespace
{

using namespace stemware::revolution_tests;
using stemware::fem_tests::foot_profile;
using stemware::fem_tests::FootCase;

/// Order of a_2 ... a_4 between the meridional mesh and the same halved, quadratic elements, against cubic
/// ones on the halved mesh.
double observed_order(const GlassProfile &profile)
{
  const auto solve = [&](unsigned int refinements, unsigned int degree)
  {
    RevolutionCase foot(profile, foot_compliance(profile, graded_cells(refinements), { degree, 8 }));
    return foot.solve_on_winkler(1e10, load_at(1.2));
  };
  const ContactLoad finest = solve(1, 3);
  return std::log2(largest_difference(solve(0, 2), finest, 4) / largest_difference(solve(1, 2), finest, 4));
}

/// Thickness of a plate over the radius [m].
using Thickness = std::function<double(double radius)>;

/// Deflection per vertical unit force (per radian, times cos n theta) on the circle @p radius of a thin
/// annular plate, clamped at @p inner, free at @p outer [m rad/N]: cubic Hermite elements for Kirchhoff's
/// energy
///   D/2 int [ k_r^2 + k_t^2 + 2 nu k_r k_t + 2 (1 - nu) k_rt^2 ] r dr,    D = E t^3 / (12 (1 - nu^2)),
/// with k_r = w'', k_t = w'/r - n^2 w/r^2, k_rt = n (w'/r - w/r^2).
double plate_compliance(unsigned int n, const Thickness &thickness, double inner, double radius, double outer)
{
  const ElasticMaterial glass;
  const double nu = glass.poisson_ratio;
  constexpr int n_inside = 80;
  constexpr int n_outside = 20;
  constexpr int n_dofs = 2 * (n_inside + n_outside + 1);
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(n_dofs, n_dofs);
  for (int cell = 0; cell < n_inside + n_outside; ++cell)
  {
    const bool inside = cell < n_inside;
    const double h = inside ? (radius - inner) / n_inside : (outer - radius) / n_outside;
    const double begin = inside ? inner + h * cell : radius + h * (cell - n_inside);
    const auto energy = [&](double s) -> Eigen::Matrix4d
    {
      const double r = begin + h * s;
      const double t = thickness(r);
      const double bending = glass.young_modulus * t * t * t / (12 * (1 - nu * nu));
      const Eigen::RowVector4d w(1 - s * s * (3 - 2 * s), h * s * (1 - s) * (1 - s), s * s * (3 - 2 * s),
                                 -h * s * s * (1 - s));
      const Eigen::RowVector4d slope(-6 * s * (1 - s) / h, (1 - s) * (1 - 3 * s), 6 * s * (1 - s) / h,
                                     s * (3 * s - 2));
      const Eigen::RowVector4d radial =
        Eigen::RowVector4d(12 * s - 6, h * (6 * s - 4), 6 - 12 * s, h * (6 * s - 2)) / (h * h);
      const Eigen::RowVector4d hoop = slope / r - n * n * w / (r * r);
      const Eigen::RowVector4d twist = n * (slope / r - w / (r * r));
      return bending * r * h *
             (radial.transpose() * radial + hoop.transpose() * hoop +
              nu * (radial.transpose() * hoop + hoop.transpose() * radial) +
              2 * (1 - nu) * twist.transpose() * twist);
    };
    using Gauss = boost::math::quadrature::gauss<double, 7>;
    for (std::size_t q = 0; q < Gauss::abscissa().size(); ++q)
      for (const double side : { -1., 1. })
        if (Gauss::abscissa()[q] > 0 || side > 0)
          stiffness.block<4, 4>(2 * cell, 2 * cell) +=
            Gauss::weights()[q] / 2 * energy((1 + side * Gauss::abscissa()[q]) / 2);
  }
  const Eigen::MatrixXd free = stiffness.bottomRightCorner(n_dofs - 2, n_dofs - 2);
  Eigen::VectorXd force = Eigen::VectorXd::Zero(n_dofs - 2);
  force(2 * n_inside - 2) = 1;
  return free.llt().solve(force)(2 * n_inside - 2);
}

} // namespace

TEST(RealFoot, HarmonicsConvergeFasterThanOnTheStep)
{
  // The step's corners, 270 degrees of glass, leave a displacement like the power 0.54 of the distance.
  EXPECT_GT(observed_order(foot_profile()), 3.4);
  EXPECT_LT(observed_order(GlassProfile()), 2.2);
}

TEST(RealFoot, SolidBodyAgrees)
{
  GlassProfile profile = flat_profile();
  profile.shape = GlassShape::foot;
  RevolutionCase revolution(profile, foot_compliance(profile, equal_cells(1)));
  const Resultants load = load_at(1.3);
  const ContactLoad expected = revolution.solve_on_winkler(1e10, load);
  SolidOptions linear;
  linear.degree = 1;
  double before = 0;
  for (const unsigned int n : { 12u, 24u, 48u })
  {
    FootCase solid(profile, { n, n / 6, n / 12 }, linear);
    const ContactLoad answer = solid.solve_on_winkler(1e10, load);
    EXPECT_NEAR(answer.a(0) / expected.a(0), 1, 1e-10);
    EXPECT_NEAR(answer.moment().y() / expected.moment().y(), 1, 1e-9);
    const double now = largest_difference(answer, expected, 6);
    if (before > 0)
    {
      EXPECT_GT(std::log2(before / now), 1.6) << n << " trilinear cells round the rim";
    }
    before = now;
  }
  FootCase quadratic(profile, { 24, 4, 2 });
  EXPECT_LT(largest_difference(quadratic.solve_on_winkler(1e10, load), expected, 6), 1e-4);
}

TEST(RealFoot, ThinFootBendsLikeAPlate)
{
  // A tapering plate clamped to the stem; the stem's own give, and shear, are of the order of thickness over
  // radius and matter less to the higher harmonics, which hardly reach the stem.
  std::array<double, 7> before{};
  for (const double thickness : { 5e-4, 2.5e-4 })
  {
    GlassProfile profile = foot_profile();
    profile.foot_thickness = thickness;
    profile.edge_thickness = 0.7 * thickness;
    profile.underside_rise = 0;
    profile.land_height = 1e-9;
    profile.land_width = 0.001;
    profile.fillet_radius = 0;
    const ContactCompliance compliance = foot_compliance(profile, equal_cells(), { 2, 6 });
    const unsigned int rim = compliance.n_nodes() / 2;
    ASSERT_NEAR(compliance.radii(rim), profile.contact_radius, 1e-15);
    const auto tapering = [&](double radius)
    {
      const double share = (radius - profile.stem_radius) / (profile.foot_radius - profile.stem_radius);
      return thickness * (1 - 0.3 * share);
    };
    for (unsigned int n = 2; n <= 6; ++n)
    {
      const double error =
        compliance.harmonics[n].normal(rim, rim) /
          plate_compliance(n, tapering, profile.stem_radius, profile.contact_radius, profile.foot_radius) -
        1;
      if (before[n] > 0)
      {
        EXPECT_LT(error, n == 2 ? 1.2e-2 : 2e-3) << "harmonic " << n;
        EXPECT_LT(std::abs(error), before[n] / 1.8) << "harmonic " << n;
      }
      before[n] = error;
    }
  }
}
