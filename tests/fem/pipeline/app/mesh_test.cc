// `stemware mesh`: what it writes can be read, and what cannot be used is refused.
#include "tests/fem/pipeline/matchers.h"
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <sstream>

namespace stemware::test
{
namespace
{

const std::string meshes = STEMWARE_MESHES;

using Vertex = std::array<double, 3>;

/// The mesh file with its vertices moved.
std::string moved(const std::string &mesh, const std::function<void(Vertex &)> &move)
{
  std::istringstream lines(mesh);
  std::ostringstream text;
  text.precision(17);
  std::string line;
  while (std::getline(lines, line) && line != "$Nodes")
    text << line << '\n';
  std::size_t n_vertices = 0, number = 0;
  lines >> n_vertices;
  text << "$Nodes\n" << n_vertices << '\n';
  for (std::size_t i = 0; i < n_vertices; ++i)
  {
    Vertex x;
    lines >> number >> x[0] >> x[1] >> x[2];
    move(x);
    text << number << ' ' << x[0] << ' ' << x[1] << ' ' << x[2] << '\n';
  }
  text << lines.rdbuf()->str().substr(static_cast<std::size_t>(lines.tellg()) + 1);
  return text.str();
}

/// What `mesh --check` says about a mesh that must not be used, and `run` too.
std::string refusal_of_mesh(const std::string &mesh)
{
  const ScratchFolder scratch;
  const std::string file = scratch.write("bad.msh", mesh);
  const Ended checked = stemware(scratch, { "mesh", "--check", file });
  EXPECT_EQ(checked.exit_code, 1) << checked.out;
  EXPECT_EQ(std::count(checked.err.begin(), checked.err.end(), '\n'), 1) << checked.err;
  const std::string study = scratch.write("study.prm", coarse_study());
  const Ended ended = stemware(scratch, { "run", study, "--set", "Contact/Mesh file=" + file });
  EXPECT_EQ(ended.exit_code, 1) << ended.out;
  EXPECT_EQ(ended.err, checked.err);
  EXPECT_EQ(names_in(scratch.path()), (std::vector<std::string>{ "bad.msh", "study.prm" }));
  return checked.err;
}

} // namespace

TEST(MeshVerb, CheckSaysWhatIsThere)
{
  const ScratchFolder scratch;
  const Ended ended = stemware(
    scratch, { "mesh", "--check", meshes + "/oval_foot.msh", "--write", "oval.vtu", "--json", "--quiet" });
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  const auto found = nlohmann::json::parse(ended.out);
  EXPECT_EQ(found["verb"], "mesh");
  EXPECT_EQ(found["written"], nlohmann::json::array({ "oval.vtu" }));
  EXPECT_TRUE(std::filesystem::exists(scratch / "oval.vtu"));
  EXPECT_EQ(found["faces"]["contact_zone"], 96);
  EXPECT_EQ(found["faces"]["stem_cut"], 12);
  EXPECT_EQ(found["rim"]["round"], false);
  EXPECT_NEAR(found["rim"]["land_area_deficit"].get<double>(), 0.0114, 5e-4);
  EXPECT_NEAR(found["box"]["upper"][1].get<double>(), 0.95 * 0.034, 1e-12);
  EXPECT_GT(found["scaled_jacobian"]["least"].get<double>(), 0.2);
}

TEST(MeshVerb, RefusesMeshesThatCannotBeUsed)
{
  const std::string flat = read_text(meshes + "/flat_foot.msh");
  EXPECT_THAT(refusal_of_mesh(moved(flat,
                                    [](Vertex &x) {
                                      x = { x[0], -x[1], -x[2] };
                                    })),
              testing::HasSubstr("facing up"));
  EXPECT_THAT(refusal_of_mesh("no mesh at all\n"), testing::HasSubstr("not a Gmsh .msh mesh"));
}

TEST(MeshVerb, ComparesAFileWithTheStudy)
{
  const ScratchFolder scratch;
  const std::string study = scratch.write("study.prm", plain_study());
  const std::string in_millimetres = scratch.write("mm.msh", moved(read_text(meshes + "/flat_foot.msh"),
                                                                   [](Vertex &x)
                                                                   {
                                                                     for (double &c : x)
                                                                       c *= 1000;
                                                                   }));
  const Ended alone = stemware(scratch, { "mesh", "--check", in_millimetres });
  EXPECT_EQ(alone.exit_code, 0);
  EXPECT_THAT(alone.out, testing::HasSubstr("is the mesh in metres?"));
  const Ended compared = stemware(scratch, { "mesh", study, "--check", in_millimetres });
  EXPECT_EQ(compared.exit_code, 1);
  EXPECT_THAT(compared.err, testing::HasSubstr("Contact/Mesh unit = mm"));
  const std::vector<std::string> in_unit = { "mesh",   "--check", in_millimetres,
                                             "--json", "--set",   "Contact/Mesh unit=mm" };
  const Ended scaled = stemware(scratch, in_unit);
  EXPECT_EQ(scaled.exit_code, 0) << scaled.err;
  EXPECT_NEAR(nlohmann::json::parse(scaled.out)["rim"]["radius"].get<double>(), 0.03, 1e-9);
}

TEST(MeshVerb, WithoutAStudyItIsTheDefaultStudysMesh)
{
  const ScratchFolder scratch;
  const std::string empty = scratch.write("empty.prm", "# defaults\n");
  const Ended alone = stemware(scratch, { "mesh", "--json", "--quiet" }),
              named = stemware(scratch, { "mesh", empty, "--json", "--quiet" });
  EXPECT_EQ(alone.exit_code, 0) << alone.err;
  EXPECT_EQ(alone.out, named.out);
  const std::vector<std::string> finer = { "mesh", "--json", "--quiet", "--set",
                                           "Contact/Azimuthal cells=32" };
  EXPECT_NE(stemware(scratch, finer).out, named.out);
}

TEST(MeshVerb, RefusesWhatItCannotDo)
{
  const ScratchFolder scratch;
  const std::string study = scratch.write("study.prm", plain_study());
  const auto refused = [&](const std::vector<std::string> &arguments, int exit_code, const std::string &why)
  {
    const Ended ended = stemware(scratch, arguments);
    EXPECT_EQ(ended.exit_code, exit_code);
    EXPECT_THAT(ended.err, testing::HasSubstr(why));
  };
  refused({ "mesh", study, "--write", "foot.stl" }, 1, "ends in neither .msh nor .vtu");
  refused({ "mesh", study, "--write", "no/such/folder/foot.msh" }, 3, "cannot be written");
  EXPECT_EQ(names_in(scratch.path()), std::vector<std::string>{ "study.prm" });
}

/// The cookbook's points are those of a crown of 3 mm at 30 mm, rounded to 0.1 um.
TEST(MeshOfAProfile, SaysTheCircleOfTheRim)
{
  const ScratchFolder scratch;
  const Ended ended = stemware(scratch, { "mesh", STEMWARE_COOKBOOKS "/own_profile.prm", "--json" });
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_THAT(ended.err,
              testing::HasSubstr("Profile   44 points; contact radius 0.03 m, crown radius 0.0030"));
  EXPECT_THAT(ended.err, testing::HasSubstr("from a circle through 9 points"));
}

} // namespace stemware::test
