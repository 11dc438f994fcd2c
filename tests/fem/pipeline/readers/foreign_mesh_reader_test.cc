// Mesh files as other programs write them and as they break: the mesh, or at once the one sentence.
#include "fem/meshing/foot_mesh.h"
#include "fem/pipeline/feet/usable_mesh.h"
#include "fem/pipeline/input/study_size.h"
#include "fem/pipeline/support/failures.h"
#include "tests/fem/geometry/mesh_writers.h"
#include "tests/fem/pipeline/matchers.h"
#include "tests/fem/pipeline/refusal.h"
#include "tests/fem/temporary_file.h"

#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/replace.hpp>
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>

namespace stemware::pipeline
{
namespace
{

using fem_tests::TemporaryFile;
using Mesh = dealii::Triangulation<3, 3>;

void make_small_foot(Mesh &mesh)
{
  fem::make_foot_mesh(fem::GlassProfile(), { 12, 2, 1 }, mesh);
}

const std::string &written(const std::string &extension)
{
  static std::map<std::string, std::string> texts;
  if (texts.count(extension) == 0)
  {
    Mesh mesh;
    make_small_foot(mesh);
    texts[extension] = fem_tests::mesh_text(mesh, extension);
  }
  return texts[extension];
}

/// The sentence about a mesh file, empty where it is read; found in a second.
std::string mesh_refusal(const std::string &text, const std::string &extension)
{
  const TemporaryFile file(text, extension);
  const auto start = std::chrono::steady_clock::now();
  const std::string sentence = test::sentence_of(
    [&]
    {
      Mesh mesh;
      read_mesh_file(file.name, {}, mesh);
    });
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(2)) << sentence;
  return sentence;
}

void expect_refused(const std::string &text, const std::string &extension, const std::string &part)
{
  const std::string sentence = mesh_refusal(text, extension);
  EXPECT_THAT(sentence, testing::HasSubstr(part));
  EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
  EXPECT_LT(sentence.size(), 330u) << sentence;
}

/// Vertices, contact faces and volume are those of the mesh that was written, to the last digit that the file
/// has.
void expect_the_small_foot(const std::string &text, const std::string &extension)
{
  Mesh mesh, read;
  make_small_foot(mesh);
  const TemporaryFile file(text, extension);
  const fem::MeshReport report = read_mesh_file(file.name, {}, read);
  EXPECT_EQ(report.n_cells, mesh.n_active_cells());
  EXPECT_EQ(report.n_contact_faces, 24u);
  ASSERT_EQ(read.n_vertices(), mesh.n_vertices());
  for (unsigned int v = 0; v < mesh.n_vertices(); ++v)
    EXPECT_EQ(read.get_vertices()[v].distance(mesh.get_vertices()[v]), 0) << v;
  unsigned int n_stem = 0, n_stem_expected = 0;
  for (const auto &face : read.active_face_iterators())
    n_stem += face->at_boundary() && face->boundary_id() == 1;
  for (const auto &face : mesh.active_face_iterators())
    n_stem_expected += face->at_boundary() && face->boundary_id() == 1;
  EXPECT_EQ(n_stem, n_stem_expected);
}

/// The surfaces of the small foot's .inp by sets of elements: "n, S3" becomes the n of a set and a row of it.
std::string by_sets(const std::string &text, const std::string &set_line)
{
  const std::size_t begin = text.find("*SURFACE");
  std::string sets, surfaces;
  std::istringstream lines(text.substr(begin));
  std::map<std::string, std::string> members; // by the name of the set
  for (std::string line; std::getline(lines, line);)
  {
    const std::size_t comma = line.find(", S");
    if (line[0] == '*')
    {
      for (const auto &[name, numbers] : members)
        sets += set_line + name + "\n" + numbers;
      members.clear();
      surfaces += line + "\n";
      continue;
    }
    const std::string name = "_" + std::to_string(surfaces.size() > 100) + line.substr(comma + 2);
    if (members.count(name) == 0)
      surfaces += name + ", " + line.substr(comma + 2) + "\n";
    members[name] += line.substr(0, comma) + ",\n";
  }
  for (const auto &[name, numbers] : members)
    sets += set_line + name + "\n" + numbers;
  return text.substr(0, begin) + sets + surfaces;
}

TEST(AbaqusMesh, MayHaveWindowsLineEndsNoBlanksAndSmallLetters)
{
  const std::string plain = written(".inp"), with_sets = by_sets(plain, "*ELSET, ELSET=");
  for (std::string text : { plain, with_sets })
  {
    expect_the_small_foot(text, ".inp");
    expect_the_small_foot(boost::replace_all_copy(text, "\n", "\r\n"), ".inp");
    expect_the_small_foot("\xEF\xBB\xBF" + boost::replace_all_copy(text, ", ", ","), ".inp");
    expect_the_small_foot(boost::to_lower_copy(text), ".inp");
    expect_the_small_foot(boost::replace_all_copy(text, "*NODE", "**\n** by hand\n*NODE"), ".inp");
  }
}

TEST(AbaqusMesh, OfGmshWithSurfaceElementsIsReadByItsSets)
{
  Mesh mesh;
  make_small_foot(mesh);
  const std::string text = written(".inp");
  // As Gmsh writes them: elements of all surfaces, and below them the physical groups as sets.
  std::string elements, sets[2];
  unsigned int number = 100000;
  for (const auto &face : mesh.active_face_iterators())
    if (face->at_boundary() && face->boundary_id() != 0)
    {
      elements += std::to_string(++number);
      for (const unsigned int v : { 0u, 1u, 3u, 2u })
        elements += ", " + std::to_string(face->vertex_index(v) + 1);
      elements += "\n";
      sets[face->boundary_id() - 1] += std::to_string(number) + ",\n";
    }
  const std::string solid = text.substr(0, text.find("*SURFACE"));
  const std::string shells = "*ELEMENT, type=CPS4, ELSET=Surface7\n" + elements;
  const std::string groups =
    "*ELSET,ELSET=PhysicalSurface1\n" + sets[0] + "*ELSET,ELSET=PhysicalSurface2\n" + sets[1];
  const std::string lines = "*ELEMENT, type=T3D2, ELSET=Line1\n99999, 1, 2\n";
  expect_the_small_foot(solid + shells + groups, ".inp");
  expect_the_small_foot(solid + lines + shells + groups + "*ELSET,ELSET=all\nPhysicalSurface1\n", ".inp");
  // Without sets of their own the names of the blocks count, but for Gmsh's elementary surfaces.
  expect_refused(solid + shells, ".inp", "none of its faces has an id");
  expect_refused(solid + boost::replace_first_copy(shells, "Surface7", "shells_7"), ".inp",
                 "Contact/Mesh contact id = 7");
  const std::string named = boost::replace_all_copy(groups, "PhysicalSurface1", "stem");
  expect_refused(solid + shells + boost::replace_all_copy(named, "PhysicalSurface2", "foot"), ".inp",
                 "it has the names FOOT, STEM; end the names");
}

/// Part, instance and assembly of Abaqus/CAE: a reference point of the assembly is numbered from 1 again.
TEST(AbaqusMesh, OfCaeHasAPartInAnAssembly)
{
  const std::string with_sets = by_sets(written(".inp"), "*ELSET, ELSET=");
  const std::size_t begin = with_sets.find("*SURFACE");
  const std::string part = "*PART, NAME=Foot\n" + with_sets.substr(0, begin) + "*END PART\n",
                    surfaces = with_sets.substr(begin);
  const std::string assembly =
    "*ASSEMBLY, NAME=Assembly\n*INSTANCE, NAME=Foot-1, PART=Foot\n*END INSTANCE\n"
    "*NODE\n1, 0, 0, 0.08\n*ELEMENT, TYPE=MASS, ELSET=M\n1, 1\n*NSET, NSET=RP\n1\n";
  expect_the_small_foot(part + assembly + surfaces + "*END ASSEMBLY\n", ".inp");
  expect_the_small_foot(
    part + assembly + boost::replace_all_copy(surfaces, "\n_", "\nFoot-1._") + "*END ASSEMBLY\n", ".inp");
  expect_refused("*PART, NAME=Table\n*END PART\n" + part + assembly + surfaces, ".inp", "(TABLE, FOOT)");
}

TEST(AbaqusMesh, PointsLinesAndSpringsAreSkipped)
{
  std::string text = written(".inp");
  unsigned int number = 900000;
  for (const char *type :
       { "MASS", "ROTARYI", "SPRINGA", "SPRING1", "DASHPOTA", "CONN3D2", "T3D2", "B31", "DCOUP3D" })
    text += "*ELEMENT, TYPE=" + std::string(type) + ", ELSET=E_" + type + "\n" + std::to_string(++number) +
            ", 1, 2\n";
  expect_the_small_foot(text + "*ELSET, ELSET=axis\n900007\n", ".inp");
  expect_refused(boost::replace_first_copy(text, "C3D8", "DC3D8"), ".inp", "of the type DC3D8");
}

TEST(AbaqusMesh, NamesOfItsSurfacesAreSaid)
{
  std::string text = boost::replace_first_copy(written(".inp"), "SURFACE_1", "Stem");
  expect_refused(boost::replace_first_copy(text, "SURFACE_2", "Contact"), ".inp",
                 "it has the names STEM, CONTACT");
  expect_refused(text, ".inp", "no stem cut");
}

TEST(AbaqusMesh, SetsThatMakeNoSenseAreRefusedAtOnce)
{
  const std::string text = written(".inp") + "*SURFACE, TYPE=ELEMENT, NAME=MORE_3\nG, S1\n";
  expect_refused(text, ".inp", "names the set G");
  const auto with = [&](const std::string &set) { return text + set; };
  expect_refused(with("*ELSET, ELSET=G, GENERATE\n1, 10, 0\n"), ".inp", "\"1, 10, 0\"");
  expect_refused(with("*ELSET, ELSET=G, GENERATE\n1, 4000000000, 1\n"), ".inp", "1 to 4000000000");
  expect_refused(with("*ELSET, ELSET=G, GENERATE\n1, 99999999999999999999, 1\n"), ".inp", "cannot be read");
  expect_refused(with("*ELSET, ELSET=G\nG\n"), ".inp", "sets");
  std::string doubling; // 2^30 members
  for (int i = 1; i <= 30; ++i)
    doubling += "*ELSET, ELSET=G" + std::to_string(i) + "\nG" + std::to_string(i - 1) + "\nG" +
                std::to_string(i - 1) + "\n";
  expect_refused(with("*ELSET, ELSET=G0\n1\n" + doubling + "*ELSET, ELSET=G\nG15\n"), ".inp", "sets");
  expect_refused(with("*ELSET, ELSET=G\n1\n*SURFACE, TYPE=ELEMENT, NAME=X_4\nG, S7\n"), ".inp", "S1 to S6");
}

TEST(AbaqusMesh, WhatItDoesNotSayByItselfIsRefused)
{
  const std::string text = written(".inp");
  const auto replaced = [&](const std::string &from, const std::string &to)
  { return boost::replace_first_copy(text, from, to); };
  expect_refused(replaced("C3D8", "C3D20"), ".inp", "8 nodes instead of 20");
  expect_refused(replaced("C3D8", "C3D4"), ".inp", "of the type C3D4");
  expect_refused(replaced("*NODE", "*INCLUDE, INPUT=nodes.inp\n*NODE"), ".inp", "*INCLUDE");
  expect_refused(replaced("*NODE", "*NODE, INPUT=nodes.inp"), ".inp", "another file");
  expect_refused(replaced("*NODE", "*NODE, SYSTEM=C"), ".inp", "SYSTEM = C");
  expect_the_small_foot(replaced("*NODE", "*NODE, SYSTEM=R, NSET=ALL"), ".inp");
  expect_refused(text + "*NGEN\n1, 9, 1\n", ".inp", "*NGEN");
  expect_refused(text + "*INSTANCE, NAME=A\n0, 0, 1\n", ".inp", "*INSTANCE");
  expect_refused(text + "*NODE\n1, 0, 0, 0\n", ".inp", "two nodes of the number 1");
}

TEST(GmshMesh, CountsAndVersionsAreNotBelieved)
{
  const std::string text = written(".msh");
  expect_the_small_foot(text, ".msh");
  expect_the_small_foot(boost::replace_all_copy(text, "\n", "\r\n"), ".msh");
  for (const char *version : { "9.9", "3", "1", "4.2", "nan", "" })
    expect_refused(boost::replace_first_copy(text, "2.2 0", version + std::string(" 0")), ".msh", "format");
  expect_refused(boost::replace_first_copy(text, "2.2 0 8", "2.2 1 8"), ".msh", "is binary");
  expect_refused(boost::replace_first_copy(text, "$Nodes\n", "$Nodes\n9"), ".msh", "ends too early");
  expect_refused(boost::replace_first_copy(text, "$Elements\n", "$Elements\n20000000"), ".msh", "too early");
  const std::string head = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
  expect_refused(head + "$Nodes\n1 2000000000 1 2000000000\n3 1 0 2000000000\n$EndNodes\n"
                        "$Elements\n1 1 1 1\n3 1 5 2000000000\n$EndElements\n",
                 ".msh", "ends too early");
  expect_refused("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n1\n1 0 0 0\n$EndNodes\n$Elements\n1\n1 5 "
                 "2000000000 1\n$EndElements\n",
                 ".msh", "ends too early");
  expect_refused(boost::replace_first_copy(text, " 3 2 1 1 ", " 4 2 1 1 "), ".msh", "Gmsh's type 4");
}

TEST(GmshMesh, AFaceHasOneId)
{
  const std::string text = written(".msh");
  const std::size_t begin = text.find(" 3 2 1 1 ");
  const std::string nodes = text.substr(begin + 9, text.find('\n', begin) - begin - 9);
  const std::size_t count = text.find("$Elements\n") + 10;
  const std::string more = text.substr(0, count) + std::to_string(std::stoi(text.substr(count)) + 1) +
                           boost::replace_first_copy(text.substr(text.find('\n', count)), "$EndElements",
                                                     "999999 3 2 7 7 " + nodes + "\n$EndElements");
  expect_refused(more, ".msh", "the ids 1 and 7");
}

TEST(GmshMesh, OwnIdsAreNamedWithTheEntriesThatTakeThem)
{
  Mesh mesh;
  make_small_foot(mesh);
  for (const auto &face : mesh.active_face_iterators())
    if (face->at_boundary() && face->boundary_id() != 0)
      face->set_boundary_id(face->boundary_id() == 2 ? 7 : 5);
  const std::string names = "$EndMeshFormat\n$PhysicalNames\n3\n2 5 \"stem cut\"\n2 7 \"contact\"\n3 7 "
                            "\"glass\"\n$EndPhysicalNames\n";
  const std::string text =
    boost::replace_first_copy(fem_tests::mesh_text(mesh, ".msh"), "$EndMeshFormat\n", names);
  expect_refused(text, ".msh", "the ids 5 (stem cut), 7 (contact)");
  expect_refused(text, ".msh", "set Contact/Mesh contact id = 7");
  expect_refused(text, ".msh", "Contact/Mesh stem id = 5");
}

TEST(GmshMesh, PartitionsAndBinaryFilesAreRefusedWithTheLineThatConverts)
{
  Mesh mesh;
  make_small_foot(mesh);
  const std::string text = fem_tests::gmsh_text_of_second_order(mesh, true),
                    line = "gmsh FILE -save -format msh22";
  const std::string entities = "$PartitionedEntities\n2\n0\n0 0 0 0\n$EndPartitionedEntities\n$Nodes\n";
  expect_refused(boost::replace_first_copy(text, "$Nodes\n", entities), ".msh", "is partitioned");
  expect_refused(boost::replace_first_copy(text, "$Nodes\n", entities), ".msh", line);
  expect_refused(boost::replace_first_copy(text, "4.1 0", "4.1 1"), ".msh", line);
  expect_refused(boost::replace_first_copy(text, "4.1 0", "5.0 0"), ".msh", line);
}

TEST(AnyMesh, InAnotherFormatIsRefusedWithTheLineThatConverts)
{
  for (const char *extension : { ".vtu", ".unv", ".stl", "" })
  {
    expect_refused("any text", extension, "gmsh FILE -save -format msh22 -o x.msh");
    expect_refused("any text", extension, "meshio convert --ascii -o gmsh22 FILE x.msh");
  }
}

/// A file of 3 GB that takes no room on the disk. The limit of time is that of expect_refused().
TEST(AnyMesh, OfAnySizeIsBoundedBeforeItIsRead)
{
  for (const char *extension : { ".msh", ".inp" })
  {
    const TemporaryFile file("", extension);
    std::filesystem::resize_file(file.name, 3000000000);
    const auto start = std::chrono::steady_clock::now();
    const auto refusal = [&](double memory_limit) -> std::string
    {
      return test::sentence_of(
        [&]
        {
          Mesh mesh;
          read_mesh_file(file.name, {}, mesh, memory_limit);
        });
    };
    EXPECT_THAT(refusal(4e9), testing::HasSubstr("above 4 GB"));
    EXPECT_THAT(refusal(4e9), testing::HasSubstr("Contact/Memory limit ="));
    Study study;
    study.contact.body = BodyKind::solid;
    study.contact.mesh_file = file.name;
    EXPECT_THROW(require_affordable(study), BadInput);
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(1));
  }
}

TEST(AnyMesh, ThatIsNoBodyIsRefused)
{
  const std::string head = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n9\n1 0 0 0\n2 1 0 0\n3 1 1 0\n"
                           "4 0 1 0\n5 0 0 1\n6 1 0 1\n7 1 1 1\n8 0 1 1\n9 0 0 2\n$EndNodes\n$Elements\n";
  const auto mesh = [&](const std::string &elements, unsigned int n)
  { return head + std::to_string(n) + "\n" + elements + "$EndElements\n"; };
  expect_refused(mesh("1 5 2 0 0 1 2 3 4 5 6 7 7\n", 1), ".msh", "a corner twice");
  expect_refused(mesh("1 5 2 0 0 1 2 3 4 5 6 7 8\n2 5 2 0 0 1 2 3 4 5 6 7 8\n3 5 2 0 0 1 2 3 4 5 6 7 8\n", 3),
                 ".msh", "between three");
  expect_refused(mesh("1 3 2 1 1 1 2 3 9\n2 5 2 0 0 1 2 3 4 5 6 7 8\n", 2), ".msh", "not on the surface");
  expect_refused(mesh("1 5 2 0 0 1 2 3 4 5 6 7 10\n", 1), ".msh", "at node 10");
  expect_refused(boost::replace_first_copy(mesh("1 5 2 0 0 1 2 3 4 5 6 7 8\n", 1), "1 1 1", "nan 1 1"),
                 ".msh", "coordinates");
  expect_refused("\xFF\xFE$\0M\0", ".msh", "UTF-16");
}

} // namespace
} // namespace stemware::pipeline
