// What `mesh` prints of a mesh made by hand, whose numbers are all different.
#include "fem/pipeline/report/mesh_results.h"
#include "tests/fem/pipeline/report/hand_made_studies.h"

#include <gtest/gtest.h>

namespace stemware::pipeline
{
namespace
{

using namespace test;

TEST(MeshByHand, Console)
{
  EXPECT_EQ(mesh_text(mesh_by_hand()), R"(Mesh      foot.msh, 101 hexahedra, 102 vertices
Box       x -1010.12 to 1040.12, y -1020.12 to 1050.12, z -1030.12 to 1060.12 (mm)
Faces     104 stem cut (id 1), 105 contact zone (id 2), 103 free, 106 of other ids
Contact   r 1070.12 to 1080.12, z 1090.12 to 1100.12 (mm), area 1.11012e+06 mm²
Rim       not round, middle radius 1190.12 mm: straight edges cut off about 1.2e+02 % of the land
Quality   scaled Jacobian at least 0.057, near (1160, 1170, 1180) mm, 1.15 on average
Remark    The worst cell's scaled Jacobian is 0.0570062, below 0.1: stresses near it are poor.
Remark    Faces with ids other than 1 and 2 are taken as free.
Remark    The contact zone has a radius of 1.08012 m: is the mesh in metres?
)");
}

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
