#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace stemware::fem
{

/// Reason why a mesh file is unreadable: the end of a sentence that begins with the file.
class UnreadableMesh : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Corners of the faces of a hexahedron, S1 to S6 of Abaqus, by their places in MeshContent::hexahedra.
constexpr unsigned int faces_of_hexahedron[6][4] = { { 0, 1, 2, 3 }, { 4, 7, 6, 5 }, { 0, 4, 5, 1 },
                                                     { 1, 5, 6, 2 }, { 2, 6, 7, 3 }, { 3, 7, 4, 0 } };

/// A face of the surface that the file marks.
struct MarkedFace
{
  std::array<unsigned int, 4> corners = {}; ///< indices of points, one after the other round the face
  unsigned int id = 0;                      ///< greater than 0
};

/// The hexahedra of a mesh file by their corners.
struct MeshContent
{
  std::vector<std::array<double, 3>> points;
  /// Indices of points: round the bottom, then round the top above them, as Gmsh, Abaqus and VTK have it.
  std::vector<std::array<unsigned int, 8>> hexahedra;
  std::vector<MarkedFace> faces;
  bool is_second_order = false; ///< the file has more nodes than corners
};

/// The parts of a text between blanks and line ends, one after the other.
class Words
{
public:
  explicit Words(std::string_view text)
      : rest(text)
  {
  }

  /// The next word; empty after the last.
  std::string_view next();

  /// Throws UnreadableMesh where the next word is missing or no number.
  double number();
  /// Throws UnreadableMesh where the next word is missing or no whole number.
  long whole_number();

private:
  std::string_view rest;
};

/// The number that makes up the whole of @p word.
std::optional<double> number_in(std::string_view word);
std::optional<long> whole_number_in(std::string_view word);

/// The id of a face, once it is known to be one: from 1 to 1000000000. Throws
/// UnreadableMesh.
unsigned int marked_id(long id);

/// Points of a file by the numbers that it gives them.
class NumberedPoints
{
public:
  /// Throws UnreadableMesh where the number was given before.
  void add(long number, const std::array<double, 3> &point);

  /// Index of a point; throws UnreadableMesh where no point has that number.
  unsigned int at(long number) const;

  std::vector<std::array<double, 3>> points;

private:
  std::unordered_map<long, unsigned int> index;
};

/// The corners of an element: the first @p n of its nodes.
template <std::size_t n>
std::array<unsigned int, n> corners_of(const NumberedPoints &points, const std::vector<long> &nodes)
{
  std::array<unsigned int, n> corners;
  for (std::size_t i = 0; i < n; ++i)
    corners[i] = points.at(nodes.at(i));
  return corners;
}

/// The content of a file in one of the formats of read_hexahedra(). Time and memory grow with the text, and
/// with nothing that stands in it. Throw UnreadableMesh.
MeshContent read_gmsh(const std::string &text);
MeshContent read_abaqus(const std::string &text);
MeshContent read_vtu(const std::string &text);

} // namespace stemware::fem
