// A contact on any number of ranks against the same on each rank alone: other partitions, numberings and
// sums.
#include "fem/contact/winkler_interface.h"
#include "fem/geometry/foot_mesh.h"
#include "fem/solid/nested_contact.h"
#include "tests/fem/reference_load.h"

#include <deal.II/distributed/tria.h>

#include <gtest/gtest.h>

using namespace stemware::fem_tests;

namespace
{

LoadHarmonics load_on(MPI_Comm communicator, const FootResolution &resolution, unsigned int degree)
{
  const GlassProfile profile;
  dealii::parallel::distributed::Triangulation<3> mesh(communicator);
  make_foot_mesh(profile, resolution, mesh);
  SolidOptions options;
  options.degree = degree;
  options.linear_solver = LinearSolver::multigrid;
  SolidBody body(
    mesh, ElasticMaterial(), [profile](double x, double y) { return profile.gap(std::hypot(x, y)); },
    options);
  body.set_sliding({ 0.2, -10, 0, {} });
  const WinklerInterface mat(1e11);
  const Resultants demand = load_at(1.3, 0.4);
  const std::optional<ContactStart> start =
    start_from_coarser_mesh(body, mat, 1, demand, profile.contact_radius);
  EXPECT_EQ(start.has_value(), body.has_hierarchy());
  const auto law = make_law(mat, body.contact_surface());
  const ContactSolution solution =
    solve_contact(body, *law, demand, profile.contact_radius, {}, start ? &*start : nullptr);
  return extract_load(*law, solution, 12);
}

void expect_the_same_on_all_ranks(const FootResolution &resolution, unsigned int degree)
{
  const LoadHarmonics load = load_on(MPI_COMM_WORLD, resolution, degree),
                      alone = load_on(MPI_COMM_SELF, resolution, degree);
  const double a_0 = alone.a[0][0];
  for (unsigned int n = 0; n <= 12; ++n)
  {
    EXPECT_NEAR(load.a[0][n] / a_0, alone.a[0][n] / a_0, 1e-9) << n;
    EXPECT_NEAR(load.b[0][n] / a_0, alone.b[0][n] / a_0, 1e-9) << n;
  }
  ASSERT_EQ(load.pointwise.size(), alone.pointwise.size());
  double largest = 0;
  for (std::size_t i = 0; i < load.pointwise.size(); ++i)
    largest = std::max(largest, std::abs(load.pointwise[i].density - alone.pointwise[i].density));
  EXPECT_LT(largest, 1e-9 * a_0);
}

} // namespace

TEST(Ranks, ContactByMultigridIsThatOfOneRank)
{
  expect_the_same_on_all_ranks({ 24, 2, 1, 1 }, 2);
}

TEST(Ranks, SoIsContactOnAMeshWithoutCoarserOnes)
{
  expect_the_same_on_all_ranks({ 48, 4, 4 }, 1);
}
