#include "fem/geometry/mesh_content.h"
#include "fem/geometry/require.h"

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <algorithm>
#include <map>
#include <sstream>

namespace stemware::fem
{

namespace
{

using Tree = boost::property_tree::ptree;

[[noreturn]] void throw_binary()
{
  throw UnreadableMesh(
    "is a binary .vtu; save it in ASCII (ParaView: Save Data, Data Mode Ascii), or as .msh.");
}

/// Arrays of a VTU file by their names.
using Arrays = std::map<std::string, std::vector<double>>;

Arrays arrays_of(const Tree &parent)
{
  Arrays arrays;
  for (const auto &[key, node] : parent)
  {
    if (key != "DataArray")
      continue;
    if (node.get<std::string>("<xmlattr>.format", "") != "ascii")
      throw_binary();
    std::vector<double> &values = arrays[node.get<std::string>("<xmlattr>.Name", "")];
    Words words(node.data());
    for (std::string_view word = words.next(); !word.empty(); word = words.next())
    {
      const auto value = number_in(word);
      if (!value)
        throw UnreadableMesh("has an array in which not all entries are numbers; save it anew, in ASCII.");
      values.push_back(*value);
    }
  }
  return arrays;
}

/// A number of an array as an index below @p end.
unsigned int to_index(double value, std::size_t end)
{
  if (!(value >= 0 && value < static_cast<double>(end)))
    throw UnreadableMesh("names a point or a place that it does not have; save it anew, in ASCII.");
  return static_cast<unsigned int>(value);
}

/// The cells of one piece.
class VtuPiece
{
public:
  explicit VtuPiece(const Tree &piece)
  {
    const Arrays points = arrays_of(piece.get_child("Points"));
    const Arrays topology = arrays_of(piece.get_child("Cells"));
    const Arrays data = piece.count("CellData") > 0 ? arrays_of(piece.get_child("CellData")) : Arrays();
    if (points.empty() || points.begin()->second.size() % 3 != 0)
      throw UnreadableMesh("has points without three coordinates; save it anew, in ASCII.");
    for (auto x = points.begin()->second.begin(); x != points.begin()->second.end(); x += 3)
      content.points.push_back({ x[0], x[1], x[2] });
    nodes = topology.at("connectivity");
    const std::vector<double> &types = topology.at("types"), &ends = topology.at("offsets");
    const auto ids = data.find("boundary_id");
    for (std::size_t i = 0; i < types.size(); ++i)
      add_cell(types[i], ends.at(i), ids == data.end() ? 0 : ids->second.at(i));
    if (content.hexahedra.empty())
      throw UnreadableMesh("has no hexahedra; save hexahedra.");
  }

  MeshContent content;

private:
  void add_cell(double type, double end, double id)
  {
    static const std::map<double, ElementType> types = { { 12, { 8, 8 } },  { 25, { 20, 8 } },
                                                         { 29, { 27, 8 } }, { 9, { 4, 4 } },
                                                         { 23, { 8, 4 } },  { 28, { 9, 4 } } };
    const auto found = types.find(type);
    if (found == types.end())
      throw UnreadableMesh(
        sentence("has cells of VTK's type ", type,
                 "; save hexahedra (12, 25, 29) and, for the ids of faces, quadrilaterals (9, 23, 28)."));
    constexpr std::size_t end_of_ids = 1000000000;
    const std::size_t begin = to_index(end - found->second.n_nodes, nodes.size());
    content.add(found->second, found->second.n_corners == 4 ? to_index(id, end_of_ids) : 0,
                [&](unsigned int k) { return to_index(nodes.at(begin + k), content.points.size()); });
  }

  std::vector<double> nodes;
};

} // namespace

MeshContent read_vtu(const std::string &text)
{
  // Raw bytes are no XML.
  if (text.find("<AppendedData") != std::string::npos)
    throw_binary();
  // The parser of XML calls itself for every level.
  constexpr long most_tags = 2000;
  if (std::count(text.begin(), text.end(), '<') > most_tags)
    throw UnreadableMesh("has more than 2000 tags of XML; save one unstructured grid in ASCII.");
  Tree tree;
  try
  {
    std::istringstream stream(text);
    boost::property_tree::read_xml(stream, tree);
    const Tree &grid = tree.get_child("VTKFile.UnstructuredGrid");
    if (grid.count("Piece") > 1)
      throw UnreadableMesh("has " + std::to_string(grid.count("Piece")) +
                           " pieces; save it as one (ParaView: the filter Merge Blocks, or Clean to Grid).");
    return VtuPiece(grid.get_child("Piece")).content;
  }
  catch (const boost::property_tree::ptree_error &)
  {
  }
  catch (const std::out_of_range &)
  {
  }
  throw UnreadableMesh("is not a .vtu mesh of hexahedra; save an unstructured grid of one piece in ASCII.");
}

} // namespace stemware::fem
