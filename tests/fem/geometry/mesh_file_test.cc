#include "fem/meshing/mesh_io.h"
#include "tests/fem/foot_case.h"
#include "tests/fem/geometry/mesh_writers.h"
#include "tests/fem/temporary_file.h"

#include <deal.II/grid/grid_generator.h>

#include <gtest/gtest.h>

using namespace stemware::fem;
using namespace stemware::fem_tests;

namespace
{

const std::string meshes = STEMWARE_MESHES;

struct FileCase
{
  explicit FileCase(const std::string &name)
      : triangulation(MPI_COMM_WORLD)
      , report(read_foot_mesh(meshes + "/" + name, triangulation))
  {
    SolidOptions options;
    options.straight_edges = !report.round_rim;
    body = std::make_unique<SolidBody>(
      triangulation, ElasticMaterial(), [](double, double) { return 0.; }, options);
  }
  dealii::parallel::distributed::Triangulation<3> triangulation;
  MeshReport report;
  std::unique_ptr<SolidBody> body;
};

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

TEST(MeshFile, FlatFootGivesTheGeneratedFootsLoad)
{
  FileCase read("flat_foot.msh");
  EXPECT_TRUE(read.report.round_rim);
  EXPECT_NEAR(read.report.rim_radius, 0.03, 1e-9);
  EXPECT_EQ(read.report.land_area_deficit, 0);
  EXPECT_FALSE(read.body->contact_surface().is_crowned);
  EXPECT_TRUE(read.body->contact_surface().is_ring);
  const auto mat = make_law(WinklerInterface(1e10), read.body->contact_surface());
  const ContactSolution solution = solve_contact(*read.body, *mat, load_at(1.3), 0.03);
  const ContactLoad load = extract_load(*mat, solution, 6);
  const double expected[] = { 0.19373, -0.11626, 0.03004, 0.01830, -0.02628 };
  for (unsigned int n = 2; n <= 6; ++n)
    EXPECT_NEAR(load.a(n) / load.a(0), expected[n - 2], 2e-3) << "n = " << n;
}

TEST(MeshFile, CrownedFootsCrownIsInTheMesh)
{
  FileCase read("crowned_foot.msh");
  EXPECT_TRUE(read.report.round_rim);
  EXPECT_TRUE(read.body->contact_surface().is_crowned);
  const auto mat = make_law(WinklerInterface(1e9), read.body->contact_surface());
  const ContactSolution solution = solve_contact(*read.body, *mat, load_at(0.5), 0.03);
  const ContactLoad load = extract_load(*mat, solution, 6);
  // foot_contact.json, crown 0.003, k = 1e9: 0.0214667. The mesh's crown is a polygon whose sides stand 2.6
  // um off the arc, a tenth of the penetration; a flat land would give 0.
  EXPECT_NEAR(load.a(2) / load.a(0), 0.0214667, 3e-3);
}

TEST(MeshFile, OvalFootIsNoBodyOfRevolution)
{
  FileCase read("oval_foot.msh");
  EXPECT_FALSE(read.report.round_rim);
  EXPECT_GT(read.report.land_area_deficit, 1e-3);
  EXPECT_LT(read.report.land_area_deficit, 5e-2);
  const auto mat = make_law(WinklerInterface(1e10), read.body->contact_surface());
  const ContactSolution solution = solve_contact(*read.body, *mat, load_at(0.3), 0.03);
  const ContactLoad load = extract_load(*mat, solution, 6);
  EXPECT_GT(std::abs(load.a(2) / load.a(0)), 1e-3); // full contact, yet a second harmonic
  EXPECT_LT(solution.force_residual, 1e-9);
  EXPECT_LT(solution.moment_residual, 1e-9);
}

TEST(MeshFile, SaysWhatIsWrong)
{
  EXPECT_NE(message_of("no_such.msh").find("cannot be read"), std::string::npos);
  const TemporaryFile nonsense("this is not a mesh\n");
  EXPECT_NE(message_of(nonsense.name).find("not a Gmsh .msh mesh"), std::string::npos);
}

TEST(MeshFile, NamesMissingBoundaries)
{
  const std::string cube =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n8\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n"
    "5 0 0 1\n6 1 0 1\n7 1 1 1\n8 0 1 1\n$EndNodes\n$Elements\n";
  const std::string hexahedron = " 5 2 0 1 1 2 3 4 5 6 7 8\n";
  const TemporaryFile bare(cube + "1\n1" + hexahedron + "$EndElements\n");
  EXPECT_NE(message_of(bare.name).find("no contact zone"), std::string::npos);
  const TemporaryFile uncut(cube + "2\n1 3 2 2 1 1 2 3 4\n2" + hexahedron + "$EndElements\n");
  EXPECT_NE(message_of(uncut.name).find("no stem cut"), std::string::npos);
}

TEST(MeshFile, OfSecondOrderIsReadByItsCorners)
{
  dealii::Triangulation<3> drawn;
  make_foot_mesh(flat_profile(), { 24, 2, 1 }, drawn);
  dealii::Triangulation<3> first;
  const TemporaryFile of_first(gmsh_text(drawn));
  const MeshReport expected = read_foot_mesh(of_first.name, first);
  struct Written
  {
    const char *ending;
    std::string text;
  };
  for (const Written &written : { Written{ ".inp", abaqus_text(drawn, true) },
                                  { ".msh", gmsh_text_of_second_order(drawn, false) },
                                  { ".msh", gmsh_text_of_second_order(drawn, true) } })
  {
    SCOPED_TRACE(written.ending);
    const TemporaryFile file(written.text, written.ending);
    dealii::Triangulation<3> mesh;
    const MeshReport report = read_foot_mesh(file.name, mesh);
    EXPECT_EQ(report.n_cells, expected.n_cells);
    EXPECT_EQ(report.n_contact_faces, expected.n_contact_faces);
    EXPECT_TRUE(report.round_rim);
    EXPECT_EQ(mesh.n_used_vertices(), drawn.n_used_vertices());
    EXPECT_NEAR(dealii::GridTools::volume(mesh) / dealii::GridTools::volume(first), 1, 1e-14);
  }
}

TEST(MeshFile, OfSecondOrderIsRefusedWhereTheRimIsNotRound)
{
  dealii::Triangulation<3> drawn;
  make_foot_mesh(flat_profile(), { 24, 2, 1 }, drawn);
  dealii::Triangulation<3> oval;
  dealii::GridGenerator::flatten_triangulation(drawn, oval);
  oval.reset_all_manifolds();
  dealii::GridTools::transform(
    [](const dealii::Point<3> &x) { return dealii::Point<3>(x[0], 0.95 * x[1], x[2]); }, oval);
  const auto message_on = [&](bool second_order)
  { return message_of(TemporaryFile(abaqus_text(oval, second_order), ".inp").name); };
  EXPECT_EQ(message_on(false), "");
  EXPECT_NE(message_on(true).find("rim that is not round"), std::string::npos) << message_on(true);
}

/// The area that chords cut off follows from the angles between them; a plate has none but its corners.
TEST(MeshFile, StraightEdgesOfAPlateCutNothingOff)
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
