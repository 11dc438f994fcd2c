// What `mesh` prints of a mesh made by hand, whose numbers are all different.
#include "fem/pipeline/report/mesh_results.h"
#include "tests/fem/pipeline/report/hand_made_studies.h"

#include <gtest/gtest.h>

namespace stemware::pipeline
{
namespace
{

using namespace test;

TEST(MeshByHand, Summary)
{
  const nlohmann::ordered_json summary = mesh_summary(mesh_by_hand());
  EXPECT_EQ(summary["faces"].dump(), R"({"stem_cut":104,"contact_zone":105,"free":103,"other":106})");
  EXPECT_EQ(summary["contact_zone"].dump(),
            R"({"radii":[1.0701234567,1.0801234567],"heights":[1.0901234567,1.1001234567],)"
            R"("centre":[1.1201234567,1.1301234567],"area":1.1101234567})");
  EXPECT_EQ(summary["scaled_jacobian"]["mean"], 1.1501234567);
  EXPECT_EQ(summary["rim"].dump(),
            R"({"round":false,"radius":1.1901234567,"land_area_deficit":1.2001234567})");
  EXPECT_EQ(summary["remarks"].size(), 3u);
}

} // namespace
} // namespace stemware::pipeline
