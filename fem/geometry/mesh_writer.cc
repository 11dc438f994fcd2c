#include "fem/geometry/mesh_writer.h"

#include "fem/geometry/foot_mesh.h"
#include "fem/geometry/mesh_quality.h"

#include <deal.II/grid/tria.h>
#include <deal.II/numerics/data_out.h>

#include <array>
#include <cmath>
#include <iomanip>
#include <ostream>
#include <sstream>

namespace stemware::fem
{

using namespace dealii;

void move_to_crown(const GlassProfile &profile, Triangulation<3> &triangulation)
{
  std::vector<bool> moved(triangulation.n_vertices(), false);
  for (const auto &face : triangulation.active_face_iterators())
    if (face->at_boundary() &&
        face->boundary_id() == static_cast<types::boundary_id>(FootBoundary::contact_zone))
      for (const unsigned int v : face->vertex_indices())
        if (!moved[face->vertex_index(v)])
        {
          moved[face->vertex_index(v)] = true;
          Point<3> &x = face->vertex(v);
          x[2] += profile.gap(std::hypot(x[0], x[1]));
        }
}

void write_msh(const Triangulation<3> &triangulation, std::ostream &stream)
{
  stream << std::setprecision(17) << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n"
         << triangulation.n_vertices() << '\n';
  for (unsigned int v = 0; v < triangulation.n_vertices(); ++v)
    stream << v + 1 << ' ' << triangulation.get_vertices()[v] << '\n';
  stream << "$EndNodes\n$Elements\n";

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
  stream << n_elements << '\n' << elements.str() << "$EndElements\n";
}

void write_mesh_vtu(const Triangulation<3> &triangulation, std::ostream &stream)
{
  Vector<double> quality(triangulation.n_active_cells()), boundary(triangulation.n_active_cells());
  const std::vector<double> jacobians = scaled_jacobians(triangulation);
  std::copy(jacobians.begin(), jacobians.end(), quality.begin());
  for (const auto &cell : triangulation.active_cell_iterators())
    for (const auto &face : cell->face_iterators())
      if (face->at_boundary())
        boundary(cell->active_cell_index()) =
          std::max<double>(boundary(cell->active_cell_index()), face->boundary_id());
  DataOut<3> data_out;
  DataOutBase::VtkFlags flags;
  flags.print_date_and_time = false; // equal meshes give equal files
  data_out.set_flags(flags);
  data_out.attach_triangulation(triangulation);
  data_out.add_data_vector(quality, "scaled_jacobian");
  data_out.add_data_vector(boundary, "boundary_id");
  data_out.build_patches();
  data_out.write_vtu(stream);
}

} // namespace stemware::fem
