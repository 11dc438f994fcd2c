#include "fem/geometry/mesh_quality.h"

#include "fem/geometry/boundary_ids.h"
#include "ring_model/load/constants.h"

#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>

#include <Eigen/Dense>
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/pending/disjoint_sets.hpp>

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

void check_cells(const Triangulation<3> &triangulation, MeshCheck &check)
{
  const std::vector<double> jacobians = scaled_jacobians(triangulation);
  double sum = 0;
  check.min_jacobian = std::numeric_limits<double>::infinity();
  for (const auto &cell : triangulation.active_cell_iterators())
  {
    const double jacobian = jacobians[cell->active_cell_index()];
    sum += jacobian;
    check.n_inverted += jacobian <= 0;
    if (jacobian >= check.min_jacobian)
      continue;
    check.min_jacobian = jacobian;
    for (unsigned int d = 0; d < 3; ++d)
      check.worst_place[d] = cell->center()[d];
  }
  check.mean_jacobian = sum / check.n_cells;
}

/// Returns the outward area vector of a face with straight edges: half the cross product of the diagonals.
Tensor<1, 3> area_of(const Triangulation<3>::cell_iterator &cell, unsigned int face_number)
{
  const auto face = cell->face(face_number);
  const Tensor<1, 3> area =
    0.5 * cross_product_3d(face->vertex(3) - face->vertex(0), face->vertex(2) - face->vertex(1));
  return area * (face->center() - cell->center()) < 0 ? -area : area;
}

void check_contact_zone(const Triangulation<3> &triangulation, MeshCheck &check)
{
  check.inner_radius = check.lowest = std::numeric_limits<double>::infinity();
  check.outer_radius = check.highest = -std::numeric_limits<double>::infinity();
  constexpr double steep = 0.1;
  double upward = 0, sideways = 0;
  for (const auto &cell : triangulation.active_cell_iterators())
    for (const unsigned int f : cell->face_indices())
    {
      const auto face = cell->face(f);
      if (!is_on(face, FootBoundary::contact_zone))
        continue;
      const Tensor<1, 3> area = area_of(cell, f);
      check.contact_area += area.norm();
      check.mean_height += area.norm() * face->center()[2];
      (std::abs(area[2]) <= steep * area.norm() ? sideways : upward) +=
        area[2] > -1e-6 * area.norm() ? area.norm() : 0;
      for (unsigned int d = 0; d < 2; ++d)
        check.centre[d] += area.norm() * face->center()[d];
      for (const unsigned int v : face->vertex_indices())
      {
        const Point<3> &x = face->vertex(v);
        const double radius = std::hypot(x[0], x[1]);
        check.inner_radius = std::min(check.inner_radius, radius);
        check.outer_radius = std::max(check.outer_radius, radius);
        check.lowest = std::min(check.lowest, x[2]);
        check.highest = std::max(check.highest, x[2]);
      }
    }
  check.upward_share = upward / check.contact_area;
  check.sideways_share = sideways / check.contact_area;
  check.mean_height /= check.contact_area;
  for (double &coordinate : check.centre)
    coordinate /= check.contact_area;
}

/// Fits a circle to the outer border of the contact zone: least squares of x^2 + y^2 - 2 a x - 2 b y - c.
void check_rim(const Triangulation<3> &triangulation, MeshCheck &check)
{
  const std::vector<Outline> outlines = contact_outlines(triangulation);
  // A closed surface has no outline.
  const Outline outline = outlines.empty() ? Outline(1) : outlines.front();
  Eigen::MatrixX3d matrix(outline.size(), 3);
  Eigen::VectorXd right(outline.size());
  for (std::size_t i = 0; i < outline.size(); ++i)
  {
    const auto row = static_cast<Eigen::Index>(i);
    const auto &[x, y] = outline[i];
    matrix.row(row) << 2 * x, 2 * y, 1;
    right(row) = x * x + y * y;
  }
  const Eigen::Vector3d fit = matrix.colPivHouseholderQr().solve(right);
  check.rim_centre = { fit(0), fit(1) };
  const double radius = std::sqrt(fit(2) + fit(0) * fit(0) + fit(1) * fit(1));
  for (const auto &[x, y] : outline)
    check.rim_deviation =
      std::max(check.rim_deviation, std::abs(std::hypot(x - fit(0), y - fit(1)) / radius - 1));
}

/// Computes the height of the stem cut and counts the cells that are not connected with the cut.
void check_stem(const Triangulation<3> &triangulation, MeshCheck &check)
{
  boost::disjoint_sets_with_storage<> sets(triangulation.n_active_cells() + 1);
  const unsigned int held = triangulation.n_active_cells();
  unsigned int n_faces = 0;
  for (const auto &cell : triangulation.active_cell_iterators())
    for (const unsigned int f : cell->face_indices())
      if (!cell->at_boundary(f))
        sets.union_set(cell->active_cell_index(), cell->neighbor(f)->active_cell_index());
      else if (const auto face = cell->face(f); is_on(face, FootBoundary::stem_cut))
      {
        sets.union_set(cell->active_cell_index(), held);
        check.stem_height += face->center()[2];
        ++n_faces;
        for (const unsigned int v : face->vertex_indices())
          check.stem_radius = std::max(check.stem_radius, std::hypot(face->vertex(v)[0], face->vertex(v)[1]));
      }
  check.stem_height /= std::max(1u, n_faces);
  for (const auto &cell : triangulation.active_cell_iterators())
    if (n_faces > 0 && sets.find_set(cell->active_cell_index()) != sets.find_set(held))
    {
      ++check.n_disconnected;
      for (unsigned int d = 0; d < 3; ++d)
        check.disconnected_place[d] = cell->center()[d];
    }
}

unsigned int n_contact_zones(const Triangulation<3> &triangulation)
{
  boost::disjoint_sets_with_storage<> sets(triangulation.n_raw_lines());
  std::set<unsigned int> edges;
  for (const auto &face : triangulation.active_face_iterators())
    if (is_on(face, FootBoundary::contact_zone))
      for (unsigned int l = 0; l < 4; ++l)
      {
        edges.insert(face->line_index(l));
        sets.union_set(face->line_index(0), face->line_index(l));
      }
  return static_cast<unsigned int>(sets.count_sets(edges.begin(), edges.end()));
}

} // namespace

std::vector<double> scaled_jacobians(const Triangulation<3> &triangulation)
{
  std::vector<double> jacobians(triangulation.n_active_cells(), 1);
  for (const auto &cell : triangulation.active_cell_iterators())
    for (const unsigned int v : cell->vertex_indices())
    {
      // deal.II numbers vertices so that bit d of the number is the reference coordinate d.
      std::array<Tensor<1, 3>, 3> edges;
      for (unsigned int d = 0; d < 3; ++d)
        edges[d] = cell->vertex(v | (1u << d)) - cell->vertex(v & ~(1u << d));
      const double lengths = edges[0].norm() * edges[1].norm() * edges[2].norm();
      const double product = cross_product_3d(edges[0], edges[1]) * edges[2];
      double &least = jacobians[cell->active_cell_index()];
      least = std::min(least, lengths > 0 ? product / lengths : -1);
    }
  return jacobians;
}

std::vector<Outline> contact_outlines(const Triangulation<3> &triangulation)
{
  std::map<unsigned int, std::array<unsigned int, 2>> edges; // edges of exactly one contact face
  for (const auto &face : triangulation.active_face_iterators())
    if (is_on(face, FootBoundary::contact_zone))
      for (unsigned int l = 0; l < 4; ++l)
        if (const auto line = face->line(l);
            !edges.insert({ face->line_index(l), { line->vertex_index(0), line->vertex_index(1) } }).second)
          edges.erase(face->line_index(l));
  std::multimap<unsigned int, unsigned int> neighbors;
  for (const auto &[index, ends] : edges)
  {
    neighbors.emplace(ends[0], ends[1]);
    neighbors.emplace(ends[1], ends[0]);
  }
  std::vector<Outline> outlines;
  while (!neighbors.empty())
  {
    Outline outline;
    unsigned int vertex = neighbors.begin()->first;
    for (auto step = neighbors.find(vertex); step != neighbors.end(); step = neighbors.find(vertex))
    {
      const unsigned int next = step->second;
      neighbors.erase(step);
      const auto [begin, end] = neighbors.equal_range(next);
      neighbors.erase(std::find_if(begin, end, [&](const auto &back) { return back.second == vertex; }));
      const Point<3> &x = triangulation.get_vertices()[vertex];
      outline.push_back({ x[0], x[1] });
      vertex = next;
    }
    outlines.push_back(outline);
  }
  const auto length = [](const Outline &outline)
  {
    double sum = 0;
    for (std::size_t i = 0; i < outline.size(); ++i)
      sum += std::hypot(outline[i][0] - outline[(i + 1) % outline.size()][0],
                        outline[i][1] - outline[(i + 1) % outline.size()][1]);
    return sum;
  };
  std::sort(outlines.begin(), outlines.end(),
            [&](const Outline &a, const Outline &b) { return length(a) > length(b); });
  return outlines;
}

unsigned int n_symmetry_sectors(const Triangulation<3> &triangulation)
{
  namespace bg = boost::geometry;
  using Place = bg::model::point<double, 3, bg::cs::cartesian>;
  double inner_radius = std::numeric_limits<double>::infinity();
  unsigned int n_faces = 0;
  for (const auto &face : triangulation.active_face_iterators())
    if (is_on(face, FootBoundary::contact_zone))
    {
      ++n_faces;
      for (const unsigned int v : face->vertex_indices())
        inner_radius = std::min(inner_radius, std::hypot(face->vertex(v)[0], face->vertex(v)[1]));
    }
  std::vector<Place> places;
  double largest = 0;
  for (unsigned int v = 0; v < triangulation.n_vertices(); ++v)
    if (triangulation.vertex_used(v))
    {
      const Point<3> &x = triangulation.get_vertices()[v];
      const double radius = std::hypot(x[0], x[1]);
      if (radius > 0.999 * inner_radius)
        places.emplace_back(x[0], x[1], x[2]);
      largest = std::max(largest, radius);
    }
  const bg::index::rtree<Place, bg::index::quadratic<16>> tree(places);
  const auto is_turned_onto_itself = [&](unsigned int n)
  {
    const double cosine = std::cos(2 * ring::pi / n), sine = std::sin(2 * ring::pi / n);
    return std::all_of(places.begin(), places.end(),
                       [&](const Place &place)
                       {
                         const double x = place.get<0>(), y = place.get<1>();
                         const Place turned(cosine * x - sine * y, sine * x + cosine * y, place.get<2>());
                         const auto next = tree.qbegin(bg::index::nearest(turned, 1));
                         return bg::distance(*next, turned) <= 1e-7 * largest;
                       });
  };
  for (unsigned int n = n_faces; n > 1; --n)
    if (n_faces % n == 0 && is_turned_onto_itself(n))
      return n;
  return 1;
}

MeshCheck check_mesh(const Triangulation<3> &triangulation)
{
  MeshCheck check;
  check.n_cells = triangulation.n_active_cells();
  check.n_vertices = triangulation.n_used_vertices();
  for (const auto &face : triangulation.active_face_iterators())
    if (face->at_boundary())
      ++check.n_faces[face->boundary_id()];
  const auto [lower, upper] = GridTools::compute_bounding_box(triangulation).get_boundary_points();
  for (unsigned int d = 0; d < 3; ++d)
  {
    check.lower[d] = lower[d];
    check.upper[d] = upper[d];
  }
  check_contact_zone(triangulation, check);
  check.n_zones = n_contact_zones(triangulation);
  check_rim(triangulation, check);
  check_stem(triangulation, check);
  check_cells(triangulation, check);
  return check;
}

} // namespace stemware::fem
