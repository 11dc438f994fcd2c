// Writes the three feet of this folder (README.md says what they are): build the target `meshes` to write
// them anew.
#include "fem/foot_mesh.h"

#include <deal.II/grid/tria.h>

#include <array>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <iostream>

using namespace stemware::fem;
using Triangulation = dealii::Triangulation<3, 3>;

namespace
{

/// Writes Gmsh's format 2.2: linear hexahedra, and quadrilaterals for the faces of the contact zone and the
/// stem cut.
void write_msh(const Triangulation &triangulation, const std::string &file_name)
{
  std::ofstream file(file_name);
  file << std::setprecision(17) << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n"
       << triangulation.n_vertices() << '\n';
  for (unsigned int v = 0; v < triangulation.n_vertices(); ++v)
    file << v + 1 << ' ' << triangulation.get_vertices()[v] << '\n';
  file << "$EndNodes\n$Elements\n";

  std::ostringstream elements;
  unsigned int n_elements = 0;
  for (const auto &face : triangulation.active_face_iterators())
    if (face->at_boundary() && face->boundary_id() != 0)
    {
      elements << ++n_elements << " 3 2 " << face->boundary_id() << ' ' << face->boundary_id();
      for (const unsigned int v : { 0u, 1u, 3u, 2u })
        elements << ' ' << face->vertex_index(v) + 1;
      elements << '\n';
    }
  for (const auto &cell : triangulation.active_cell_iterators())
  {
    elements << ++n_elements << " 5 2 0 0";
    for (const unsigned int v : { 0u, 1u, 3u, 2u, 4u, 5u, 7u, 6u })
      elements << ' ' << cell->vertex_index(v) + 1;
    elements << '\n';
  }
  file << n_elements << '\n' << elements.str() << "$EndElements\n";
  if (!file.flush())
    throw std::runtime_error("The mesh cannot be written to " + file_name + ".");
}

/// Moves every vertex once.
template <typename Move>
void transform(Triangulation &triangulation, const Move &move)
{
  std::vector<bool> moved(triangulation.n_vertices(), false);
  for (const auto &cell : triangulation.active_cell_iterators())
    for (const unsigned int v : cell->vertex_indices())
      if (!moved[cell->vertex_index(v)])
      {
        moved[cell->vertex_index(v)] = true;
        move(cell->vertex(v));
      }
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
  write_msh(flat, folder + "/flat_foot.msh");

  transform(flat, [](dealii::Point<3> &x) { x[1] *= 0.95; });
  write_msh(flat, folder + "/oval_foot.msh");

  Triangulation crowned;
  const GlassProfile profile = narrow_land(0.003);
  make_foot_mesh(profile, { 24, 8, 1 }, crowned);
  transform(crowned,
            [&](dealii::Point<3> &x)
            {
              if (x[2] == 0)
                x[2] = profile.gap(std::hypot(x[0], x[1]));
            });
  write_msh(crowned, folder + "/crowned_foot.msh");
}
