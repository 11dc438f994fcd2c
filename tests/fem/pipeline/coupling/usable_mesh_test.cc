#include "fem/geometry/foot_mesh.h"
#include "fem/pipeline/coupling/usable_mesh.h"
#include "tests/fem/geometry/mesh_writers.h"
#include "tests/fem/pipeline/mat_study.h"
#include "tests/fem/pipeline/matchers.h"
#include "tests/fem/pipeline/refusal.h"
#include "tests/fem/scratch_folder.h"

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

namespace stemware::pipeline
{
namespace
{

using fem_tests::gmsh_text;
using test::TemporaryFile;
using Mesh = dealii::Triangulation<3, 3>;

class ForeignMesh : public testing::Test
{
protected:
  void SetUp() override { fem::make_foot_mesh(Study().glass.profile, { 12, 2, 1 }, mesh); }

  void move(const std::function<dealii::Point<3>(const dealii::Point<3> &)> &change)
  {
    dealii::GridTools::transform(change, mesh);
  }
  std::string text() const { return gmsh_text(mesh); }

  /// Returns the message that refuses @p text as a mesh file; empty if the mesh is usable.
  static std::string sentence(const std::string &text, const fem::MeshFileOptions &marks = {})
  {
    const TemporaryFile file(text);
    Study study = test::mat_study();
    study.contact.mesh_file = file.name;
    study.contact.mesh_file_options = marks;
    const std::string message =
      test::sentence_of([&] { require_usable_mesh(study.contact, study.glass.profile.contact_radius); });
    EXPECT_THAT(message, testing::Not(testing::HasSubstr("\n")));
    EXPECT_LT(message.size(), 330u) << message;
    EXPECT_TRUE(message.empty() || message.back() == '.') << message;
    return message;
  }

  static void expect_sentence(const std::string &text, const std::string &part,
                              const fem::MeshFileOptions &marks = {})
  {
    const std::string found = sentence(text, marks);
    EXPECT_THAT(found, testing::HasSubstr(part));
  }

  Mesh mesh;
};

TEST_F(ForeignMesh, FindsContactZoneAndStemCutByIdOrHeightAndRefusesAMeshWithoutThem)
{
  for (const auto &face : mesh.active_face_iterators())
    if (face->at_boundary())
      face->set_boundary_id(face->boundary_id() == 2 ? 7 : face->boundary_id() == 1 ? 8 : 0);
  const std::string marked = text();
  expect_sentence(marked, "no contact zone");
  expect_sentence(marked, "7");
  expect_sentence(marked, "no stem cut", { 7, 3, 0 });
  EXPECT_EQ(sentence(marked, { 7, 8, 0 }), "");
  for (const auto &face : mesh.active_face_iterators())
    if (face->at_boundary())
      face->set_boundary_id(0);
  expect_sentence(text(), "none of its faces has an id");
  EXPECT_EQ(sentence(text(), { 2, 1, 1e-4 }), "");
}

TEST_F(ForeignMesh, RefusesInvertedCells)
{
  const dealii::Point<3> place = mesh.begin_active()->vertex(7);
  move([&](const dealii::Point<3> &x)
       { return x.distance(place) < 1e-9 ? dealii::Point<3>(x[0], x[1], x[2] - 0.02) : x; });
  expect_sentence(text(), "inverted");
}

TEST_F(ForeignMesh, AcceptsOnlyTheRightUnitAndSuggestsIt)
{
  move([](const dealii::Point<3> &x) { return dealii::Point<3>(1000 * x); });
  const std::string millimetres = text();
  expect_sentence(millimetres, "Contact/Mesh unit = mm");
  fem::MeshFileOptions marks;
  marks.unit = 1e-3;
  EXPECT_EQ(sentence(millimetres, marks), "");
  marks.unit = 0.0254;
  expect_sentence(millimetres, "Contact/Mesh unit = mm", marks);
  for (const auto &face : mesh.active_face_iterators())
    if (face->at_boundary())
      face->set_boundary_id(0);
  EXPECT_EQ(sentence(text(), { 2, 1, 1e-4, 1e-3 }), ""); // mesh in mm, contact height 1e-4 in m
}

TEST_F(ForeignMesh, RefusesAnUpsideDownFoot)
{
  move([](const dealii::Point<3> &x) { return dealii::Point<3>(x[0], -x[1], -x[2]); });
  expect_sentence(text(), "facing up");
  expect_sentence(text(), "rotate the mesh");
}

TEST_F(ForeignMesh, RefusesSwappedIdsUnlessTheEntriesAreSwapped)
{
  for (const auto &face : mesh.active_face_iterators())
    if (face->at_boundary() && face->boundary_id() != 0)
      face->set_boundary_id(3 - face->boundary_id());
  expect_sentence(text(), "; swap the ids (Contact/Mesh contact id = 1, Contact/Mesh stem id = 2)");
  EXPECT_EQ(sentence(text(), { 1, 2, 0 }), "");
}

TEST_F(ForeignMesh, RefusesAContactZoneThatFacesSideways)
{
  for (const auto &face : mesh.active_face_iterators())
    if (face->at_boundary() && face->boundary_id() != 1)
    {
      const dealii::Point<3> &x = face->center();
      face->set_boundary_id(std::hypot(x[0], x[1]) > 0.032 && std::abs(x[2] - 0.0017) < 0.0005 ? 2 : 0);
    }
  expect_sentence(text(), "100 % faces sideways");
}

/// An offset of 0.3 mm is refused. An offset of 0.02 mm is below the limit, a thousandth of the rim radius.
TEST_F(ForeignMesh, RefusesAnOffAxisMeshUnlessTheOffsetIsSmall)
{
  move([](const dealii::Point<3> &x) { return dealii::Point<3>(x[0] + 0.0003, x[1], x[2]); });
  expect_sentence(text(), "round (0.0003, 0) m; move the mesh by (-0.0003, 0) m");
  move([](const dealii::Point<3> &x) { return dealii::Point<3>(x[0] - 0.00028, x[1], x[2]); });
  EXPECT_EQ(sentence(text()), "");
}

TEST_F(ForeignMesh, RefusesCoincidentNodes)
{
  std::set<unsigned int> sides[2];
  for (const auto &cell : mesh.active_cell_iterators())
    for (const unsigned int v : cell->vertex_indices())
      sides[cell->center()[1] > 0].insert(cell->vertex_index(v));
  const auto n_shared =
    std::count_if(sides[0].begin(), sides[0].end(), [&](unsigned int v) { return sides[1].count(v) > 0; });
  Mesh halves;
  for (const double gap : { 0., 1e-13 })
  {
    fem_tests::make_split(
      mesh, [](const dealii::Point<3> &x) { return x[1] > 0; }, dealii::Point<3>(gap, gap, gap), halves);
    expect_sentence(gmsh_text(halves), "has " + std::to_string(n_shared) + " nodes that coincide");
    halves.clear();
  }
}

TEST_F(ForeignMesh, RefusesDisconnectedPieces)
{
  const auto is_outside = [](const dealii::Point<3> &x) { return std::hypot(x[0], x[1]) > 0.0305; };
  unsigned int n_outside = 0;
  for (const auto &cell : mesh.active_cell_iterators())
    n_outside += is_outside(cell->center());
  ASSERT_GT(n_outside, 0u);
  Mesh pieces;
  // Without the small lateral shift, nodes could lie on edges of the other piece (hanging nodes), which are
  // refused for another reason.
  fem_tests::make_split(mesh, is_outside, dealii::Point<3>(1e-6, 2e-6, 1e-3), pieces);
  expect_sentence(gmsh_text(pieces), "has " + std::to_string(n_outside) + " of " +
                                       std::to_string(mesh.n_active_cells()) + " cells");
}

TEST_F(ForeignMesh, RefusesSeveralContactZones)
{
  for (const auto &face : mesh.active_face_iterators())
    if (face->at_boundary() && face->boundary_id() == 2 && std::abs(face->center()[0]) < 0.01)
      face->set_boundary_id(0);
  expect_sentence(text(), "2 parts");
}

} // namespace
} // namespace stemware::pipeline
