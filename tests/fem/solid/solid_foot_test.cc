#include "fem/contact/hard_interface.h"
#include "fem/contact/winkler_interface.h"
#include "fem/geometry/mesh_io.h"
#include "fem/revolution/meshed_revolution_foot.h"
#include "fem/solid/solid_foot.h"
#include "tests/fem/reference_load.h"
#include "tests/fem/scratch_folder.h"

#include <deal.II/base/mpi.h>
#include <deal.II/grid/tria.h>

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

using namespace stemware::fem_tests;
using stemware::test::TemporaryFile;

namespace
{

SolidSetup coarse_setup(std::shared_ptr<const InterfaceLaw> interface)
{
  SolidSetup setup;
  setup.table.interface = std::move(interface);
  setup.options.degree = 1;
  return setup;
}

SolidMesh coarse_mesh()
{
  return generate_solid_mesh(GlassProfile(), { 12, 4, 1 });
}

} // namespace

TEST(SolidFoot, StatesStayValidAfterTheNextSolve)
{
  const std::shared_ptr<const InterfaceLaw> interfaces[] = { std::make_shared<WinklerInterface>(1e11),
                                                             std::make_shared<HardInterface>() };
  for (const auto &interface : interfaces)
  {
    SolidFoot foot(coarse_mesh(), coarse_setup(interface));
    const ContactState first = foot.solve(load_at(0.5, 0.7));
    const std::vector<PointForce> points = foot.point_forces(first);
    const PressureMap pressure_map = foot.pressure_map(first);
    EXPECT_FALSE(first.history.empty());
    const std::string fields = foot.fields(first).front().text;
    foot.solve(load_at(1.2, 2.));
    const std::vector<PointForce> later = foot.point_forces(first);
    ASSERT_EQ(later.size(), points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
      EXPECT_EQ(later[i].force, points[i].force);
    const PressureMap same_map = foot.pressure_map(first);
    EXPECT_EQ(foot.fields(first).front().text, fields);
    if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) > 0)
    {
      EXPECT_TRUE(points.empty() && pressure_map.cuts.empty()); // the map is gathered on the first rank
      continue;
    }
    EXPECT_NEAR(harmonics_of(later, 1).moment().x() / first.load.moment().x(), 1, 1e-12);
    EXPECT_EQ(same_map.cuts.front().front().pressure, pressure_map.cuts.front().front().pressure);
  }
}

/// Friction and tilt moment make the system unsymmetric. The condensed solver uses the compliance of the
/// contact nodes, multigrid the whole body.
TEST(SolidFoot, CondensedSolverAgreesWithMultigrid)
{
  const std::shared_ptr<const InterfaceLaw> interfaces[] = { std::make_shared<WinklerInterface>(1e11),
                                                             std::make_shared<HardInterface>() };
  for (const auto &interface : interfaces)
    for (const double mu : { 0., 0.4 })
    {
      SolidSetup setup = coarse_setup(interface);
      setup.options.degree = 2;
      setup.friction_coefficient = mu;
      const SolidFoot condensed(coarse_mesh(), setup);
      setup.options.linear_solver = LinearSolver::multigrid;
      const SolidFoot whole(coarse_mesh(), setup);
      ContactDemand demand = load_at(1.2, 0.4);
      demand.tilt_moment = 0.05 * demand.normal_force;
      const stemware::ring::Slip slip = { 7., {} };
      const ContactState one = condensed.solve(demand, slip), other = whole.solve(demand, slip);
      for (unsigned int n = 0; n <= 4; ++n)
        EXPECT_NEAR(one.load.a(n), other.load.a(n), 1e-8 * other.load.a(0)) << n;
      const ContactSolution &found = one.solution, &expected = other.solution;
      EXPECT_LE((found.motion - expected.motion).norm(), 1e-8 * expected.motion.norm());
      EXPECT_LE((found.forces - expected.forces).norm(), 1e-7 * expected.forces.norm());
      EXPECT_NEAR(found.stability_margin, expected.stability_margin, 1e-2);
    }
}

/// The rim is an arc in the generated foot and a polygon in the file.
TEST(SolidFoot, AWrittenMeshGivesTheLoadOfTheGeneratedMesh)
{
  GlassProfile profile;
  profile.land_width = 0.002;
  const FootResolution resolution{ 16, 8, 1 };
  SolidSetup setup;
  setup.table.interface = std::make_shared<WinklerInterface>(1e9);
  std::vector<double> second_harmonics;
  for (const auto &[crown, tolerance] : { std::pair(0., 1e-4), std::pair(0.003, 3e-3) })
  {
    profile.crown_radius = crown;
    setup.profile = profile;
    dealii::Triangulation<3> written;
    make_foot_mesh(profile, resolution, written);
    move_to_crown(profile, written);
    std::ostringstream text;
    write_msh(written, text);
    const TemporaryFile file(text.str());

    SolidFoot generated(generate_solid_mesh(profile, resolution), setup);
    SolidFoot read(read_solid_mesh(file.name), setup);
    const auto expected_forces = generated.point_forces(generated.solve(load_at(1.3)));
    const auto forces = read.point_forces(read.solve(load_at(1.3)));
    if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) > 0)
      continue; // the forces are gathered on the first rank
    const ContactLoad expected = harmonics_of(expected_forces, 6);
    const ContactLoad load = harmonics_of(forces, 6);
    second_harmonics.push_back(load.a(2) / load.a(0));
    for (unsigned int n = 1; n <= 6; ++n)
    {
      EXPECT_NEAR(load.a(n) / load.a(0), expected.a(n) / expected.a(0), tolerance) << n;
      EXPECT_NEAR(load.b(n) / load.a(0), expected.b(n) / expected.a(0), tolerance) << n;
    }
  }
  if (second_harmonics.size() == 2) // on the first rank
  {
    EXPECT_GT(std::abs(second_harmonics[0] - second_harmonics[1]), 0.03);
  }
}

TEST(SolidFoot, ReportsItsDescriptionAndCapabilitiesAndRefusesASubstrate)
{
  const SolidMesh mesh = coarse_mesh();
  SolidFoot foot(mesh, coarse_setup(std::make_shared<WinklerInterface>()));
  EXPECT_EQ(foot.description().body, "solid");
  EXPECT_EQ(foot.description().n_contact_nodes, 60u); // 12 nodes around the rim, 5 across the land
  EXPECT_GT(foot.description().n_cells.value(), 12u * 4u);
  EXPECT_FALSE(foot.description().mesh_report);
  EXPECT_TRUE(foot.capabilities().is_collective);
  EXPECT_FALSE(foot.capabilities().friction_deforms);
  SolidSetup on_wood = coarse_setup(std::make_shared<HardInterface>());
  on_wood.table.substrate = Substrate();
  EXPECT_THROW(SolidFoot(mesh, on_wood), std::invalid_argument);
}

// Reference: body of revolution (Tilt.ReturnsTheFirstOfTwoBalances).
TEST(SolidFoot, ReturnsTheFirstOfTwoBalances)
{
  const auto mat = std::make_shared<WinklerInterface>(1e7);
  const double height = 0.5; // height of the centre of mass [m]
  const double second = 1.4; // moment ratio of the second balance
  const double scale = weight * GlassProfile().contact_radius / 2;
  const auto under_moment = [&](double m) { return ContactDemand(weight, 0, -m * scale); };
  RevolutionSetup revolved;
  revolved.table.interface = mat;
  MeshedRevolutionFoot oracle(revolved.resolved_for(weight));
  const double lean = std::abs(oracle.solve(under_moment(second)).solution.motion(1));
  ContactDemand demand = under_moment(second - weight * height * lean / scale);
  demand.tilt_moment = weight * height;
  const double expected = -oracle.solve(demand).load.moment().y() / scale;
  ASSERT_LT(expected, 1.2);
  // On a coarse mesh on one rank, LinearSolver::automatic selects the condensed solver.
  for (const LinearSolver solver : { LinearSolver::automatic, LinearSolver::multigrid })
  {
    SolidSetup setup;
    setup.table.interface = mat;
    setup.options.linear_solver = solver;
    SolidFoot foot(generate_solid_mesh(setup.profile, { 24, 2, 1 }), setup);
    EXPECT_NEAR(-foot.solve(demand).load.moment().y() / scale, expected, 1e-4);
    const ContactState start = foot.solve(under_moment(second));
    EXPECT_NEAR(-foot.solve(demand, {}, { &start }).load.moment().y() / scale, expected, 1e-4);
  }
}
