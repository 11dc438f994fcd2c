// The load of a wavy foot depends on its orientation relative to the moment.
#include "fem/revolution/meshed_revolution_foot.h"
#include "fem/solid/solid_foot.h"
#include "ring_model/load/constants.h"
#include "tests/fem/geometry/mesh_writers.h"
#include "tests/fem/reference_load.h"
#include "tests/fem/scratch_folder.h"

#include <deal.II/grid/tria.h>

#include <gtest/gtest.h>

using stemware::ring::pi;
using namespace stemware::fem_tests;
using stemware::test::TemporaryFile;

TEST(SolidFoot, AgreesWithAWavyBodyOfRevolutionAtThreeOrientations)
{
  const WavinessHarmonic lobes = { 3, 1e-6, 0.4 };
  const GlassProfile profile = flat_profile();
  // The mat is so stiff that the penetration is less than the amplitude of the waves.
  const auto mat = std::make_shared<WinklerInterface>(1e10);

  dealii::Triangulation<3> drawn;
  make_foot_mesh(profile, { 72, 2, 1 }, drawn);
  std::vector<bool> moved(drawn.n_vertices(), false);
  for (const auto &face : drawn.active_face_iterators())
    if (face->at_boundary() && face->boundary_id() == 2)
      for (const unsigned int v : face->vertex_indices())
        if (!moved[face->vertex_index(v)])
        {
          moved[face->vertex_index(v)] = true;
          dealii::Point<3> &x = face->vertex(v);
          x[2] += lobes.amplitude * std::cos(lobes.n * (std::atan2(x[1], x[0]) - lobes.azimuth));
        }
  const TemporaryFile file(gmsh_text(drawn));

  SolidSetup setup;
  setup.profile = profile;
  setup.table.interface = mat;
  setup.friction_coefficient = 0.3;
  SolidFoot solid(read_solid_mesh(file.name), setup);
  EXPECT_NEAR(solid.capabilities().glass_period, 2 * pi / 3, 1e-12);

  RevolutionSetup of_revolution;
  of_revolution.profile = profile;
  of_revolution.table.interface = mat;
  of_revolution.friction_coefficient = setup.friction_coefficient;
  of_revolution.imperfection.glass = { lobes };
  of_revolution.n_lines = 192;
  MeshedRevolutionFoot revolution(of_revolution.resolved_for(weight));

  double least = 1, largest = -1;
  for (const double angle : { 0., 0.7, 1.4 })
  {
    ContactDemand demand = load_at(0.9, 0.2);
    demand.n_harmonics = 8;
    const stemware::ring::Slip slip = { -20, { angle, 0 } };
    const ContactLoad load = solid.solve(demand, slip).load;
    const ContactLoad expected = revolution.solve(demand, slip).load;
    const double a_0 = expected.a(0);
    for (unsigned int n = 0; n <= 8; ++n)
    {
      EXPECT_NEAR(load.a(n) / a_0, expected.a(n) / a_0, 5e-3) << angle << " " << n;
      EXPECT_NEAR(load.b(n) / a_0, expected.b(n) / a_0, 5e-3) << angle << " " << n;
    }
    EXPECT_NEAR(load.mean_radius, expected.mean_radius, 1e-4 * profile.contact_radius);
    least = std::min(least, expected.a(2) / a_0);
    largest = std::max(largest, expected.a(2) / a_0);
  }
  EXPECT_GT(largest - least, 0.05);
}
