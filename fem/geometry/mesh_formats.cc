#include "fem/geometry/mesh_content.h"
#include "fem/geometry/require.h"
#include "ring_model/load/constants.h"

#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>
#include <deal.II/grid/tria_description.h>

#include <boost/algorithm/string/predicate.hpp>
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <set>

namespace stemware::fem
{

using namespace dealii;

namespace
{

std::array<unsigned int, 4> sorted(std::array<unsigned int, 4> corners)
{
  std::sort(corners.begin(), corners.end());
  return corners;
}

/// Throws UnreadableMesh if different nodes at cell corners coincide, so that the cells are not connected.
void require_shared_nodes(const MeshContent &content)
{
  std::vector<unsigned int> corners;
  for (const auto &hexahedron : content.hexahedra)
    corners.insert(corners.end(), hexahedron.begin(), hexahedron.end());
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  double size = 0;
  for (const unsigned int i : corners)
    for (const double coordinate : content.points[i])
      size = std::max(size, std::abs(coordinate));
  // The tolerance is far larger than rounding errors and far smaller than a cell. The offset keeps round
  // coordinates away from the borders of the bins.
  const double tolerance = 1e-7 * size, offset = 0.2137;
  std::vector<std::array<double, 4>> places; // coordinates in units of the tolerance, and the index
  for (const unsigned int i : corners)
  {
    places.push_back({ 0, 0, 0, static_cast<double>(i) });
    for (unsigned int d = 0; d < 3; ++d)
      places.back()[d] = std::floor(content.points[i][d] / tolerance + offset);
  }
  std::sort(places.begin(), places.end());
  std::size_t n_repeated = 0, first = 0;
  for (std::size_t i = 1; i < places.size(); ++i)
    if (std::equal(places[i].begin(), places[i].begin() + 3, places[i - 1].begin()))
      first = n_repeated++ == 0 ? i : first;
  if (n_repeated == 0)
    return;
  std::array<double, 3> x = content.points[static_cast<unsigned int>(places[first][3])];
  for (double &coordinate : x)
    coordinate = std::abs(coordinate) < tolerance ? 0 : coordinate;
  throw UnreadableMesh(
    sentence("has ", n_repeated, " nodes that coincide with others and are not shared, one at (", x[0], ", ",
             x[1], ", ", x[2],
             ") m; merge them (Gmsh: Coherence, or a larger Geometry.Tolerance), so that the "
             "foot is one body."));
}

using FaceCorners = std::array<unsigned int, 4>; // indices of points in cyclic order

/// Returns true if @p x lies on the bilinear @p face, within 1e-6 of its size.
bool lies_on(const std::array<Point<3>, 4> &face, const Point<3> &x)
{
  const double size = face[0].distance(face[2]) + face[1].distance(face[3]);
  const Tensor<1, 3> twist = (face[0] - face[1]) + (face[2] - face[3]);
  double s = 0.5, t = 0.5;
  Tensor<1, 3> distance;
  for (int step = 0; step < 8; ++step) // Newton's method for the closest point (s, t)
  {
    const Tensor<1, 3> along_s = (face[1] - face[0]) + t * twist, along_t = (face[3] - face[0]) + s * twist;
    distance = face[0] + s * (face[1] - face[0]) + t * (face[3] - face[0]) + s * t * twist - x;
    const double ss = along_s * along_s, st = along_s * along_t, tt = along_t * along_t,
                 determinant = ss * tt - st * st, a = along_s * distance, b = along_t * distance;
    if (!(determinant > 0))
      return false;
    s -= (tt * a - st * b) / determinant;
    t -= (ss * b - st * a) / determinant;
  }
  const auto is_inside = [](double value) { return value > -1e-6 && value < 1 + 1e-6; };
  return distance.norm() < 1e-6 * size && is_inside(s) && is_inside(t);
}

/// Nodes joined to each node by an edge.
using Neighbors = std::map<unsigned int, std::set<unsigned int>>;

/// Returns the hanging node of each edge on a curved surface, by the ends of the edge: mesh edges connect it
/// with both ends, at an angle of more than 150 degrees.
std::map<std::pair<unsigned int, unsigned int>, unsigned int>
middles_of_edges(const std::function<Point<3>(unsigned int)> &point, const Neighbors &neighbors)
{
  std::map<std::pair<unsigned int, unsigned int>, unsigned int> middles;
  for (const auto &[a, of_a] : neighbors)
    for (const unsigned int b : of_a)
      for (const unsigned int middle : neighbors.at(b))
        if (of_a.count(middle) > 0)
        {
          const Tensor<1, 3> to_a = point(a) - point(middle), to_b = point(b) - point(middle);
          if (to_a * to_b < std::cos(150 * ring::pi / 180) * to_a.norm() * to_b.norm())
            middles[std::minmax(a, b)] = middle;
        }
  return middles;
}

/// Throws UnreadableMesh if a node lies in the middle of an edge or face of @p surface (the faces with only
/// one cell): cells at such a hanging node look connected but are not.
void require_no_hanging_nodes(const std::vector<std::array<double, 3>> &points,
                              const std::vector<FaceCorners> &surface)
{
  namespace bg = boost::geometry;
  using Place = bg::model::point<double, 3, bg::cs::cartesian>;
  const auto point = [&](unsigned int i) { return Point<3>(points[i][0], points[i][1], points[i][2]); };
  Neighbors neighbors;
  for (const FaceCorners &face : surface)
    for (unsigned int k = 0; k < 4; ++k)
    {
      neighbors[face[k]].insert(face[(k + 1) % 4]);
      neighbors[face[(k + 1) % 4]].insert(face[k]);
    }
  const auto middles = middles_of_edges(point, neighbors);
  std::set<unsigned int> hanging;
  for (const auto &[edge, middle] : middles)
    hanging.insert(middle);
  std::vector<std::pair<Place, unsigned int>> places;
  for (const auto &[a, of_a] : neighbors)
    places.emplace_back(Place(points[a][0], points[a][1], points[a][2]), a);
  const bg::index::rtree<std::pair<Place, unsigned int>, bg::index::quadratic<16>> tree(places);
  for (const FaceCorners &face : surface)
  {
    // On a curved surface, the hanging node of a face is connected with the hanging nodes of the four edges.
    std::map<unsigned int, unsigned int> n_connections;
    for (unsigned int k = 0; k < 4; ++k)
      if (const auto middle = middles.find(std::minmax(face[k], face[(k + 1) % 4])); middle != middles.end())
        for (const unsigned int neighbor : neighbors[middle->second])
          if (++n_connections[neighbor] == 4)
            hanging.insert(neighbor);
    std::array<Point<3>, 4> corners;
    std::array<double, 3> lower = points[face[0]], upper = lower;
    for (unsigned int k = 0; k < 4; ++k)
    {
      corners[k] = point(face[k]);
      for (unsigned int d = 0; d < 3; ++d)
      {
        lower[d] = std::min(lower[d], corners[k][d]);
        upper[d] = std::max(upper[d], corners[k][d]);
      }
    }
    const double margin = 1e-6 * corners[0].distance(corners[2]);
    const bg::model::box<Place> box(Place(lower[0] - margin, lower[1] - margin, lower[2] - margin),
                                    Place(upper[0] + margin, upper[1] + margin, upper[2] + margin));
    for (auto found = tree.qbegin(bg::index::intersects(box)); found != tree.qend(); ++found)
      if (std::find(face.begin(), face.end(), found->second) == face.end() &&
          lies_on(corners, point(found->second)))
        hanging.insert(found->second);
  }
  if (hanging.empty())
    return;
  const Point<3> x = point(*hanging.begin());
  throw UnreadableMesh(sentence("has ", hanging.size(),
                                " nodes in the middle of edges or faces of cells that do not have them, one "
                                "at (",
                                x[0], ", ", x[1], ", ", x[2],
                                ") m; cells at such nodes only seem to be joined: divide neighbouring cells "
                                "alike."));
}

/// Throws UnreadableMesh if a coordinate is not finite, a cell is not a hexahedron, or more than two cells
/// share a face, which deal.II does not check. Removes marked faces inside the body.
void require_mesh(MeshContent &content)
{
  if (content.hexahedra.empty())
    throw UnreadableMesh("has no hexahedra; mesh the foot in hexahedra (Gmsh: Mesh.RecombineAll, "
                         "Mesh.SubdivisionAlgorithm = 2).");
  for (const auto &hexahedron : content.hexahedra)
    for (const unsigned int corner : hexahedron)
      for (const double coordinate : content.points[corner])
        if (!(std::abs(coordinate) < 1e6))
          throw UnreadableMesh("has coordinates outside the range of a foot; export the mesh again.");
  std::vector<std::array<unsigned int, 4>> faces;
  faces.reserve(6 * content.hexahedra.size());
  for (std::array<unsigned int, 8> corners : content.hexahedra)
  {
    for (const auto &face : faces_of_hexahedron)
      faces.push_back(sorted({ corners[face[0]], corners[face[1]], corners[face[2]], corners[face[3]] }));
    std::sort(corners.begin(), corners.end());
    if (std::adjacent_find(corners.begin(), corners.end()) != corners.end())
      throw UnreadableMesh(std::string("has a hexahedron that has a corner twice; ") + wedge_advice);
  }
  require_shared_nodes(content);
  std::sort(faces.begin(), faces.end());
  for (std::size_t i = 2; i < faces.size(); ++i)
    if (faces[i] == faces[i - 2])
      throw UnreadableMesh("has a face between three hexahedra; export the mesh anew.");
  const auto n_cells = [&](const std::array<unsigned int, 4> &corners)
  {
    const auto [begin, end] = std::equal_range(faces.begin(), faces.end(), sorted(corners));
    return end - begin;
  };
  for (const MarkedFace &face : content.faces)
    if (n_cells(face.corners) == 0)
      throw UnreadableMesh("marks a face that is no face of its hexahedra with the id " +
                           std::to_string(face.id) + "; export the mesh anew.");
  content.faces.erase(std::remove_if(content.faces.begin(), content.faces.end(),
                                     [&](const MarkedFace &face) { return n_cells(face.corners) == 2; }),
                      content.faces.end());
  std::vector<FaceCorners> surface;
  for (const auto &corners : content.hexahedra)
    for (const auto &face : faces_of_hexahedron)
      if (const FaceCorners one = { corners[face[0]], corners[face[1]], corners[face[2]], corners[face[3]] };
          n_cells(one) == 1)
        surface.push_back(one);
  require_no_hanging_nodes(content.points, surface);
}

/// Returns the marked faces by their sorted corners. Throws UnreadableMesh if a face has two ids.
std::map<std::array<unsigned int, 4>, MarkedFace> once(const std::vector<MarkedFace> &faces)
{
  std::map<std::array<unsigned int, 4>, MarkedFace> marked;
  for (const MarkedFace &face : faces)
    if (const unsigned int id = marked.emplace(sorted(face.corners), face).first->second.id; id != face.id)
      throw UnreadableMesh("marks a face with the ids " + std::to_string(std::min(id, face.id)) + " and " +
                           std::to_string(std::max(id, face.id)) + "; give each face one id.");
  return marked;
}

void build(MeshContent &content, Triangulation<3> &triangulation)
{
  // Mesh files number the corners of a face cyclically, deal.II lexicographically.
  constexpr unsigned int order[] = { 0, 1, 3, 2, 4, 5, 7, 6 };
  require_mesh(content);
  std::vector<Point<3>> points;
  for (const auto &x : content.points)
    points.emplace_back(x[0], x[1], x[2]);
  std::vector<CellData<3>> cells;
  for (const auto &corners : content.hexahedra)
  {
    cells.emplace_back(8);
    for (unsigned int k = 0; k < 8; ++k)
      cells.back().vertices[k] = corners[order[k]];
  }
  SubCellData faces;
  for (const auto &[corners, face] : once(content.faces))
  {
    faces.boundary_quads.emplace_back(4);
    for (unsigned int k = 0; k < 4; ++k)
      faces.boundary_quads.back().vertices[k] = face.corners[order[k]];
    faces.boundary_quads.back().boundary_id = face.id;
  }
  try
  {
    GridTools::delete_unused_vertices(points, cells, faces);
    GridTools::invert_all_negative_measure_cells(points, cells);
    GridTools::consistently_order_cells(cells);
    triangulation.create_triangulation(points, cells, faces);
  }
  catch (const std::exception &failure)
  {
    if (std::string(failure.what()).find("negative volume") != std::string::npos)
      throw UnreadableMesh("has inverted cells; mesh the foot again.");
    throw UnreadableMesh("has hexahedra that do not form a mesh of a body; mesh the foot again.");
  }
}

/// Returns the content of the file without a byte order mark.
std::string text_of(const std::string &file_name)
{
  std::ifstream file(file_name, std::ios::binary);
  std::error_code error;
  const auto size = std::filesystem::file_size(file_name, error);
  std::string text(error ? 0 : size, '\0');
  if (!file || error || !file.read(text.data(), static_cast<std::streamsize>(text.size())))
    throw UnreadableMesh("cannot be read; give the path of a .msh file.");
  if (text.empty())
    throw UnreadableMesh("is empty; export the mesh anew.");
  if (text.compare(0, 2, "\xFF\xFE") == 0 || text.compare(0, 2, "\xFE\xFF") == 0)
    throw UnreadableMesh("is in UTF-16; save it in ASCII or UTF-8.");
  if (text.compare(0, 3, "\xEF\xBB\xBF") == 0)
    text.erase(0, 3);
  return text;
}

} // namespace

MeshContent read_hexahedra(const std::string &file_name, double unit, Triangulation<3> &triangulation)
{
  const std::string subject = "Mesh file = " + file_name + " ";
  if (!boost::iends_with(file_name, ".msh"))
    throw std::invalid_argument(
      subject + "is not a .msh file; convert it: " + gmsh_command +
      ", or for .inp (Abaqus), .vtu and what Gmsh does not read `meshio convert --ascii -o gmsh22 FILE "
      "x.msh` (Debian: meshio-tools) with a mesh contact height, which needs no ids.");
  try
  {
    MeshContent content = read_gmsh(text_of(file_name));
    for (std::array<double, 3> &point : content.points)
      for (double &coordinate : point)
        coordinate *= unit;
    build(content, triangulation);
    return content;
  }
  catch (const UnreadableMesh &reason)
  {
    throw std::invalid_argument(subject + reason.what());
  }
}

} // namespace stemware::fem
