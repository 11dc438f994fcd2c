#include "fem/geometry/foot_mesh.h"
#include "fem/geometry/mesh_io.h"
#include "tests/fem/geometry/mesh_writers.h"
#include "tests/fem/reference_load.h"
#include "tests/fem/scratch_folder.h"

#include <deal.II/grid/grid_generator.h>

#include <gtest/gtest.h>

using namespace stemware::fem;
using namespace stemware::fem_tests;
using stemware::test::TemporaryFile;

namespace
{

std::string message_of(const std::string &file_name)
{
  dealii::Triangulation<3> triangulation;
  try
  {
    read_foot_mesh(file_name, triangulation);
  }
  catch (const std::invalid_argument &error)
  {
    return error.what();
  }
  return "";
}

} // namespace

TEST(MeshFile, SecondOrderElementsAreReadAsFirstOrderElements)
{
  dealii::Triangulation<3> drawn;
  make_foot_mesh(flat_profile(), { 24, 2, 1 }, drawn);
  dealii::Triangulation<3> first;
  read_foot_mesh(TemporaryFile(gmsh_text(drawn)).name, first);
  for (const bool format_4 : { false, true })
  {
    SCOPED_TRACE(format_4);
    const TemporaryFile file(gmsh_text_of_second_order(drawn, format_4));
    dealii::Triangulation<3> mesh;
    const MeshReport report = read_foot_mesh(file.name, mesh);
    EXPECT_EQ(mesh.n_active_cells(), first.n_active_cells());
    EXPECT_TRUE(report.round_rim);
    EXPECT_EQ(mesh.n_used_vertices(), drawn.n_used_vertices());
    EXPECT_NEAR(dealii::GridTools::volume(mesh) / dealii::GridTools::volume(first), 1, 1e-14);
  }
}

TEST(MeshFile, RefusesAnOvalRimOnlyForSecondOrderElements)
{
  dealii::Triangulation<3> drawn;
  make_foot_mesh(flat_profile(), { 24, 2, 1 }, drawn);
  dealii::Triangulation<3> oval;
  dealii::GridGenerator::flatten_triangulation(drawn, oval);
  oval.reset_all_manifolds();
  dealii::GridTools::transform(
    [](const dealii::Point<3> &x) { return dealii::Point<3>(x[0], 0.95 * x[1], x[2]); }, oval);
  EXPECT_EQ(message_of(TemporaryFile(gmsh_text(oval)).name), "");
  const std::string message = message_of(TemporaryFile(gmsh_text_of_second_order(oval, false)).name);
  EXPECT_NE(message.find("not round"), std::string::npos) << message;
}

/// The area deficit is computed from the angles between the chords of a round rim. A plate has corners
/// between straight edges, but no deficit.
TEST(MeshFile, APlateHasNoRoundRimAndNoLandAreaDeficit)
{
  dealii::Triangulation<3> plate;
  dealii::GridGenerator::subdivided_hyper_rectangle(plate, { 8, 4, 1 }, dealii::Point<3>(-0.04, -0.02, 0),
                                                    dealii::Point<3>(0.04, 0.02, 0.005));
  for (const auto &face : plate.active_face_iterators())
    if (face->at_boundary() && std::abs(face->center()[0]) < 0.039 && std::abs(face->center()[1]) < 0.019)
      face->set_boundary_id(face->center()[2] < 1e-9 ? 2 : 1);
  dealii::Triangulation<3> mesh;
  const MeshReport report = read_foot_mesh(TemporaryFile(gmsh_text(plate)).name, mesh);
  EXPECT_FALSE(report.round_rim);
  EXPECT_EQ(report.land_area_deficit, 0);
}
