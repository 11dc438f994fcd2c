// A contact on any number of ranks against the same on each rank alone: other partitions, numberings and
// sums.
#include "fem/contact/winkler_interface.h"
#include "fem/geometry/foot_mesh.h"
#include "fem/solid/nested_contact.h"
#include "tests/fem/reference_load.h"

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/tria.h>

#include <gtest/gtest.h>

#include <set>

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

// Oracle: the whole surface, on one rank.
TEST(Ranks, EachHasTheContactSurfaceOfItsOwnCells)
{
  const auto surface_on = [](MPI_Comm communicator)
  {
    const GlassProfile profile = flat_profile();
    dealii::parallel::distributed::Triangulation<3> mesh(communicator);
    make_foot_mesh(profile, { 24, 2, 1, 1, 1 }, mesh); // with nodes that hang on others
    SolidOptions options;
    options.degree = 1;
    const SolidBody body(
      mesh, ElasticMaterial(), [](double, double) { return 0.; }, options);
    return body.contact_surface();
  };
  const ContactSurface part = surface_on(MPI_COMM_WORLD), whole = surface_on(MPI_COMM_SELF);
  EXPECT_EQ(part.parts.sum(part.lines.size()), whole.lines.size());
  EXPECT_EQ(part.n_nodes_of_whole(), whole.n_nodes());
  EXPECT_NEAR(part.area() / whole.area(), 1, 1e-12);
  EXPECT_EQ(part.n_sectors, whole.n_sectors);
  const Eigen::VectorXd pressure = Eigen::VectorXd::Ones(part.n_nodes());
  EXPECT_EQ(part.n_nodes_across(pressure), whole.n_nodes_across(Eigen::VectorXd::Ones(whole.n_nodes())));

  // No rank has more than its share: the nodes of others are those that its lines reach.
  std::set<unsigned int> reached;
  for (const ContactLine &line : part.lines)
    reached.insert(line.nodes.begin(), line.nodes.end());
  for (unsigned int i = part.n_own_nodes(); i < part.n_nodes(); ++i)
    EXPECT_EQ(reached.count(i), 1u) << i;
  const bool is_shared = dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1;
  const double most = part.parts.max(static_cast<double>(part.lines.size()));
  EXPECT_EQ(most < static_cast<double>(whole.lines.size()), is_shared);
}
