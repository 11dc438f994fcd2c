#include "fem/geometry/mesh_formats.h"

#include <deal.II/grid/grid_in.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>

#include <boost/algorithm/string.hpp>
#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <cmath>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace stemware::fem
{

using namespace dealii;

namespace
{

/// The end of a sentence that begins with the file.
class Unreadable : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// What an exception of deal.II is about, as far as a user can mend it.
[[noreturn]] void explain(const std::exception &failure, const std::string &otherwise)
{
  if (std::string(failure.what()).find("negative volume") != std::string::npos)
    throw Unreadable("has some cells that are inside out beside others that are not; mesh it anew.");
  throw Unreadable(otherwise);
}

void read_gmsh(std::istream &file, Triangulation<3> &triangulation)
{
  const std::string otherwise = "is not a Gmsh .msh mesh of hexahedra of first order; export such hexahedra "
                                "(Mesh.RecombineAll, Mesh.ElementOrder = 1) in format 2 or 4.";
  try
  {
    GridIn<3>(triangulation).read_msh(file);
  }
  catch (const std::exception &failure)
  {
    explain(failure, otherwise);
  }
  if (!triangulation.all_reference_cells_are_hyper_cube())
    throw Unreadable(otherwise);
}

/// deal.II's reader knows linear hexahedra, and no other element by its name.
void require_abaqus_hexahedra(std::istream &file)
{
  bool has_nodes = false, has_elements = false;
  for (std::string line; std::getline(file, line);)
  {
    boost::to_upper(line);
    boost::erase_all(line, " ");
    has_nodes = has_nodes || boost::starts_with(line, "*NODE");
    if (!boost::starts_with(line, "*ELEMENT,"))
      continue;
    const std::size_t type = line.find("TYPE=");
    const std::string name =
      type == std::string::npos ? "" : line.substr(type + 5, line.find_first_of(",\r", type) - type - 5);
    if (!boost::starts_with(name, "C3D8"))
      throw Unreadable("has elements of the type " + name.substr(0, 20) +
                       "; export hexahedra of first order, C3D8.");
    has_elements = true;
  }
  if (!has_nodes || !has_elements)
    throw Unreadable("is not an Abaqus .inp mesh: it has no *NODE or no *ELEMENT; export hexahedra, C3D8.");
}

void read_abaqus(std::istream &file, Triangulation<3> &triangulation)
{
  require_abaqus_hexahedra(file);
  file.clear();
  file.seekg(0);
  std::streambuf *const printed = std::cerr.rdbuf(nullptr); // deal.II prints what it throws
  const auto show = [&] { std::cerr.rdbuf(printed); };
  try
  {
    GridIn<3>(triangulation).read_abaqus(file);
    show();
  }
  catch (const std::exception &failure)
  {
    show();
    explain(failure, "is not an Abaqus .inp mesh that can be read; export nodes, hexahedra C3D8 and element "
                     "surfaces whose names end in their ids.");
  }
}

/// Arrays of a VTU file by their names.
using Arrays = std::map<std::string, std::vector<double>>;

Arrays arrays_of(const boost::property_tree::ptree &parent)
{
  Arrays arrays;
  for (const auto &[key, node] : parent)
  {
    if (key != "DataArray")
      continue;
    if (node.get<std::string>("<xmlattr>.format", "") != "ascii")
      throw Unreadable(
        "is a binary .vtu; save it in ASCII (ParaView: Save Data, Data Mode Ascii), or as .msh.");
    std::vector<double> &values = arrays[node.get<std::string>("<xmlattr>.Name", "")];
    std::istringstream text(node.data());
    for (double value = 0; text >> value;)
      values.push_back(value);
    if (!text.eof())
      throw Unreadable("has an array in which not all entries are numbers; save it anew, in ASCII.");
  }
  return arrays;
}

/// A number of an array as an index below @p end.
unsigned int to_index(double value, std::size_t end)
{
  if (!(value >= 0 && value < static_cast<double>(end)))
    throw Unreadable("names a point or a place that it does not have; save it anew, in ASCII.");
  return static_cast<unsigned int>(value);
}

void read_vtu(std::istream &file, Triangulation<3> &triangulation)
{
  constexpr int quadrilateral = 9, hexahedron = 12;
  boost::property_tree::ptree tree;
  try
  {
    boost::property_tree::read_xml(file, tree);
    const auto &piece = tree.get_child("VTKFile.UnstructuredGrid.Piece");
    const Arrays points = arrays_of(piece.get_child("Points"));
    const Arrays topology = arrays_of(piece.get_child("Cells"));
    const Arrays data = piece.count("CellData") > 0 ? arrays_of(piece.get_child("CellData")) : Arrays();
    if (points.empty() || points.begin()->second.size() % 3 != 0)
      throw Unreadable("has points without three coordinates; save it anew, in ASCII.");
    std::vector<Point<3>> vertices;
    for (auto x = points.begin()->second.begin(); x != points.begin()->second.end(); x += 3)
      vertices.emplace_back(x[0], x[1], x[2]);
    const std::vector<double> &types = topology.at("types"), &ends = topology.at("offsets"),
                              &nodes = topology.at("connectivity");
    const auto ids = data.find("boundary_id");
    std::vector<CellData<3>> cells;
    SubCellData faces;
    for (std::size_t i = 0; i < types.size(); ++i)
    {
      const auto type = static_cast<int>(types[i]);
      if (type != hexahedron && type != quadrilateral)
        throw Unreadable(
          "has cells of VTK's type " + std::to_string(type) +
          "; save hexahedra of first order (12) and, for the ids of faces, quadrilaterals (9).");
      const unsigned int n = type == hexahedron ? 8 : 4;
      const unsigned int end = to_index(ends.at(i), nodes.size() + 1);
      const auto vertex = [&](unsigned int k)
      {
        // VTK goes round a face, deal.II along it.
        constexpr unsigned int order[] = { 0, 1, 3, 2, 4, 5, 7, 6 };
        return to_index(nodes.at(to_index(double(end) - n + order[k], nodes.size())), vertices.size());
      };
      if (type == hexahedron)
      {
        cells.emplace_back(8);
        for (unsigned int k = 0; k < 8; ++k)
          cells.back().vertices[k] = vertex(k);
        continue;
      }
      faces.boundary_quads.emplace_back(4);
      for (unsigned int k = 0; k < 4; ++k)
        faces.boundary_quads.back().vertices[k] = vertex(k);
      faces.boundary_quads.back().boundary_id =
        ids == data.end() ? 0 : to_index(ids->second.at(i), numbers::internal_face_boundary_id);
    }
    if (cells.empty())
      throw Unreadable("has no hexahedra; save hexahedra of first order.");
    GridTools::delete_unused_vertices(vertices, cells, faces);
    GridTools::invert_all_negative_measure_cells(vertices, cells);
    GridTools::consistently_order_cells(cells);
    triangulation.create_triangulation(vertices, cells, faces);
  }
  catch (const Unreadable &)
  {
    throw;
  }
  catch (const std::exception &failure)
  {
    explain(failure, "is not a .vtu mesh of hexahedra; save an unstructured grid of one piece in ASCII.");
  }
}

} // namespace

void read_hexahedra(const std::string &file_name, Triangulation<3> &triangulation)
{
  const std::map<std::string, void (*)(std::istream &, Triangulation<3> &)> readers = {
    { ".msh", read_gmsh }, { ".inp", read_abaqus }, { ".vtu", read_vtu }
  };
  const std::size_t dot = file_name.find_last_of('.');
  const auto reader =
    readers.find(dot == std::string::npos ? "" : boost::to_lower_copy(file_name.substr(dot)));
  const std::string subject = "Mesh file = " + file_name + " ";
  if (reader == readers.end())
    throw std::invalid_argument(subject + "is no mesh by its name; give a .msh, .inp or .vtu file.");
  std::ifstream file(file_name);
  if (!file)
    throw std::invalid_argument(subject + "cannot be read; give the path of a .msh, .inp or .vtu file.");
  if (file.peek() == std::ifstream::traits_type::eof())
    throw std::invalid_argument(subject + "is empty; export the mesh anew.");
  try
  {
    reader->second(file, triangulation);
  }
  catch (const Unreadable &reason)
  {
    throw std::invalid_argument(subject + reason.what());
  }
}

} // namespace stemware::fem
