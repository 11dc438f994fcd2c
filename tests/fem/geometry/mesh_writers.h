#pragma once

#include "fem/geometry/mesh_io.h"

#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>
#include <deal.II/grid/tria_description.h>

#include <functional>
#include <iomanip>
#include <sstream>
#include <string>
#include <vector>

namespace stemware::fem_tests
{

inline std::vector<dealii::Point<3>> nodes_of(const dealii::Triangulation<3> &mesh, bool second_order)
{
  std::vector<dealii::Point<3>> nodes = mesh.get_vertices();
  if (!second_order)
    return nodes;
  nodes.resize(mesh.n_vertices() + mesh.n_lines());
  for (const auto &cell : mesh.active_cell_iterators())
    for (const unsigned int l : cell->line_indices())
      nodes[mesh.n_vertices() + cell->line_index(l)] = cell->line(l)->center();
  return nodes;
}

inline std::string gmsh_text(const dealii::Triangulation<3> &mesh)
{
  std::ostringstream text;
  fem::write_msh(mesh, text);
  return text.str();
}

/// Returns the text of a mesh file in Gmsh's format 2.2 or 4.1, with hexahedra and quadrilaterals of second
/// order (types 17 and 16).
inline std::string gmsh_text_of_second_order(const dealii::Triangulation<3> &mesh, bool format_4)
{
  const std::vector<dealii::Point<3>> nodes = nodes_of(mesh, true);
  std::ostringstream text;
  text << std::setprecision(17) << "$MeshFormat\n" << (format_4 ? "4.1" : "2.2") << " 0 8\n$EndMeshFormat\n";
  // Two surfaces with the physical ids 1 and 2, and one volume.
  if (format_4)
    text
      << "$Entities\n0 0 2 1\n1 0 0 0 1 1 1 1 1 0\n2 0 0 0 1 1 1 1 2 0\n1 0 0 0 1 1 1 1 0 0\n$EndEntities\n";
  text << "$Nodes\n";
  if (format_4)
    text << "1 " << nodes.size() << " 1 " << nodes.size() << "\n3 1 0 " << nodes.size() << '\n';
  else
    text << nodes.size() << '\n';
  for (std::size_t i = 1; format_4 && i <= nodes.size(); ++i)
    text << i << '\n';
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    if (!format_4)
      text << i + 1 << ' ';
    text << nodes[i] << '\n';
  }
  std::vector<std::string> quadrilaterals[2], hexahedra;
  const auto element =
    [&](const auto &object, const std::vector<unsigned int> &corners, const std::vector<unsigned int> &lines)
  {
    std::string numbers;
    for (const unsigned int v : corners)
      numbers += ' ' + std::to_string(object->vertex_index(v) + 1);
    for (const unsigned int l : lines)
      numbers += ' ' + std::to_string(mesh.n_vertices() + object->line_index(l) + 1);
    return numbers;
  };
  for (const auto &face : mesh.active_face_iterators())
    if (face->at_boundary() && face->boundary_id() != 0)
      quadrilaterals[face->boundary_id() - 1].push_back(element(face, { 0, 1, 3, 2 }, { 2, 1, 3, 0 }));
  for (const auto &cell : mesh.active_cell_iterators())
    hexahedra.push_back(element(cell, { 0, 1, 3, 2, 4, 5, 7, 6 }, { 2, 0, 8, 1, 9, 3, 11, 10, 6, 4, 5, 7 }));
  const std::size_t n = quadrilaterals[0].size() + quadrilaterals[1].size() + hexahedra.size();
  text << (format_4 ? "$EndNodes\n$Elements\n3 " : "$EndNodes\n$Elements\n") << n;
  text << (format_4 ? " 1 " + std::to_string(n) : "") << '\n';
  std::size_t number = 0;
  const auto add = [&](const std::vector<std::string> &elements, int dimension, int entity, int type, int id)
  {
    if (format_4)
      text << dimension << ' ' << entity << ' ' << type << ' ' << elements.size() << '\n';
    for (const std::string &nodes_of_element : elements)
    {
      text << ++number;
      if (!format_4)
        text << ' ' << type << " 2 " << id << " 1";
      text << nodes_of_element << '\n';
    }
  };
  add(quadrilaterals[0], 2, 1, 16, 1);
  add(quadrilaterals[1], 2, 2, 16, 2);
  add(hexahedra, 3, 1, 17, 0);
  text << "$EndElements\n";
  return text.str();
}

/// Copies @p mesh to @p split and separates the cells with is_second(centre): they get nodes of their own,
/// moved by @p shift.
inline void make_split(const dealii::Triangulation<3> &mesh,
                       const std::function<bool(const dealii::Point<3> &centre)> &is_second,
                       const dealii::Tensor<1, 3> &shift, dealii::Triangulation<3> &split)
{
  const unsigned int n = mesh.n_vertices();
  std::vector<dealii::Point<3>> points = mesh.get_vertices();
  for (unsigned int v = 0; v < n; ++v)
    points.push_back(points[v] + shift);
  std::vector<dealii::CellData<3>> cells;
  dealii::SubCellData faces;
  for (const auto &cell : mesh.active_cell_iterators())
  {
    const unsigned int first = is_second(cell->center()) ? n : 0;
    cells.emplace_back();
    for (const unsigned int v : cell->vertex_indices())
      cells.back().vertices[v] = first + cell->vertex_index(v);
    for (const auto &face : cell->face_iterators())
      if (face->at_boundary() && face->boundary_id() != 0)
      {
        faces.boundary_quads.emplace_back();
        for (const unsigned int v : face->vertex_indices())
          faces.boundary_quads.back().vertices[v] = first + face->vertex_index(v);
        faces.boundary_quads.back().boundary_id = face->boundary_id();
      }
  }
  dealii::GridTools::delete_unused_vertices(points, cells, faces);
  split.create_triangulation(points, cells, faces);
}

} // namespace stemware::fem_tests
