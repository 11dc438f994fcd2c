// The elastic foot against foot_contact.json: a dense numpy prototype of the same formulation on finer
// meshes, confirmed by two 3D engines.
#include "tests/fem/revolution/revolution_case.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>

using namespace stemware::revolution_tests;

namespace
{

/// Every mat and moment of @p foot in the reference file; each a_n / a_0 within its band plus 1e-5.
void compare_with_reference(const std::string &foot, const GlassProfile &profile,
                            const MeridianResolution &resolution, unsigned int degree = 2,
                            unsigned int n_lines = 256)
{
  std::ifstream file(STEMWARE_FOOT_CONTACT);
  const nlohmann::json reference = nlohmann::json::parse(file).at(foot);
  RevolutionCase revolution(profile, foot_compliance(profile, resolution, { degree, 16 }), n_lines);
  for (const auto &[mat, moments] : reference.items())
    for (const auto &[moment, expected] : moments.items())
    {
      const double modulus = std::stod(mat.substr(2));
      const double m = std::stod(moment.substr(2));
      const LoadHarmonics load = revolution.solve_on_winkler(modulus, load_at(m));
      const auto ratios = expected.at("a_over_a0").get<std::vector<double>>();
      const auto band = expected.at("band").get<std::vector<double>>();
      for (unsigned int n = 1; n <= 8; ++n)
        EXPECT_NEAR(load.a[0][n] / load.a[0][0], ratios[n], band[n] + 1e-5)
          << mat << ", " << moment << ", n = " << n << ", degree " << degree;
      EXPECT_NEAR(load.mean_radius, expected.at("mean_radius").get<double>(), 1e-7) << mat << ", " << moment;
    }
}

} // namespace

TEST(FootReference, CrownedFootOnThreeMats)
{
  compare_with_reference("crown 0.003, land width 0.004", GlassProfile(), graded_cells(1));
}

TEST(FootReference, FlatFootOnTwoMats)
{
  compare_with_reference("flat, land width 0.002", flat_profile(), equal_cells(1));
}

TEST(FootReference, CubicAndQuarticElements)
{
  // They need no halving to be as good as halved quadratic ones. At m = 1.8 on the stiffest mat 256 lines
  // leave 2e-5 of the eighth harmonic, whatever the elements.
  compare_with_reference("crown 0.003, land width 0.004", GlassProfile(), graded_cells(0), 3, 1024);
  compare_with_reference("crown 0.003, land width 0.004", GlassProfile(), graded_cells(0), 4, 1024);
  compare_with_reference("flat, land width 0.002", flat_profile(), equal_cells(0), 4, 1024);
}
