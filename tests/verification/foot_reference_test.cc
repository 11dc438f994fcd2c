// Elastic foot. References: CalculiX (calculix_foot.py) and spectral elements in numpy (foot_contact.py).
#include "tests/fem/revolution/revolution_case.h"
#include "tests/verification/calculix_foot.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>

using namespace stemware::revolution_tests;
using stemware::verification::CalculixFoot;
using stemware::verification::CalculixLoad;

namespace
{

/// Compares a_n / a_0 with foot_contact.json for every mat and moment of @p foot. The allowed error is the
/// error band of the reference plus @p tolerance for the error of quadratic elements at the corners of the
/// land.
void compare_with_reference(const std::string &foot, const GlassProfile &profile,
                            const MeridianResolution &resolution, double tolerance)
{
  std::ifstream file(STEMWARE_FOOT_CONTACT);
  const nlohmann::json reference = nlohmann::json::parse(file).at(foot);
  RevolutionCase revolution(profile, foot_compliance(profile, resolution, { 2, 16 }), 256);
  for (const auto &[mat, moments] : reference.items())
    for (const auto &[moment, expected] : moments.items())
    {
      const double modulus = std::stod(mat.substr(2));
      const double m = std::stod(moment.substr(2));
      const ContactLoad load = revolution.solve_on_winkler(modulus, load_at(m));
      const auto ratios = expected.at("a_over_a0").get<std::vector<double>>();
      const auto band = expected.at("band").get<std::vector<double>>();
      for (unsigned int n = 1; n <= 8; ++n)
        EXPECT_NEAR(load.a(n) / load.a(0), ratios[n], band[n] + tolerance)
          << mat << ", " << moment << ", n = " << n;
      EXPECT_NEAR(load.mean_radius, expected.at("mean_radius").get<double>(), 2e-7) << mat << ", " << moment;
    }
}

void compare_with_calculix(const std::string &kind, const GlassProfile &profile,
                           const MeridianResolution &resolution, double tolerance)
{
  const CalculixFoot reference(kind);
  const ContactCompliance compliance = foot_compliance(profile, resolution);
  const Eigen::VectorXd nodes = nodes_between(compliance, 0, 1);
  for (unsigned int n = 0; n <= 6; ++n)
  {
    const HarmonicCompliance &here = compliance.harmonics[n];
    // Forces of the harmonics 0 and 1 deform the corner at the stem, where the mesh of CalculiX is too
    // coarse. For n > 3, the error of the 48 sectors of CalculiX is larger.
    const double part = n == 2 || n == 3 ? 3e-3 : 1.2e-2;
    EXPECT_NEAR(nodes.dot(here.normal * nodes) / reference.normal[n], 1, part) << n;
    EXPECT_NEAR(nodes.dot(here.radial * nodes) / reference.radial[n], 1, part) << n;
    if (n > 0)
    {
      EXPECT_NEAR(nodes.dot(here.azimuthal * nodes) / reference.azimuthal[n], 1, part) << n;
    }
  }
  RevolutionCase foot(profile, compliance);
  unsigned int n_compared = 0;
  for (const CalculixLoad &expected : reference.loads)
    if (expected.modulus)
    {
      ++n_compared;
      foot.body.set_sliding(SlidingTraction{ expected.friction, expected.spin_per_speed });
      const ContactLoad load =
        foot.solve_on_winkler(*expected.modulus, load_at(expected.moment_ratio, expected.direction));
      for (unsigned int n = 1; n <= 6; ++n)
      {
        EXPECT_NEAR(load.a(n) / load.a(0), expected.a[n], tolerance) << expected.name() << ", " << n;
        EXPECT_NEAR(load.b(n) / load.a(0), expected.b[n], tolerance) << expected.name() << ", " << n;
      }
    }
  EXPECT_GT(n_compared, 0u);
}

} // namespace

TEST(FootReference, FlatFootAgreesWithCalculiX)
{
  compare_with_calculix("flat", flat_profile(), equal_cells(1), 1e-4);
}

TEST(FootReference, CrownedFootAgreesWithCalculiX)
{
  compare_with_calculix("crown", GlassProfile(), graded_cells(1), 6e-5);
}

TEST(FootReference, CrownedFootAgreesWithSpectralElements)
{
  compare_with_reference("crown 0.003, land width 0.004", GlassProfile(), graded_cells(1), 4e-5);
}

TEST(FootReference, FlatFootAgreesWithSpectralElements)
{
  compare_with_reference("flat, land width 0.002", flat_profile(), equal_cells(1), 2e-4);
}

// Only friction causes the second harmonic of the flat foot.
TEST(FrictionCoupling, SecondHarmonicOfTheFlatFootAgreesWithCalculiX)
{
  RevolutionCase foot(flat_profile(), foot_compliance(flat_profile(), equal_cells(1)));
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
