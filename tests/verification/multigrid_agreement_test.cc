#include "fem/contact/hard_interface.h"
#include "fem/revolution/meshed_revolution_foot.h"
#include "fem/solid/nested_contact.h"
#include "fem/solid/solid_foot.h"
#include "tests/fem/foot_case.h"
#include "tests/fem/revolution/revolution_case.h"
#include "tests/verification/calculix_foot.h"

#include <gtest/gtest.h>

using namespace stemware::revolution_tests;

namespace
{

/// Crowned foot on a mat under the moment ratio 1.2. Reference: body of revolution on cells halved twice.
struct CrownedFoot
{
  explicit CrownedFoot(GlassShape shape)
  {
    profile.shape = shape;
    MeridianOptions options;
    options.n_harmonics = 32;
    RevolutionCase revolution(profile, foot_compliance(profile, graded_cells(2), options), 512);
    expected = revolution.solve_on_winkler(1e11, load);
  }

  double error_of(const FootResolution &resolution, bool halves_land = false) const
  {
    SolidOptions options;
    options.linear_solver = LinearSolver::multigrid;
    FootCase foot(profile, resolution, options);
    if (halves_land)
      halve_land(foot, options);
    const WinklerInterface mat(1e11);
    const std::optional<ContactStart> start = start_from_coarser_mesh(*foot.body, mat, 1, load, foot.radius);
    const auto law = make_law(mat, foot.body->contact_surface());
    const ContactSolution solution = solve_contact(*foot.body, *law, load, foot.radius, {}, &start.value());
    return largest_difference(extract_load(*law, solution, 8), expected);
  }

  /// Halves the cells with a vertex at the land.
  void halve_land(FootCase &foot, const SolidOptions &options) const
  {
    foot.body.reset();
    for (const auto &cell : foot.triangulation.active_cell_iterators())
      for (const unsigned int v : cell->vertex_indices())
      {
        const double radius = std::hypot(cell->vertex(v)[0], cell->vertex(v)[1]);
        if (cell->is_locally_owned() && cell->vertex(v)[2] < 1.000001 * profile.land_height &&
            std::abs(radius - profile.contact_radius) < 0.500001 * profile.land_width)
          cell->set_refine_flag();
      }
    foot.triangulation.execute_coarsening_and_refinement();
    foot.body = make_body(
      TestSolver::multigrid, foot.triangulation,
      [profile = profile](double x, double y) { return profile.gap(std::hypot(x, y)); }, options);
  }

  const Resultants load = load_at(1.2);
  GlassProfile profile;
  ContactLoad expected;
};

} // namespace

TEST(MultigridAgreement, CrownedFeetAgreeWithTheBodyOfRevolution)
{
  // The profile of GlassShape::foot is smooth except at the edge of the foot. Next to the 270-degree corners
  // of GlassShape::step, elements of any degree converge slowly.
  EXPECT_LT(CrownedFoot(GlassShape::foot).error_of({ 48, 2, 2, 1 }), 1e-5);
  EXPECT_LT(CrownedFoot(GlassShape::step).error_of({ 48, 2, 2, 1 }), 3e-5);
}

TEST(MultigridAgreement, RefiningTheLandWithHangingNodesReducesTheError)
{
  // Hanging nodes border the refined cells inside and around the land. GlassShape::foot has a fillet, so that
  // errors at corners do not dominate.
  const CrownedFoot foot(GlassShape::foot);
  const double uniform = foot.error_of({ 24, 2, 1, 1 }), finer = foot.error_of({ 24, 2, 1, 1 }, true);
  EXPECT_LT(finer, uniform);
  EXPECT_LT(finer, 3e-5) << "uniform: " << uniform;
}

// References: CalculiX for n <= 6, the range of three other finite-element programs for n > 6.
TEST(MultigridAgreement, HardFlatLandAgreesWithOtherPrograms)
{
  SolidSetup setup;
  setup.profile = flat_profile();
  setup.table.interface = std::make_shared<HardInterface>();
  setup.options.linear_solver = LinearSolver::multigrid;
  SolidFoot foot(generate_solid_mesh(setup.profile, { 48, 2, 2, 1 }), setup);
  const ContactLoad load = foot.solve(load_at(1.3)).load;
  std::vector<double> expected;
  for (const auto &other : stemware::verification::CalculixFoot("flat").loads)
    if (!other.modulus && other.moment_ratio == 1.3)
      expected = other.a;
  ASSERT_EQ(expected.size(), 7u);
  expected.insert(expected.end(), { -0.1415, -0.0125 });
  for (unsigned int n = 1; n <= 8; ++n)
    EXPECT_NEAR(load.a(n) / load.a(0), expected[n], n <= 3 ? 2e-3 : 4e-3) << "n = " << n;
}

// The cells of the solid foot are halved five times towards the edges of the land. Reference: body of
// revolution with elements of degree 3, a graded mesh, twice the default number of azimuth lines and 1.5
// times the default number of harmonics.
TEST(MultigridAgreement, HardFlatLandAgreesWithTheBodyOfRevolutionLong)
{
  RevolutionSetup setup;
  setup.profile = flat_profile();
  setup.profile.shape = GlassShape::foot;
  setup.table.interface = std::make_shared<HardInterface>();
  setup.meridian.degree = 3;
  setup.meridian.n_harmonics = 24;
  setup.resolution.refinements = 1;
  setup.n_lines = 512;
  SolidSetup solid_setup;
  solid_setup.profile = setup.profile;
  solid_setup.table = setup.table;
  solid_setup.options.linear_solver = LinearSolver::multigrid;
  FootResolution resolution{ 48, 4, 2 };
  resolution.edge_halvings = edge_halvings_for(setup.profile, true);
  ContactDemand demand = load_at(1.2);
  demand.n_harmonics = 8;
  const SolidFoot solid(generate_solid_mesh(setup.profile, resolution), solid_setup);
  const MeshedRevolutionFoot revolution(setup.resolved_for(weight));
  EXPECT_LT(largest_difference(solid.solve(demand).load, revolution.solve(demand).load), 3e-4);
}
