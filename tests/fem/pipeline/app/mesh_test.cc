#include "ring_model/load/constants.h"
#include "tests/fem/pipeline/matchers.h"
#include "tests/fem/pipeline/program_runner.h"

#include <gtest/gtest.h>

#include <cmath>

namespace stemware::test
{
namespace
{

const std::string meshes = STEMWARE_MESHES;

} // namespace

TEST(MeshVerb, CheckReportsTheMeasuresOfAMeshAndWritesIt)
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
  // The land is a ring of 24 sides with the radii 29 mm and 31 mm, scaled by 0.95 along y.
  const auto &zone = found["contact_zone"];
  EXPECT_NEAR(zone["area"].get<double>(), 0.95 * 12 * std::sin(ring::pi / 12) * 0.002 * 0.06, 1e-14);
  EXPECT_NEAR(zone["radii"][0].get<double>(), 0.95 * 0.029, 1e-12);
  EXPECT_NEAR(zone["radii"][1].get<double>(), 0.031, 1e-12);
  EXPECT_NEAR(found["rim"]["radius"].get<double>(), (0.95 * 0.029 + 0.031) / 2, 1e-12);
  EXPECT_NEAR(found["box"]["upper"][1].get<double>(), 0.95 * 0.034, 1e-12);
  EXPECT_GT(found["scaled_jacobian"]["least"].get<double>(), 0.2);
}

TEST(MeshVerb, CheckUsesTheGivenUnitAndProposesTheFittingUnit)
{
  const ScratchFolder scratch;
  const std::vector<std::string> in_centimetres = { "mesh",   "--check", meshes + "/flat_foot.msh",
                                                    "--json", "--set",   "Contact/Mesh unit=cm" };
  const Ended alone = stemware(scratch, in_centimetres);
  EXPECT_EQ(alone.exit_code, 0) << alone.err;
  EXPECT_NEAR(nlohmann::json::parse(alone.out)["rim"]["radius"].get<double>(), 3e-4, 1e-11);
  std::vector<std::string> compared = in_centimetres;
  compared.insert(compared.begin() + 1, scratch.write("study.prm", plain_study()));
  const Ended refused = stemware(scratch, compared);
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.err, testing::HasSubstr("set Contact/Mesh unit = m,"));
}

} // namespace stemware::test
