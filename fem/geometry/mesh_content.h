#pragma once

#include "fem/geometry/triangulation.h"

#include <array>
#include <cstddef>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace stemware::fem
{

/// Exception for an unreadable mesh file; what() continues a sentence that begins with the file name.
class UnreadableMesh : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Command that converts any file that Gmsh reads to a supported format, physical groups included.
inline constexpr char gmsh_command[] = "`gmsh FILE -save -format msh22 -o x.msh`";

/// Instruction for a mesh of revolution whose cells collapse on the axis.
inline constexpr char wedge_advice[] =
  "recombine triangles (Mesh.RecombineAll); for a section revolved about the axis, put an O-grid under the "
  "stem or leave a hole there.";

/// Corners of the faces of a hexahedron, as indices in an entry of MeshContent::hexahedra.
constexpr unsigned int faces_of_hexahedron[6][4] = { { 0, 1, 2, 3 }, { 4, 7, 6, 5 }, { 0, 4, 5, 1 },
                                                     { 1, 5, 6, 2 }, { 2, 6, 7, 3 }, { 3, 7, 4, 0 } };

/// Surface face with an id in the file.
struct MarkedFace
{
  std::array<unsigned int, 4> corners = {}; ///< indices of points, one after the other round the face
  unsigned int id = 0;                      ///< greater than 0
};

/// Names of a file's faces by their ids, for messages.
using FaceNames = std::map<unsigned int, std::string>;

/// Hexahedra of a mesh file by their corners.
struct MeshContent
{
  std::vector<std::array<double, 3>> points;
  /// Indices of points: round the bottom, then round the top, as in Gmsh and VTK.
  std::vector<std::array<unsigned int, 8>> hexahedra;
  std::vector<MarkedFace> faces;
  bool is_second_order = false; ///< the file has more nodes than corners
  FaceNames names;
};

/// Returns at most @p max_length characters of UTF-8 @p text, with "?" for unprintable ones.
std::string printable(std::string_view text, std::size_t max_length = 30);

/// Reads the @p text of a file for read_hexahedra() in linear time and memory. Throws UnreadableMesh.
MeshContent read_gmsh(const std::string &text);

/// Reads the hexahedra of a Gmsh file (.msh, format 2 or 4, ASCII) and the physical ids of their faces into
/// @p triangulation. Of second-order hexahedra only the corners are kept. Coordinates are multiplied by
/// @p unit [m]. Returns the content of the file. Throws std::invalid_argument for any other or damaged file,
/// separate nodes at one position, and hanging nodes. Ignores inner faces, unused nodes and other sections.
MeshContent read_hexahedra(const std::string &file_name, double unit,
                           dealii::Triangulation<3, 3> &triangulation);

} // namespace stemware::fem
