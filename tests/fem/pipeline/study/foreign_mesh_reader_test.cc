#include "fem/geometry/foot_mesh.h"
#include "fem/pipeline/base/failures.h"
#include "fem/pipeline/coupling/usable_mesh.h"
#include "fem/pipeline/study/study_size.h"
#include "tests/fem/geometry/mesh_writers.h"
#include "tests/fem/pipeline/matchers.h"
#include "tests/fem/pipeline/refusal.h"
#include "tests/fem/scratch_folder.h"

#include <deal.II/grid/grid_generator.h>

#include <boost/algorithm/string/join.hpp>
#include <boost/algorithm/string/replace.hpp>
#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <sstream>

namespace stemware::pipeline
{
namespace
{

using test::TemporaryFile;
using Mesh = dealii::Triangulation<3, 3>;

void make_small_foot(Mesh &mesh)
{
  fem::make_foot_mesh(fem::GlassProfile(), { 12, 2, 1 }, mesh);
}

std::string written()
{
  Mesh mesh;
  make_small_foot(mesh);
  return fem_tests::gmsh_text(mesh);
}

std::string mesh_refusal(const std::string &text, const std::string &extension)
{
  const TemporaryFile file(text, extension);
  return test::sentence_of(
    [&]
    {
      Mesh mesh;
      read_mesh_file(file.name, {}, mesh);
    });
}

void expect_refused(const std::string &text, const std::string &part, const std::string &extension = ".msh")
{
  const std::string sentence = mesh_refusal(text, extension);
  EXPECT_THAT(sentence, testing::HasSubstr(part));
  EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
  EXPECT_LT(sentence.size(), 330u) << sentence;
}

/// Expects that the mesh file @p text has exactly the vertices, contact faces and stem faces of
/// make_small_foot().
void expect_the_small_foot(const std::string &text)
{
  Mesh mesh, read;
  make_small_foot(mesh);
  const TemporaryFile file(text);
  read_mesh_file(file.name, {}, read);
  EXPECT_EQ(read.n_active_cells(), mesh.n_active_cells());
  ASSERT_EQ(read.n_vertices(), mesh.n_vertices());
  for (unsigned int v = 0; v < mesh.n_vertices(); ++v)
    EXPECT_EQ(read.get_vertices()[v].distance(mesh.get_vertices()[v]), 0) << v;
  const auto n_faces = [](const Mesh &marked, unsigned int id)
  {
    unsigned int n = 0;
    for (const auto &face : marked.active_face_iterators())
      n += face->at_boundary() && face->boundary_id() == id;
    return n;
  };
  EXPECT_EQ(n_faces(read, 1), n_faces(mesh, 1));
  EXPECT_EQ(n_faces(read, 2), 24u);
}

TEST(GmshMesh, ReadsFormat22AndRefusesBadVersionsCountsAndElements)
{
  const std::string text = written();
  expect_the_small_foot(text);
  expect_the_small_foot(boost::replace_all_copy(text, "\n", "\r\n"));
  for (const char *version : { "9.9", "3", "1", "4.2", "nan", "" })
    expect_refused(boost::replace_first_copy(text, "2.2 0", version + std::string(" 0")), "format");
  expect_refused(boost::replace_first_copy(text, "2.2 0 8", "2.2 1 8"), "is binary");
  expect_refused(boost::replace_first_copy(text, "$Nodes\n", "$Nodes\n9"), "ends too early");
  expect_refused(boost::replace_first_copy(text, "$Elements\n", "$Elements\n20000000"), "too early");
  const std::string head = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
  expect_refused(head + "$Nodes\n1 2000000000 1 2000000000\n3 1 0 2000000000\n$EndNodes\n"
                        "$Elements\n1 1 1 1\n3 1 5 2000000000\n$EndElements\n",
                 "ends too early");
  expect_refused("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n1\n1 0 0 0\n$EndNodes\n$Elements\n1\n1 5 "
                 "2000000000 1\n$EndElements\n",
                 "ends too early");
  expect_refused(boost::replace_first_copy(text, " 3 2 1 1 ", " 4 2 1 1 "), "Gmsh's type 4");
}

/// Returns @p text (Gmsh format 2.2) with additional @p elements, given without their numbers.
std::string with_elements(const std::string &text, const std::vector<std::string> &elements)
{
  const std::size_t count = text.find("$Elements\n") + 10;
  std::string more;
  for (std::size_t i = 0; i < elements.size(); ++i)
    more += std::to_string(900000 + i) + " " + elements[i] + "\n";
  return text.substr(0, count) + std::to_string(std::stoul(text.substr(count)) + elements.size()) +
         boost::replace_first_copy(text.substr(text.find('\n', count)), "$EndElements",
                                   more + "$EndElements");
}

std::string with_nodes(const std::string &text, const std::vector<std::string> &nodes)
{
  const std::size_t count = text.find("$Nodes\n") + 7;
  return text.substr(0, count) + std::to_string(std::stoul(text.substr(count)) + nodes.size()) +
         boost::replace_first_copy(text.substr(text.find('\n', count)), "$EndNodes",
                                   boost::join(nodes, "\n") + "\n$EndNodes");
}

TEST(GmshMesh, IgnoresUnusedSectionsSurfacesAndNodes)
{
  const std::string text = written();
  // Two unused nodes, one of them far away.
  expect_the_small_foot(with_nodes(text, { "900001 1e9 0 0", "900002 0 0 0.5" }));
  // Additional elements: a physical surface inside the body, a triangle, a line and a point.
  Mesh mesh;
  make_small_foot(mesh);
  std::string inner;
  for (const auto &face : mesh.active_face_iterators())
    if (!face->at_boundary())
    {
      inner = "3 2 7 7";
      for (const unsigned int v : { 0u, 1u, 3u, 2u })
        inner += " " + std::to_string(face->vertex_index(v) + 1);
    }
  expect_the_small_foot(with_elements(text, { inner, "2 2 9 9 1 2 3", "1 2 9 9 1 2", "15 2 9 9 1" }));
  // Additional sections $Periodic and $NodeData.
  expect_the_small_foot(text +
                        "$Periodic\n1\n2 1 2\n1\n1 2\n$EndPeriodic\n$NodeData\n1\n\"T\"\n1\n0.0\n3\n0\n1"
                        "\n1\n1 20\n$EndNodeData\n$NodeData\n$EndNodeData\n");
}

/// The Gmsh option Mesh.SaveParametric appends dimension, entity and parameters to the coordinates of a node.
TEST(GmshMesh, ReadsParametricNodes)
{
  std::istringstream lines(written());
  std::string text;
  bool is_node = false;
  unsigned int n = 0;
  for (std::string line; std::getline(lines, line);)
  {
    is_node = is_node && line != "$EndNodes";
    constexpr const char *parameters[] = { " 0 1", " 1 4 0.25", " 2 3 0.5 1", " 3 1" };
    text += line + (is_node && line.find(' ') != std::string::npos ? parameters[n++ % 4] : "") + "\n";
    is_node = is_node || line == "$Nodes";
  }
  boost::replace_all(text, "$Nodes", "$ParametricNodes");
  boost::replace_all(text, "$EndNodes", "$EndParametricNodes");
  expect_the_small_foot(text);
}

/// A mesh file has no constraints for hanging nodes, so refined cells would not be connected to coarser
/// neighbours.
TEST(GmshMesh, RefusesAMeshWithHangingNodes)
{
  Mesh mesh;
  dealii::GridGenerator::subdivided_hyper_rectangle(mesh, { 3, 3, 2 }, {}, { 3, 3, 2 });
  const auto refined = mesh.begin_active();
  std::set<unsigned int> corners, hanging;
  for (const unsigned int v : refined->vertex_indices())
    corners.insert(refined->vertex_index(v));
  refined->set_refine_flag();
  mesh.execute_coarsening_and_refinement();
  for (const auto &cell : mesh.active_cell_iterators())
    for (const unsigned int f : cell->face_indices())
      if (!cell->at_boundary(f) && cell->neighbor_is_coarser(f))
        for (const unsigned int v : cell->face(f)->vertex_indices())
          if (corners.count(cell->face(f)->vertex_index(v)) == 0)
            hanging.insert(cell->face(f)->vertex_index(v));
  expect_refused(fem_tests::gmsh_text(mesh),
                 "has " + std::to_string(hanging.size()) + " nodes in the middle");
  // On a curved rim, hanging nodes do not lie on the straight edges of the neighbours.
  mesh.clear();
  make_small_foot(mesh);
  mesh.begin_active()->set_refine_flag();
  mesh.execute_coarsening_and_refinement();
  expect_refused(fem_tests::gmsh_text(mesh), "nodes in the middle");
}

TEST(GmshMesh, RefusalOfWedgesAndCollapsedCellsNamesARemedy)
{
  expect_refused(with_elements(written(), { "6 2 0 0 1 2 3 4 5 6" }), "has wedges; recombine");
  expect_refused(with_elements(written(), { "6 2 0 0 1 2 3 4 5 6" }), "O-grid");
  expect_refused(with_elements(written(), { "5 2 0 0 1 2 3 3 4 5 6 6" }), "a corner twice; recombine");
}

TEST(GmshMesh, RefusesTwoIdsOfOneFace)
{
  const std::string text = written();
  const std::size_t begin = text.find(" 3 2 1 1 ");
  const std::string nodes = text.substr(begin + 9, text.find('\n', begin) - begin - 9);
  expect_refused(with_elements(text, { "3 2 7 7 " + nodes }), "the ids 1 and 7");
}

TEST(GmshMesh, NamesUnexpectedIdsAndTheEntriesToSet)
{
  Mesh mesh;
  make_small_foot(mesh);
  for (const auto &face : mesh.active_face_iterators())
    if (face->at_boundary() && face->boundary_id() != 0)
      face->set_boundary_id(face->boundary_id() == 2 ? 7 : 5);
  const std::string names =
    "$EndMeshFormat\n$PhysicalNames\n3\n2 5 \"Stiel – Ø 10 mm\"\n2 7 \"contact\"\n3 7 "
    "\"glass\"\n$EndPhysicalNames\n";
  const std::string text = boost::replace_first_copy(fem_tests::gmsh_text(mesh), "$EndMeshFormat\n", names);
  expect_refused(text, "the ids 5 (Stiel – Ø 10 mm), 7 (contact)");
  expect_refused(text, "set Contact/Mesh contact id = 7");
  expect_refused(text, "Contact/Mesh stem id = 5");
}

TEST(GmshMesh, RefusalOfPartitionedBinaryAndNewerFilesNamesACommand)
{
  Mesh mesh;
  make_small_foot(mesh);
  const std::string text = fem_tests::gmsh_text_of_second_order(mesh, true),
                    line = "gmsh FILE -save -format msh22";
  const std::string entities = "$PartitionedEntities\n2\n0\n0 0 0 0\n$EndPartitionedEntities\n$Nodes\n";
  expect_refused(boost::replace_first_copy(text, "$Nodes\n", entities), "is partitioned");
  expect_refused(boost::replace_first_copy(text, "$Nodes\n", entities), line);
  expect_refused(boost::replace_first_copy(text, "4.1 0", "4.1 1"), line);
  expect_refused(boost::replace_first_copy(text, "4.1 0", "5.0 0"), line);
}

TEST(AnyMesh, RefusalOfOtherFormatsNamesACommand)
{
  for (const char *extension : { ".inp", ".vtu", ".unv", ".stl", "" })
  {
    expect_refused("any text", "gmsh FILE -save -format msh22 -o x.msh", extension);
    expect_refused("any text", "meshio convert --ascii -o gmsh22 FILE x.msh", extension);
    expect_refused("any text", "Contact/Mesh contact height", extension);
  }
}

/// The file has 3 GB, but is sparse, i.e. needs no space on the disk.
TEST(AnyMesh, RefusesLargeFilesBeforeReading)
{
  const TemporaryFile file("");
  std::filesystem::resize_file(file.name, 3000000000);
  const std::string refusal = test::sentence_of(
    [&]
    {
      Mesh mesh;
      read_mesh_file(file.name, {}, mesh, 4e9);
    });
  EXPECT_THAT(refusal, testing::HasSubstr("above 4 GB"));
  EXPECT_THAT(refusal, testing::HasSubstr("Contact/Memory limit ="));
  Study study;
  study.contact.body = BodyKind::solid;
  study.contact.mesh_file = file.name;
  EXPECT_THROW(require_affordable(study), BadInput);
}

TEST(AnyMesh, RefusesInvalidCellsNodesAndEncodings)
{
  const std::string head = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n9\n1 0 0 0\n2 1 0 0\n3 1 1 0\n"
                           "4 0 1 0\n5 0 0 1\n6 1 0 1\n7 1 1 1\n8 0 1 1\n9 0 0 2\n$EndNodes\n$Elements\n";
  const auto mesh = [&](const std::string &elements, unsigned int n)
  { return head + std::to_string(n) + "\n" + elements + "$EndElements\n"; };
  expect_refused(mesh("1 5 2 0 0 1 2 3 4 5 6 7 7\n", 1), "a corner twice");
  expect_refused(mesh("1 5 2 0 0 1 2 3 4 5 6 7 8\n2 5 2 0 0 1 2 3 4 5 6 7 8\n3 5 2 0 0 1 2 3 4 5 6 7 8\n", 3),
                 "between three");
  expect_refused(mesh("1 3 2 1 1 1 2 3 9\n2 5 2 0 0 1 2 3 4 5 6 7 8\n", 2), "no face of its hexahedra");
  expect_refused(mesh("1 5 2 0 0 1 2 3 4 5 6 7 10\n", 1), "at node 10");
  expect_refused(boost::replace_first_copy(mesh("1 5 2 0 0 1 2 3 4 5 6 7 8\n", 1), "1 1 1", "nan 1 1"),
                 "coordinates");
  expect_refused("\xFF\xFE$\0M\0", "UTF-16");
}

} // namespace
} // namespace stemware::pipeline
