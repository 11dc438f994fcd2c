#include "fem/solid/enriched_meshes.h"

#include "fem/geometry/boundary_ids.h"
#include "ring_model/load/constants.h"

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/tria.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace stemware::fem
{

using namespace dealii;

namespace
{

using DistributedMesh = parallel::distributed::Triangulation<3>;
using Cell = Triangulation<3>::active_cell_iterator;

/// Number of halvings at an edge. Next to an edge, a higher degree alone improves the accuracy little.
constexpr unsigned int n_edge_halvings = 2;

/// Returns true if @p cell has a contact face that overlaps the radii between @p inner and @p outer.
bool touches_contact(const Cell &cell, double inner, double outer)
{
  for (const auto &face : cell->face_iterators())
  {
    if (!face->at_boundary() ||
        face->boundary_id() != static_cast<types::boundary_id>(FootBoundary::contact_zone))
      continue;
    double face_inner = std::numeric_limits<double>::max(), face_outer = 0;
    for (const unsigned int v : face->vertex_indices())
    {
      const double radius = std::hypot(face->vertex(v)[0], face->vertex(v)[1]);
      face_inner = std::min(face_inner, radius);
      face_outer = std::max(face_outer, radius);
    }
    if (face_inner < outer && face_outer > inner)
      return true;
  }
  return false;
}

/// Returns the angle between the two faces of @p cell that share the edge @p line. Treats edges as straight.
double angle_at(const Cell &cell, unsigned int line)
{
  const Point<3> begin = cell->line(line)->vertex(0), end = cell->line(line)->vertex(1);
  const Tensor<1, 3> along = (end - begin) / (end - begin).norm();
  std::vector<Tensor<1, 3>> across; // directions from the edge into the two faces
  for (const unsigned int f : cell->face_indices())
  {
    bool has_edge = false;
    for (unsigned int l = 0; l < GeometryInfo<2>::lines_per_cell; ++l)
      has_edge = has_edge || cell->face(f)->line_index(l) == cell->line_index(line);
    if (!has_edge)
      continue;
    Tensor<1, 3> direction = cell->face(f)->center() - begin;
    direction -= (direction * along) * along;
    across.push_back(direction / direction.norm());
  }
  return std::acos(std::clamp(across.at(0) * across.at(1), -1., 1.));
}

/// Returns the re-entrant boundary edges of this rank's cells (interior angle above 1.2 pi).
std::set<unsigned int> reentrant_edges(const DistributedMesh &mesh)
{
  std::map<unsigned int, double> angles;
  std::set<unsigned int> on_boundary;
  for (const auto &cell : mesh.active_cell_iterators())
  {
    if (cell->is_artificial())
      continue;
    for (const unsigned int l : cell->line_indices())
    {
      const double angle = angle_at(cell, l);
      angles[cell->line_index(l)] += angle;
      // Finer neighbours contain the two halves of the edge.
      if (cell->line(l)->has_children())
        for (unsigned int child = 0; child < 2; ++child)
          angles[static_cast<unsigned int>(cell->line(l)->child_index(child))] += angle;
    }
    for (const auto &face : cell->face_iterators())
      if (face->at_boundary())
        for (unsigned int l = 0; l < GeometryInfo<2>::lines_per_cell; ++l)
          on_boundary.insert(face->line_index(l));
  }
  // The margin above pi excludes the edges of curved boundaries.
  std::set<unsigned int> edges;
  for (const unsigned int line : on_boundary)
    if (angles[line] > 1.2 * ring::pi)
      edges.insert(line);
  return edges;
}

bool touches(const Cell &cell, const std::set<unsigned int> &edges)
{
  for (const unsigned int l : cell->line_indices())
    if (edges.count(cell->line_index(l)) > 0)
      return true;
  return false;
}

} // namespace

std::vector<std::shared_ptr<const Triangulation<3>>> enriched_meshes(const Triangulation<3> &mesh,
                                                                     double inner, double outer)
{
  std::vector<std::shared_ptr<const Triangulation<3>>> meshes;
  const Triangulation<3> *before = &mesh;
  for (unsigned int n = 0; n < n_edge_halvings; ++n)
  {
    auto next = std::make_shared<DistributedMesh>(mesh.get_communicator());
    next->copy_triangulation(*before);
    const std::set<unsigned int> edges = reentrant_edges(*next);
    unsigned int n_marked = 0;
    for (const auto &cell : next->active_cell_iterators())
      if (cell->is_locally_owned() &&
          (touches(cell, edges) || (n == 0 && touches_contact(cell, inner, outer))))
      {
        cell->set_refine_flag();
        ++n_marked;
      }
    if (Utilities::MPI::sum(n_marked, mesh.get_communicator()) == 0)
      break;
    next->execute_coarsening_and_refinement();
    before = next.get();
    meshes.push_back(std::move(next));
  }
  return meshes;
}

} // namespace stemware::fem
