// The solid body by geometric multigrid against the body of revolution: other elements, another linear solver,
// the same interface law.
#include "fem/solid/nested_contact.h"
#include "tests/fem/foot_case.h"
#include "tests/fem/revolution/revolution_case.h"

#include <gtest/gtest.h>

using namespace stemware::revolution_tests;

namespace
{

LoadHarmonics solid_load(const GlassProfile &profile, const FootResolution &resolution, double modulus,
                         const Resultants &load)
{
  SolidOptions options;
  options.linear_solver = LinearSolver::multigrid;
  FootCase foot(profile, resolution, options);
  const MakeTableLaw make = [modulus](const SolidBody &body)
  { return make_law(WinklerInterface(modulus), body.contact_surface()); };
  const std::optional<ContactStart> start = start_from_coarser_mesh(*foot.body, make, load, foot.radius);
  const auto law = make(*foot.body);
  return extract_load(*law, solve_contact(*foot.body, *law, load, foot.radius, {}, &start.value()), 8);
}

/// Largest |a_n - expected a_n| / a_0 over n = 2 ... 8.
double largest_difference(const LoadHarmonics &load, const LoadHarmonics &expected)
{
  double largest = 0;
  for (unsigned int n = 2; n <= 8; ++n)
    largest = std::max(largest, std::abs(load.a[0][n] - expected.a[0][n]) / expected.a[0][0]);
  return largest;
}

} // namespace

TEST(MultigridAgreement, Scan)
{
  for (const GlassShape shape : { GlassShape::foot, GlassShape::step })
  {
    GlassProfile profile;
    profile.shape = shape;
    MeridianOptions options;
    options.n_harmonics = 32;
    RevolutionCase revolution(profile, foot_compliance(profile, graded_cells(2), options), 512);
    RevolutionCase coarser(profile, foot_compliance(profile, graded_cells(1), options), 512);
    for (const double m : { 0.5, 1.2 })
    {
      const LoadHarmonics expected = revolution.solve_on_winkler(1e11, load_at(m));
      printf("shape %d m %.1f revolution itself %.1e\n", int(shape), m,
             largest_difference(coarser.solve_on_winkler(1e11, load_at(m)), expected));
      for (const FootResolution &cells : { FootResolution{ 48, 2, 2, 1 }, FootResolution{ 48, 4, 2, 1 }, FootResolution{ 48, 2, 2, 2 } })
      {
        const LoadHarmonics load = solid_load(profile, cells, 1e11, load_at(m));
        printf("%u %u %u %u: %.2e\n", cells.azimuthal_cells, cells.radial_cells, cells.foot_layers, cells.refinements, largest_difference(load, expected));
        fflush(stdout);
      }
    }
  }
}
