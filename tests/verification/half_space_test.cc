// A narrow ring pressed into a thick disc, against line contact on an elastic half-space (leading order in
// width / radius).
#include "tests/fem/revolution/revolution_case.h"

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

using namespace stemware::revolution_tests;

namespace
{

/// Displacement of a rigid strip under q_n cos(n theta) per length over w_n = q_n/(pi E*) [2 ln(16 R/b) - 4
/// sum_{k <= n} 1/(2k - 1)], the leading order for a flat strip of half-width b: farthest from 1 over n = 1
/// ... 6.
double deviation_from_line_load(unsigned int refinements)
{
  GlassProfile strip;
  strip.land_width = 2e-4;
  strip.crown_radius = 0;
  TableDisc disc;
  disc.radius = 0.3;
  disc.thickness = 0.3;
  const ElasticMaterial material{ 10e9, 0.3 };
  const double modulus = material.young_modulus / (1 - material.poisson_ratio * material.poisson_ratio);
  MeridianResolution resolution = equal_cells(refinements);
  resolution.land_cells = 8;
  dealii::Triangulation<2> triangulation;
  make_meridian_mesh(disc, strip, resolution, triangulation);
  const ContactCompliance compliance = compute_compliance(triangulation, material, { 2, 6 });

  double sum = 0;
  double farthest = 0;
  for (unsigned int n = 1; n <= 6; ++n)
  {
    sum += 1 / (2. * n - 1);
    // Force per radian that moves the whole strip by one metre.
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(compliance.n_nodes());
    const double force = Eigen::LLT<Eigen::MatrixXd>(compliance.harmonics[n].normal).solve(ones).sum();
    const double line_load = force / strip.contact_radius;
    const double half_width = strip.land_width / 2;
    const double displacement =
      line_load / (M_PI * modulus) * (2 * std::log(16 * strip.contact_radius / half_width) - 4 * sum);
    farthest = std::max(farthest, std::abs(1 / displacement - 1));
  }
  return farthest;
}

} // namespace

TEST(HalfSpace, NarrowRigidRingSinksInLikeALineLoad)
{
  const double coarse = deviation_from_line_load(0);
  const double fine = deviation_from_line_load(1);
  EXPECT_LT(coarse, 0.022); // the pressure is singular at the strip's edges: first order in the cell size
  EXPECT_LT(fine, 0.012);
  EXPECT_LT(fine, coarse / 1.6);
}
