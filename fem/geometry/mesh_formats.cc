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
[[noreturn]] void explain(const std::string &failure, const std::string &otherwise)
{
  if (failure.find("negative volume") != std::string::npos)
    throw Unreadable("has some cells that are inside out beside others that are not; mesh it anew.");
  throw Unreadable(otherwise);
}

/// An element of second order as the element of first order at its corners.
struct Corners
{
  int type; ///< of first order
  unsigned int n;
};

/// @p file with the corners of hexahedra, quadrilaterals and lines of second order in their place; @p
/// is_second says whether there is such a hexahedron. Binary files are left alone.
std::string corners_of_gmsh(std::istream &file, bool &is_second)
{
  const std::map<int, Corners> of_second_order = {
    { 8, { 1, 2 } }, { 10, { 3, 4 } }, { 16, { 3, 4 } }, { 12, { 5, 8 } }, { 17, { 5, 8 } }
  };
  std::ostringstream result;
  bool in_format = false, in_elements = false;
  double version = 0;
  unsigned int n_lines = 0; // of the elements' section
  unsigned int n_left = 0;  // elements of the block of format 4
  auto of_block = of_second_order.end();
  for (std::string line; std::getline(file, line); result << line << '\n')
  {
    if (boost::starts_with(line, "$"))
    {
      in_format = boost::starts_with(line, "$MeshFormat");
      in_elements = boost::starts_with(line, "$Elements");
      n_lines = 0;
      continue;
    }
    std::istringstream text(line);
    if (in_format)
      text >> version;
    if (!in_elements || ++n_lines == 1)
      continue;
    std::vector<long> numbers;
    for (long number = 0; text >> number;)
      numbers.push_back(number);
    const auto cut_to = [&](std::size_t n_numbers)
    {
      numbers.resize(std::min(numbers.size(), n_numbers));
      line.clear();
      for (const long number : numbers)
        line += std::to_string(number) + ' ';
    };
    if (version < 4 && numbers.size() > 2)
    {
      const auto corners = of_second_order.find(static_cast<int>(numbers[1]));
      if (corners == of_second_order.end())
        continue;
      numbers[1] = corners->second.type;
      is_second = is_second || corners->second.n == 8;
      cut_to(3 + static_cast<std::size_t>(numbers[2]) + corners->second.n);
    }
    else if (version >= 4 && n_left == 0 && numbers.size() == 4)
    {
      of_block = of_second_order.find(static_cast<int>(numbers[2]));
      n_left = static_cast<unsigned int>(numbers[3]);
      if (of_block == of_second_order.end())
        continue;
      numbers[2] = of_block->second.type;
      is_second = is_second || of_block->second.n == 8;
      cut_to(4);
    }
    else if (version >= 4 && n_left > 0)
    {
      --n_left;
      if (of_block != of_second_order.end())
        cut_to(1 + of_block->second.n);
    }
  }
  return result.str();
}

bool read_gmsh(std::istream &file, Triangulation<3> &triangulation)
{
  const std::string otherwise =
    "is not a Gmsh .msh mesh of hexahedra; export hexahedra (Mesh.RecombineAll) of "
    "first or second order in format 2 or 4, ASCII.";
  bool is_second = false;
  std::istringstream of_corners(corners_of_gmsh(file, is_second));
  try
  {
    GridIn<3>(triangulation).read_msh(of_corners);
  }
  catch (const std::exception &failure)
  {
    explain(failure.what(), otherwise);
  }
  if (!triangulation.all_reference_cells_are_hyper_cube())
    throw Unreadable(otherwise);
  return is_second;
}

/// @p file with C3D8 in place of C3D20 and C3D27; @p is_second says whether there are such. deal.II's reader
/// knows linear hexahedra, and no other element by its name.
std::string corners_of_abaqus(std::istream &file, bool &is_second)
{
  constexpr std::size_t n_corners = 8;
  std::ostringstream result;
  bool has_nodes = false, has_elements = false;
  std::size_t n_nodes = n_corners;  // of the elements that follow
  std::vector<std::string> numbers; // of an element that is not complete yet
  for (std::string line; std::getline(file, line);)
  {
    std::string words = boost::to_upper_copy(line);
    boost::erase_all(words, " ");
    if (boost::starts_with(words, "*"))
    {
      n_nodes = n_corners;
      has_nodes = has_nodes || boost::starts_with(words, "*NODE");
    }
    if (boost::starts_with(words, "*ELEMENT,"))
    {
      has_elements = true;
      const std::size_t type = words.find("TYPE=");
      const std::string name =
        type == std::string::npos ? "" : words.substr(type + 5, words.find_first_of(",\r", type) - type - 5);
      if (boost::starts_with(name, "C3D20") || boost::starts_with(name, "C3D27"))
      {
        n_nodes = boost::starts_with(name, "C3D20") ? 20 : 27;
        is_second = true;
        line = boost::replace_first_copy(words, name, "C3D8");
      }
      else if (!boost::starts_with(name, "C3D8"))
        throw Unreadable("has elements of the type " + name.substr(0, 20) +
                         "; export hexahedra: C3D8, C3D20 or C3D27.");
    }
    else if (n_nodes > n_corners && !boost::starts_with(words, "*"))
    {
      std::istringstream text(words);
      for (std::string number; std::getline(text, number, ',');)
        if (number.find_first_of("0123456789") != std::string::npos)
          numbers.push_back(number);
      if (numbers.size() <= n_nodes)
        continue;
      numbers.resize(1 + n_corners);
      line = boost::join(numbers, ", ");
      numbers.clear();
    }
    result << line << '\n';
  }
  if (!has_nodes || !has_elements)
    throw Unreadable("is not an Abaqus .inp mesh: it has no *NODE or no *ELEMENT; export hexahedra, C3D8.");
  return result.str();
}

bool read_abaqus(std::istream &file, Triangulation<3> &triangulation)
{
  bool is_second = false;
  std::istringstream of_corners(corners_of_abaqus(file, is_second));
  std::ostringstream printed; // deal.II prints the reason and throws another
  std::streambuf *const console = std::cerr.rdbuf(printed.rdbuf());
  const auto restore = [&] { std::cerr.rdbuf(console); };
  try
  {
    GridIn<3>(triangulation).read_abaqus(of_corners);
    restore();
  }
  catch (const std::exception &failure)
  {
    restore();
    explain(printed.str() + failure.what(),
            "is not an Abaqus .inp mesh that can be read; export nodes, hexahedra C3D8 and element "
            "surfaces whose names end in their ids.");
  }
  return is_second;
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

bool read_vtu(std::istream &file, Triangulation<3> &triangulation)
{
  // Number of nodes by type, corners first.
  const std::map<int, unsigned int> hexahedra = { { 12, 8 }, { 25, 20 }, { 29, 27 } },
                                    quadrilaterals = { { 9, 4 }, { 23, 8 }, { 28, 9 } };
  bool is_second = false;
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
      const bool is_hexahedron = hexahedra.count(type) > 0;
      if (!is_hexahedron && quadrilaterals.count(type) == 0)
        throw Unreadable(
          "has cells of VTK's type " + std::to_string(type) +
          "; save hexahedra (12, 25, 29) and, for the ids of faces, quadrilaterals (9, 23, 28).");
      const unsigned int n = is_hexahedron ? hexahedra.at(type) : quadrilaterals.at(type);
      is_second = is_second || (is_hexahedron && n > 8);
      const unsigned int end = to_index(ends.at(i), nodes.size() + 1);
      const auto vertex = [&](unsigned int k)
      {
        // VTK goes round a face, deal.II along it.
        constexpr unsigned int order[] = { 0, 1, 3, 2, 4, 5, 7, 6 };
        return to_index(nodes.at(to_index(double(end) - n + order[k], nodes.size())), vertices.size());
      };
      if (is_hexahedron)
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
      throw Unreadable("has no hexahedra; save hexahedra.");
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
    explain(failure.what(),
            "is not a .vtu mesh of hexahedra; save an unstructured grid of one piece in ASCII.");
  }
  return is_second;
}

} // namespace

bool read_hexahedra(const std::string &file_name, Triangulation<3> &triangulation)
{
  const std::map<std::string, bool (*)(std::istream &, Triangulation<3> &)> readers = {
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
    return reader->second(file, triangulation);
  }
  catch (const Unreadable &reason)
  {
    throw std::invalid_argument(subject + reason.what());
  }
}

} // namespace stemware::fem
