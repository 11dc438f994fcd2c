#pragma once

#include "fem/geometry/mesh_io.h"

#include <deal.II/grid/tria.h>

#include <iomanip>
#include <map>
#include <sstream>
#include <string>

namespace stemware::fem_tests
{

/// A mesh as other programs write it, from the formats' manuals: nodes counted from 1, hexahedra C3D8, and
/// for each boundary id an element surface SURFACE_<id>.
inline std::string abaqus_text(const dealii::Triangulation<3> &mesh)
{
  std::ostringstream text;
  text << std::setprecision(17) << "*HEADING\na foot\n*NODE\n";
  for (unsigned int v = 0; v < mesh.n_vertices(); ++v)
  {
    const dealii::Point<3> &x = mesh.get_vertices()[v];
    text << v + 1 << ", " << x[0] << ", " << x[1] << ", " << x[2] << '\n';
  }
  text << "*ELEMENT, TYPE=C3D8, ELSET=EB1\n";
  std::map<unsigned int, std::string> surfaces;
  // S1 ... S6 of Abaqus by deal.II's number of the face.
  constexpr unsigned int side[] = { 6, 4, 3, 5, 1, 2 };
  unsigned int n = 0;
  for (const auto &cell : mesh.active_cell_iterators())
  {
    text << ++n;
    for (const unsigned int v : { 0u, 1u, 3u, 2u, 4u, 5u, 7u, 6u })
      text << ", " << cell->vertex_index(v) + 1;
    text << '\n';
    for (const unsigned int f : cell->face_indices())
      if (cell->face(f)->at_boundary() && cell->face(f)->boundary_id() != 0)
        surfaces[cell->face(f)->boundary_id()] += std::to_string(n) + ", S" + std::to_string(side[f]) + '\n';
  }
  for (const auto &[id, members] : surfaces)
    text << "*SURFACE, TYPE=ELEMENT, NAME=SURFACE_" << id << '\n' << members;
  return text.str();
}

/// The same for VTK: hexahedra, and quadrilaterals where a face has an id.
inline std::string vtu_text(const dealii::Triangulation<3> &mesh)
{
  std::ostringstream points, connectivity, offsets, types, ids;
  points << std::setprecision(17);
  for (const dealii::Point<3> &x : mesh.get_vertices())
    points << x[0] << ' ' << x[1] << ' ' << x[2] << '\n';
  unsigned int end = 0, n_cells = 0;
  const auto add =
    [&](const auto &object, const std::initializer_list<unsigned int> &order, int type, unsigned int id)
  {
    for (const unsigned int v : order)
      connectivity << object->vertex_index(v) << ' ';
    end += static_cast<unsigned int>(order.size());
    offsets << end << ' ';
    types << type << ' ';
    ids << id << ' ';
    ++n_cells;
  };
  for (const auto &cell : mesh.active_cell_iterators())
    add(cell, { 0, 1, 3, 2, 4, 5, 7, 6 }, 12, 0);
  for (const auto &face : mesh.active_face_iterators())
    if (face->at_boundary() && face->boundary_id() != 0)
      add(face, { 0, 1, 3, 2 }, 9, face->boundary_id());
  const auto array = [](const std::string &type, const std::string &name, const std::string &values)
  {
    return "<DataArray type=\"" + type + "\" Name=\"" + name + "\" NumberOfComponents=\"" +
           (name == "points" ? "3" : "1") + "\" format=\"ascii\">\n" + values + "\n</DataArray>\n";
  };
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\">\n<UnstructuredGrid>\n"
         "<Piece NumberOfPoints=\"" +
         std::to_string(mesh.n_vertices()) + "\" NumberOfCells=\"" + std::to_string(n_cells) +
         "\">\n<Points>\n" + array("Float64", "points", points.str()) + "</Points>\n<Cells>\n" +
         array("Int64", "connectivity", connectivity.str()) + array("Int64", "offsets", offsets.str()) +
         array("UInt8", "types", types.str()) + "</Cells>\n<CellData>\n" +
         array("Int32", "boundary_id", ids.str()) +
         "</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

inline std::string gmsh_text(const dealii::Triangulation<3> &mesh)
{
  std::ostringstream text;
  fem::write_msh(mesh, text);
  return text.str();
}

/// The text of @p mesh in the format with this ending.
inline std::string mesh_text(const dealii::Triangulation<3> &mesh, const std::string &extension)
{
  return extension == ".inp" ? abaqus_text(mesh) : extension == ".vtu" ? vtu_text(mesh) : gmsh_text(mesh);
}

} // namespace stemware::fem_tests
