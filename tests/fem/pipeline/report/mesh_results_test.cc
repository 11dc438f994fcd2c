// The results of `mesh` from a mesh made by hand, whose numbers are all different.
#include "fem/pipeline/report/mesh_results.h"
#include "tests/fem/pipeline/report/hand_made_studies.h"

#include <gtest/gtest.h>

namespace stemware::pipeline
{
namespace
{

using namespace test;

Results made_mesh()
{
  return tabulate(mesh_by_hand(), {}, { "a.msh" });
}

TEST(MeshByHand, Console)
{
  const Results results = made_mesh();
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
  EXPECT_EQ(results.report.answer,
            "The mesh can be used: 101 hexahedra whose scaled Jacobian is 0.057 at least, a contact "
            "zone of 1.11e+06 mm² between radii of 1070 and 1080 mm. The worst cell's scaled Jacobian "
            "is 0.0570062, below 0.1: stresses near it are poor. Faces with ids other than 1 and 2 are "
            "taken as free. The contact zone has a radius of 1.08012 m: is the mesh in metres?");
}

TEST(MeshByHand, Report)
{
  const Results results = made_mesh();
  EXPECT_EQ(report_lines(results, "What it is like", true), R"(Mesh | foot.msh, 101 hexahedra, 102 vertices
Box | x -1010.12 to 1040.12, y -1020.12 to 1050.12, z -1030.12 to 1060.12 (mm)
Faces | 104 stem cut (id 1), 105 contact zone (id 2), 103 free, 106 of other ids
Contact | r 1070.12 to 1080.12, z 1090.12 to 1100.12 (mm), area 1.11012e+06 mm²
Rim | not round, middle radius 1190.12 mm: straight edges cut off about 1.2e+02 % of the land
Quality | scaled Jacobian at least 0.057, near (1160, 1170, 1180) mm, 1.15 on average
Remark | The worst cell&#39;s scaled Jacobian is 0.0570062, below 0.1: stresses near it are poor.
Remark | Faces with ids other than 1 and 2 are taken as free.
Remark | The contact zone has a radius of 1.08012 m: is the mesh in metres?
)");
}

TEST(MeshByHand, Summary)
{
  const Results results = made_mesh();
  EXPECT_EQ(results.findings.key_figures.dump(1), R"({
 "written": [
  "a.msh"
 ],
 "mesh": "foot.msh",
 "cells": 101,
 "vertices": 102,
 "faces": {
  "stem_cut": 104,
  "contact_zone": 105,
  "free": 103,
  "other": 106
 },
 "box": {
  "lower": [
   -1.0101234567,
   -1.0201234567,
   -1.0301234567
  ],
  "upper": [
   1.0401234567,
   1.0501234567,
   1.0601234567
  ]
 },
 "contact_zone": {
  "radii": [
   1.0701234567,
   1.0801234567
  ],
  "heights": [
   1.0901234567,
   1.1001234567
  ],
  "centre": [
   1.1201234567,
   1.1301234567
  ],
  "area": 1.1101234567
 },
 "scaled_jacobian": {
  "least": 0.057006172835,
  "mean": 1.1501234567,
  "at": [
   1.1601234567,
   1.1701234567,
   1.1801234567
  ]
 },
 "remarks": [
  "The worst cell's scaled Jacobian is 0.0570062, below 0.1: stresses near it are poor.",
  "Faces with ids other than 1 and 2 are taken as free.",
  "The contact zone has a radius of 1.08012 m: is the mesh in metres?"
 ],
 "rim": {
  "round": false,
  "radius": 1.1901234567,
  "land_area_deficit": 1.2001234567
 }
})");
}

TEST(MeshByHand, SummaryHasTheKeyFiguresToo)
{
  const Results results = made_mesh();
  nlohmann::ordered_json summary = { { "written", { "a.msh" } } };
  summary.update(results.findings.summary["mesh"]);
  EXPECT_EQ(summary, results.findings.key_figures);
}

} // namespace
} // namespace stemware::pipeline
