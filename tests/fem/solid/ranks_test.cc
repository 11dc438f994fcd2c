#include "fem/contact/foot.h"
#include "fem/contact/winkler_interface.h"
#include "fem/geometry/boundary_ids.h"
#include "fem/geometry/foot_mesh.h"
#include "fem/solid/nested_contact.h"
#include "tests/fem/reference_load.h"
#include "tests/fem/vtu_file.h"

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/grid/grid_generator.h>

#include <boost/serialization/map.hpp>
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <set>

using namespace stemware::fem_tests;

namespace
{

struct PressedFoot
{
  PressedFoot(MPI_Comm communicator, const FootResolution &resolution, unsigned int degree)
      : mesh(communicator)
  {
    const GlassProfile profile;
    make_foot_mesh(profile, resolution, mesh);
    SolidOptions options;
    options.degree = degree;
    options.linear_solver = LinearSolver::multigrid;
    body = std::make_unique<SolidBody>(
      mesh, ElasticMaterial(), [profile](double x, double y) { return profile.gap(std::hypot(x, y)); },
      options);
    body->set_sliding({ 0.2, -10, 0, {} });
    const WinklerInterface mat(1e11);
    const Resultants demand = load_at(1.3, 0.4);
    const std::optional<ContactStart> start =
      start_from_coarser_mesh(*body, mat, 1, demand, profile.contact_radius);
    EXPECT_EQ(start.has_value(), body->has_coarser_mesh());
    law = make_law(mat, body->contact_surface());
    solution = solve_contact(*body, *law, demand, profile.contact_radius, {}, start ? &*start : nullptr);
  }

  dealii::parallel::distributed::Triangulation<3> mesh;
  std::unique_ptr<SolidBody> body;
  std::unique_ptr<TableLaw> law;
  ContactSolution solution;
};

ContactLoad load_on(MPI_Comm communicator, const FootResolution &resolution, unsigned int degree)
{
  const PressedFoot foot(communicator, resolution, degree);
  return extract_load(*foot.law, foot.solution, 12);
}

/// Returns the files of all ranks of @p communicator on every rank. Expects that all names differ.
std::map<std::string, std::string> files_of(const std::vector<FieldFile> &own, MPI_Comm communicator)
{
  std::map<std::string, std::string> files;
  for (const FieldFile &file : own)
    files[file.name] = file.text;
  std::map<std::string, std::string> all;
  std::size_t n_files = 0;
  for (const auto &part : dealii::Utilities::MPI::all_gather(communicator, files))
  {
    all.insert(part.begin(), part.end());
    n_files += part.size();
  }
  EXPECT_EQ(all.size(), n_files);
  return all;
}

std::vector<std::string> quoted(const std::string &text, const std::string &attribute)
{
  std::vector<std::string> values;
  for (std::size_t at = text.find(attribute + "=\""); at != std::string::npos;
       at = text.find(attribute + "=\"", at + 1))
  {
    const std::size_t begin = at + attribute.size() + 2;
    values.push_back(text.substr(begin, text.find('"', begin) - begin));
  }
  std::sort(values.begin(), values.end());
  return values;
}

constexpr std::pair<const char *, std::size_t> shown_fields[] = { { "displacement", 3 },
                                                                  { "rigid_motion", 3 },
                                                                  { "stress", 9 },
                                                                  { "contact_pressure", 1 } };

/// Nodal fields of each cell. Key of the map: mean of the cell's nodes, in units of 10 nm.
using ShownCells = std::map<std::array<long, 3>, std::map<std::string, std::vector<double>>>;

/// Adds the cells of the VTU file @p text to @p cells. Expects that @p cells does not contain them.
void add_cells(const std::string &text, ShownCells &cells)
{
  const stemware::fem_tests::VtuFile file(text);
  const std::vector<double> &nodes = file.array("connectivity"), &ends = file.array("offsets");
  std::size_t begin = 0;
  for (const double end : ends)
  {
    std::array<double, 3> mean = {};
    std::map<std::string, std::vector<double>> values;
    for (std::size_t i = begin; i < static_cast<std::size_t>(end); ++i)
    {
      const auto node = static_cast<std::size_t>(nodes[i]);
      for (std::size_t d = 0; d < 3; ++d)
        mean[d] += file.array("points")[3 * node + d] / (end - static_cast<double>(begin));
      for (const auto &[name, n] : shown_fields)
        for (std::size_t component = 0; component < n; ++component)
          values[name].push_back(file.array(name)[n * node + component]);
    }
    begin = static_cast<std::size_t>(end);
    const auto place = [&](std::size_t d) { return std::lround(1e8 * mean[d]); };
    EXPECT_TRUE(cells.emplace(std::array<long, 3>{ place(0), place(1), place(2) }, values).second);
  }
}

void expect_the_same_on_all_ranks(const FootResolution &resolution, unsigned int degree)
{
  const ContactLoad load = load_on(MPI_COMM_WORLD, resolution, degree),
                    alone = load_on(MPI_COMM_SELF, resolution, degree);
  const double a_0 = alone.a(0);
  for (unsigned int n = 0; n <= 12; ++n)
  {
    EXPECT_NEAR(load.a(n) / a_0, alone.a(n) / a_0, 1e-9) << n;
    EXPECT_NEAR(load.b(n) / a_0, alone.b(n) / a_0, 1e-9) << n;
  }
  ASSERT_EQ(load.pointwise.size(), alone.pointwise.size());
  double largest = 0;
  for (std::size_t i = 0; i < load.pointwise.size(); ++i)
    largest = std::max(largest, std::abs(load.pointwise[i].value - alone.pointwise[i].value));
  EXPECT_LT(largest, 1e-9 * a_0);
}

} // namespace

TEST(Ranks, MultigridContactIsIndependentOfTheNumberOfRanks)
{
  expect_the_same_on_all_ranks({ 24, 2, 1, 1 }, 2);
}

TEST(Ranks, ContactWithoutCoarserMeshesIsIndependentOfTheNumberOfRanks)
{
  expect_the_same_on_all_ranks({ 24, 4, 2 }, 1);
}

TEST(Ranks, ContactSurfacesOfTheRanksAddUpToTheWholeSurface)
{
  const auto surface_on = [](MPI_Comm communicator)
  {
    const GlassProfile profile = flat_profile();
    dealii::parallel::distributed::Triangulation<3> mesh(communicator);
    make_foot_mesh(profile, { 24, 2, 1, 1, 1 }, mesh); // creates hanging nodes
    SolidOptions options;
    options.degree = 1;
    const SolidBody body(
      mesh, ElasticMaterial(), [](double, double) { return 0.; }, options);
    return body.contact_surface();
  };
  const ContactSurface part = surface_on(MPI_COMM_WORLD), whole = surface_on(MPI_COMM_SELF);
  EXPECT_EQ(part.parts.sum(part.lines.size()), whole.lines.size());
  EXPECT_EQ(part.n_global_nodes(), whole.n_nodes());
  EXPECT_NEAR(part.area() / whole.area(), 1, 1e-12);
  EXPECT_EQ(part.n_sectors, whole.n_sectors);
  const Eigen::VectorXd pressure = Eigen::VectorXd::Ones(part.n_nodes());
  EXPECT_EQ(part.n_nodes_across(pressure), whole.n_nodes_across(Eigen::VectorXd::Ones(whole.n_nodes())));

  std::set<unsigned int> reached;
  for (const ContactLine &line : part.lines)
    reached.insert(line.nodes.begin(), line.nodes.end());
  for (unsigned int i = part.n_owned_nodes(); i < part.n_nodes(); ++i)
    EXPECT_EQ(reached.count(i), 1u) << i;
  const bool is_shared = dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1;
  const double most = part.parts.max(static_cast<double>(part.lines.size()));
  EXPECT_EQ(most < static_cast<double>(whole.lines.size()), is_shared);
}

// Reference: file of a single rank, read without deal.II.
TEST(Ranks, FieldFilesContainEveryCellOnceWithTheFieldsOfASingleRank)
{
  const auto picture_on = [](MPI_Comm communicator)
  {
    const PressedFoot foot(communicator, { 24, 2, 1, 0, 1 }, 2); // creates hanging nodes
    return files_of(foot.body->fields(foot.solution.motion, foot.law->nodal_pressure(foot.solution)),
                    communicator);
  };
  const std::map<std::string, std::string> alone = picture_on(MPI_COMM_SELF);
  std::map<std::string, std::string> files = picture_on(MPI_COMM_WORLD);
  ASSERT_EQ(alone.size(), 1u);
  const unsigned int n_ranks = dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  std::vector<std::string> pieces;
  for (unsigned int rank = 0; rank < n_ranks; ++rank)
    pieces.push_back(n_ranks == 1 ? "contact.vtu" : "contact_" + std::to_string(rank) + ".vtu");
  if (n_ranks > 1)
  {
    const std::string record = files["contact.pvtu"];
    EXPECT_EQ(quoted(record, "Source"), pieces);
    EXPECT_EQ(record.find("<!--"), std::string::npos) << "a time stamp, which differs between equal runs";
    for (const auto &[name, n] : shown_fields)
      EXPECT_NE(record.find("Name=\"" + std::string(name) + "\""), std::string::npos) << name;
  }
  EXPECT_EQ(files.size(), pieces.size() + (n_ranks > 1));

  ShownCells whole, together;
  add_cells(alone.at("contact.vtu"), whole);
  for (const std::string &piece : pieces)
    add_cells(files.at(piece), together);
  ASSERT_EQ(together.size(), whole.size());
  for (const auto &[name, n] : shown_fields)
  {
    double largest = 0, difference = 0;
    for (const auto &[place, values] : whole)
    {
      ASSERT_EQ(together.count(place), 1u);
      const std::vector<double> &expected = values.at(name), &found = together.at(place).at(name);
      ASSERT_EQ(found.size(), expected.size());
      for (std::size_t i = 0; i < found.size(); ++i)
      {
        largest = std::max(largest, std::abs(expected[i]));
        difference = std::max(difference, std::abs(found[i] - expected[i]));
      }
    }
    EXPECT_GT(largest, 0) << name;
    EXPECT_LT(difference, 1e-6 * largest) << name;
  }
}

TEST(Ranks, RanksWithoutCellsWriteNoFile)
{
  dealii::parallel::distributed::Triangulation<3> mesh(MPI_COMM_WORLD);
  dealii::GridGenerator::hyper_cube(mesh, 0, 0.01);
  for (const auto &[face, id] :
       { std::pair(4u, FootBoundary::contact_zone), std::pair(5u, FootBoundary::stem_cut) })
    mesh.begin()->face(face)->set_boundary_id(static_cast<dealii::types::boundary_id>(id));
  SolidOptions options;
  options.degree = 1;
  const SolidBody body(
    mesh, ElasticMaterial(), [](double, double) { return 0.; }, options);
  const Eigen::VectorXd no_pressure = Eigen::VectorXd::Zero(body.contact_surface().n_nodes());
  const auto files = files_of(body.fields({ 0, 0, 0 }, no_pressure), MPI_COMM_WORLD);
  const unsigned int n_ranks = dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  ASSERT_EQ(files.size(), n_ranks > 1 ? 2u : 1u);
  const auto &[name, piece] = *files.rbegin(); // "contact.pvtu" comes before "contact_1.vtu"
  EXPECT_EQ(stemware::fem_tests::VtuFile(piece).n_cells(), 1u);
  if (n_ranks > 1)
  {
    EXPECT_EQ(quoted(files.at("contact.pvtu"), "Source"), std::vector<std::string>{ name });
  }
}
