// Generates the three feet of this folder (described in README.md). The target `meshes` writes them.
#include "fem/geometry/foot_mesh.h"
#include "fem/geometry/mesh_io.h"

#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>

#include <fstream>
#include <iostream>

using namespace stemware::fem;
using Triangulation = dealii::Triangulation<3, 3>;

namespace
{

void write(const Triangulation &triangulation, const std::string &file_name)
{
  std::ofstream file(file_name);
  write_msh(triangulation, file);
  if (!file.flush())
    throw std::runtime_error("The mesh cannot be written to " + file_name + ".");
}

GlassProfile narrow_land(double crown_radius)
{
  GlassProfile profile;
  profile.land_width = 0.002;
  profile.crown_radius = crown_radius;
  return profile;
}

} // namespace

int main(int argc, char **argv)
{
  if (argc != 2)
  {
    std::cerr << "usage: make_meshes FOLDER\n";
    return 1;
  }
  const std::string folder = argv[1];

  Triangulation flat;
  make_foot_mesh(narrow_land(0), { 24, 4, 1 }, flat);
  write(flat, folder + "/flat_foot.msh");

  dealii::GridTools::transform(
    [](const dealii::Point<3> &x) { return dealii::Point<3>(x[0], 0.95 * x[1], x[2]); }, flat);
  write(flat, folder + "/oval_foot.msh");

  Triangulation crowned;
  const GlassProfile profile = narrow_land(0.003);
  make_foot_mesh(profile, { 24, 8, 1 }, crowned);
  move_to_crown(profile, crowned);
  write(crowned, folder + "/crowned_foot.msh");
}
