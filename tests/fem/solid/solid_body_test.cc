// The elastic foot against foot_contact.json: displacement harmonics on a meridional mesh, confirmed by two
// other 3D engines.
#include "tests/fem/foot_case.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>

using namespace stemware::fem;
using namespace stemware::fem_tests;

namespace
{

std::vector<double> reference(const std::string &foot, const std::string &mat, const std::string &moment)
{
  std::ifstream file(STEMWARE_FOOT_CONTACT);
  return nlohmann::json::parse(file).at(foot).at(mat).at(moment).at("a_over_a0").get<std::vector<double>>();
}

/// Largest deviation of a_n / a_0 from @p expected over n = 2 ... @p n_max.
double deviation(const ContactLoad &load, const std::vector<double> &expected, unsigned int n_max)
{
  double largest = 0;
  for (unsigned int n = 2; n <= n_max; ++n)
    largest = std::max(largest, std::abs(load.a(n) / load.a(0) - expected[n]));
  return largest;
}

SolidOptions degree(unsigned int p)
{
  SolidOptions options;
  options.degree = p;
  return options;
}

} // namespace

TEST(ElasticFoot, FlatLandInFullContactMixesNoHarmonics)
{
  for (const unsigned int p : { 1u, 2u })
  {
    FootCase foot(flat_profile(), { 24, 4, 2 }, degree(p));
    const ContactLoad load = foot.solve_on_winkler(1e10, load_at(0.4));
    for (unsigned int n = 2; n <= 8; ++n)
      EXPECT_LT(std::abs(load.a(n) / load.a(0)), p == 1 ? 1e-5 : 1e-6) << "Q" << p << ", n = " << n;
    EXPECT_EQ(load.contact_fraction, 1);
    EXPECT_GT(load.least, 0);
  }
}

TEST(ElasticFoot, FlatLandApproachesTheReferenceWithRefinement)
{
  const std::vector<double> expected = reference("flat, land width 0.002", "k=1e10 Pa/m", "m=1.3");
  FootCase coarse(flat_profile(), { 12, 2, 1 }, degree(1));
  FootCase medium(flat_profile(), { 24, 4, 2 }, degree(1));
  FootCase fine(flat_profile(), { 48, 8, 4 }, degree(1));
  const double coarse_error = deviation(coarse.solve_on_winkler(1e10, load_at(1.3)), expected, 6);
  const double medium_error = deviation(medium.solve_on_winkler(1e10, load_at(1.3)), expected, 6);
  const double fine_error = deviation(fine.solve_on_winkler(1e10, load_at(1.3)), expected, 6);
  EXPECT_LT(medium_error, coarse_error / 2);
  EXPECT_LT(fine_error, medium_error / 2);
}

TEST(ElasticFoot, FlatLandOnAStifferMat)
{
  FootCase foot(flat_profile(), { 24, 4, 2 });
  const ContactLoad load = foot.solve_on_winkler(1e11, load_at(1.3));
  EXPECT_LT(deviation(load, reference("flat, land width 0.002", "k=1e11 Pa/m", "m=1.3"), 8), 2e-3);
}

TEST(ElasticFoot, CrownedRimOverTheWholeTable)
{
  FootCase foot(GlassProfile(), { 24, 4, 2 });
  for (const auto &[name, modulus] :
       { std::pair<std::string, double>{ "k=1e9 Pa/m", 1e9 }, { "k=1e10 Pa/m", 1e10 } })
    for (const auto &[moment, m] :
         { std::pair<std::string, double>{ "m=0.2", 0.2 }, { "m=0.5", 0.5 }, { "m=1.8", 1.8 } })
    {
      const ContactLoad load = foot.solve_on_winkler(modulus, load_at(m));
      EXPECT_LT(deviation(load, reference("crown 0.003, land width 0.004", name, moment), 8), 5e-4)
        << name << ", " << moment;
    }
}
