#include "fem/geometry/foot_mesh.h"

#include "fem/geometry/profile_manifold.h"
#include "ring_model/load/constants.h"

#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>
#include <deal.II/grid/tria.h>
#include <deal.II/grid/tria_description.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

namespace stemware::fem
{

using namespace dealii;

namespace
{

/// Manifold ids: `ring_id` for cells and faces around the axis, `core_id` for the core of GlassShape::foot.
constexpr types::manifold_id ring_id = 1;
constexpr types::manifold_id core_id = 2;

/// Maximum ratio of radial cell size to contact radius, and growth factor of the cells away from the land.
constexpr double largest_cell_ratio = 0.2;
constexpr double growth = 1.6;

/// Returns radii from @p begin to @p end, ascending or descending. The cells grow from @p first_cell up to @p
/// limit and are then scaled to fit the interval.
std::vector<double> graded_radii(double begin, double end, double first_cell, double limit)
{
  const double length = std::abs(end - begin);
  std::vector<double> offsets = { 0 };
  for (double cell = std::min(first_cell, limit); offsets.back() < 0.75 * length || offsets.size() == 1;
       cell = std::min(growth * cell, limit))
    offsets.push_back(offsets.back() + cell);
  std::vector<double> radii;
  for (const double offset : offsets)
    radii.push_back(begin + (end - begin) * offset / offsets.back());
  return radii;
}

/// Quadrilateral of the plan view. The vertices are in deal.II's lexicographic order.
struct PlanCell
{
  std::array<unsigned int, 4> vertices;
  double inner_radius = 0; ///< 0 for the core and the ring around the core
  double outer_radius = 0;
};

/// Plan view of the foot: a square core inside rings of cells up to the edge of the foot.
class Plan
{
public:
  Plan(double core_radius, unsigned int n_core_sectors)
      : n_sectors(n_core_sectors)
  {
    const std::vector<unsigned int> core = add_core(0.62 * core_radius);
    loop = core;
    add_ring(0, core_radius);
  }

  void add_ring(double inner_radius, double outer_radius)
  {
    const std::vector<unsigned int> next = add_circle(outer_radius, n_sectors);
    for (unsigned int i = 0; i < n_sectors; ++i)
    {
      const unsigned int j = (i + 1) % n_sectors;
      cells.push_back({ { loop[i], next[i], loop[j], next[j] }, inner_radius, outer_radius });
    }
    loop = next;
  }

  /// Adds a ring with three outer cells per inner cell; each sector has four quadrilaterals.
  void add_tripling_ring(double inner_radius, double outer_radius)
  {
    const std::vector<unsigned int> next = add_circle(outer_radius, 3 * n_sectors);
    const double middle = (inner_radius + outer_radius) / 2;
    for (unsigned int i = 0; i < n_sectors; ++i)
    {
      const unsigned int a = loop[i];
      const unsigned int b = loop[(i + 1) % n_sectors];
      // Moving p and q apart by 0.08 sectors each improves the angles of the inner trapezium.
      const unsigned int p = add_vertex(middle, angle(3 * i + 0.92, 3 * n_sectors));
      const unsigned int q = add_vertex(middle, angle(3 * i + 2.08, 3 * n_sectors));
      const unsigned int e = (3 * i + 3) % (3 * n_sectors);
      const auto add = [&](std::array<unsigned int, 4> vertices) {
        cells.push_back({ vertices, inner_radius, outer_radius });
      };
      add({ a, p, b, q });
      add({ a, next[3 * i], p, next[3 * i + 1] });
      add({ p, next[3 * i + 1], q, next[3 * i + 2] });
      add({ q, next[3 * i + 2], b, next[e] });
    }
    loop = next;
    n_sectors *= 3;
  }

  std::vector<Point<2>> vertices;
  std::vector<PlanCell> cells;

private:
  static double angle(double sector, unsigned int n) { return -ring::pi / 4 + 2 * ring::pi * sector / n; }

  unsigned int add_vertex(double radius, double azimuth)
  {
    vertices.emplace_back(radius * std::cos(azimuth), radius * std::sin(azimuth));
    return static_cast<unsigned int>(vertices.size() - 1);
  }

  std::vector<unsigned int> add_circle(double radius, unsigned int n)
  {
    std::vector<unsigned int> circle;
    for (unsigned int i = 0; i < n; ++i)
      circle.push_back(add_vertex(radius, angle(i, n)));
    return circle;
  }

  /// Adds a square of (n_sectors / 4)^2 cells with convex sides. Returns its border, counter-clockwise.
  std::vector<unsigned int> add_core(double corner_radius)
  {
    const unsigned int n = n_sectors / 4;
    const auto index = [n](unsigned int i, unsigned int j) { return j * (n + 1) + i; };
    for (unsigned int j = 0; j <= n; ++j)
      for (unsigned int i = 0; i <= n; ++i)
        vertices.push_back(core_point(2. * i / n - 1, 2. * j / n - 1, corner_radius));
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = 0; i < n; ++i)
        cells.push_back({ { index(i, j), index(i + 1, j), index(i, j + 1), index(i + 1, j + 1) }, 0, 0 });
    std::vector<unsigned int> border;
    for (unsigned int j = 0; j < n; ++j)
      border.push_back(index(n, j));
    for (unsigned int i = n; i > 0; --i)
      border.push_back(index(i, n));
    for (unsigned int j = n; j > 0; --j)
      border.push_back(index(0, j));
    for (unsigned int i = 0; i < n; ++i)
      border.push_back(index(i, 0));
    return border;
  }

  /// Maps the square [-1, 1]^2 to the core by blending a square with a disc of equally spaced azimuths. The
  /// weight of the disc is 0 at the centre and 1/2 at the border.
  static Point<2> core_point(double x, double y, double corner_radius)
  {
    const double size = std::max(std::abs(x), std::abs(y));
    if (size == 0)
      return {};
    const Point<2> square(x * corner_radius / std::sqrt(2.), y * corner_radius / std::sqrt(2.));
    const bool sideways = std::abs(x) >= std::abs(y);
    const double tilt = ring::pi / 4 * (sideways ? y / std::abs(x) : x / std::abs(y));
    const double radius = size * corner_radius;
    const Point<2> disc = sideways
                            ? Point<2>(std::copysign(radius * std::cos(tilt), x), radius * std::sin(tilt))
                            : Point<2>(radius * std::sin(tilt), std::copysign(radius * std::cos(tilt), y));
    return square + 0.5 * size * (disc - square);
  }

  unsigned int n_sectors;
  std::vector<unsigned int> loop; ///< current outer border, counter-clockwise from -45 degrees
};

double core_radius(const GlassProfile &profile)
{
  return profile.fillet().middle_radius;
}

Plan make_plan(const GlassProfile &profile, const FootResolution &resolution)
{
  const double land_cell = profile.land_width / resolution.radial_cells;
  const double limit = largest_cell_ratio * profile.contact_radius;
  const double fillet_end = profile.fillet().end_radius;
  std::vector<double> radii = graded_radii(profile.land_inner_radius(), fillet_end, 2 * land_cell, limit);
  std::reverse(radii.begin(), radii.end());
  for (unsigned int i = 1; i <= resolution.radial_cells; ++i)
    radii.push_back(profile.land_inner_radius() + i * land_cell);
  const std::vector<double> edge =
    graded_radii(profile.land_outer_radius(), profile.outer_radius(), 2 * land_cell, limit);
  radii.insert(radii.end(), edge.begin() + 1, edge.end());

  const bool tripled = resolution.azimuthal_cells % 12 == 0 && resolution.azimuthal_cells >= 24;
  Plan plan(core_radius(profile), resolution.azimuthal_cells / (tripled ? 3 : 1));
  if (fillet_end > core_radius(profile))
    plan.add_ring(core_radius(profile), fillet_end);
  for (unsigned int i = 0; i + 1 < radii.size(); ++i)
    if (i == 0 && tripled)
      plan.add_tripling_ring(radii[i], radii[i + 1]);
    else
      plan.add_ring(radii[i], radii[i + 1]);
  return plan;
}

/// Layer between two radii and two heights. For GlassShape::foot the heights are levels of ProfileChart.
struct Slab
{
  double bottom = 0;
  double top = 0;
  double inner_radius = 0;
  double outer_radius = 0;
};

void stack(double bottom, double height, unsigned int n, double inner, double outer, std::vector<Slab> &slabs)
{
  for (unsigned int i = 0; i < n; ++i)
    slabs.push_back({ bottom + height * i / n, bottom + height * (i + 1) / n, inner, outer });
}

/// Returns the number of cell layers of the stem, each about 2.5 times as high as @p foot_layer.
unsigned int n_stem_layers(double height, double foot_layer)
{
  return static_cast<unsigned int>(std::max(1., std::ceil(height / (2.5 * foot_layer) - 0.25)));
}

std::vector<Slab> step_slabs(const GlassProfile &profile, const FootResolution &resolution)
{
  std::vector<Slab> slabs;
  const double layer = profile.foot_thickness / resolution.foot_layers;
  const auto n_land_layers = static_cast<unsigned int>(std::ceil(profile.land_height / layer - 0.5));
  stack(0, profile.land_height, std::max(1u, n_land_layers), profile.land_inner_radius(),
        profile.land_outer_radius(), slabs);
  stack(profile.land_height, profile.foot_thickness, resolution.foot_layers, 0, profile.foot_radius, slabs);
  stack(profile.foot_top(), profile.stem_height, std::max(2u, n_stem_layers(profile.stem_height, layer)), 0,
        profile.stem_radius, slabs);
  return slabs;
}

std::vector<Slab> foot_slabs(const GlassProfile &profile, const FootResolution &resolution)
{
  std::vector<Slab> slabs;
  stack(0, 1, resolution.foot_layers, 0, profile.outer_radius(), slabs);
  const double layer = profile.thickness() / resolution.foot_layers;
  const Fillet fillet = profile.fillet();
  const double fillet_top = ProfileChart(profile).pull_back({ 0, fillet.centre_height })[1];
  if (fillet_top > 1 + 1e-9) // otherwise the corner between foot and stem is sharp, up to rounding
    stack(1, fillet_top - 1, n_stem_layers(fillet.centre_height - fillet.middle_height, layer), 0,
          fillet.middle_radius, slabs);
  stack(fillet_top, 2 - fillet_top, n_stem_layers(profile.height() - fillet.centre_height, layer), 0,
        fillet.middle_radius, slabs);
  return slabs;
}

/// Extrudes the plan into hexahedra. @p place maps a vertex (x, y, height) to its position in space.
void extrude(const Plan &plan, const std::vector<Slab> &slabs,
             const std::function<Point<3>(const Point<3> &)> &place, Triangulation<3> &triangulation)
{
  std::vector<Point<3>> vertices;
  std::vector<CellData<3>> cells;
  std::map<std::pair<unsigned int, unsigned int>, unsigned int> index;
  const auto vertex = [&](unsigned int plan_vertex, unsigned int level, double z)
  {
    const auto [entry, is_new] = index.emplace(std::make_pair(plan_vertex, level), vertices.size());
    if (is_new)
      vertices.push_back(place({ plan.vertices[plan_vertex][0], plan.vertices[plan_vertex][1], z }));
    return entry->second;
  };
  for (unsigned int level = 0; level < slabs.size(); ++level)
  {
    const Slab &slab = slabs[level];
    const double tolerance = 1e-9 * slab.outer_radius;
    for (const PlanCell &plan_cell : plan.cells)
    {
      if (plan_cell.inner_radius < slab.inner_radius - tolerance ||
          plan_cell.outer_radius > slab.outer_radius + tolerance)
        continue;
      CellData<3> cell;
      for (unsigned int v = 0; v < 4; ++v)
      {
        cell.vertices[v] = vertex(plan_cell.vertices[v], level, slab.bottom);
        cell.vertices[v + 4] = vertex(plan_cell.vertices[v], level + 1, slab.top);
      }
      cells.push_back(cell);
    }
  }
  // p4est requires that each edge has the same direction in all of its cells.
  GridTools::consistently_order_cells(cells);
  triangulation.create_triangulation(vertices, cells, SubCellData());
}

/// Attaches the ring manifold to all cells and faces whose vertices lie at or outside the core. @p radius
/// returns the radius of a vertex.
void mark_rings(double core_radius, const std::function<double(const Point<3> &)> &radius,
                Triangulation<3> &triangulation)
{
  const double limit = core_radius * (1 - 1e-9);
  const auto lies_outside = [&](const auto &object, unsigned int n_vertices)
  {
    for (unsigned int v = 0; v < n_vertices; ++v)
      if (radius(object->vertex(v)) < limit)
        return false;
    return true;
  };
  for (const auto &cell : triangulation.active_cell_iterators())
    if (lies_outside(cell, 8))
      cell->set_all_manifold_ids(ring_id);
    else
      for (const unsigned int f : cell->face_indices())
        if (lies_outside(cell->face(f), 4))
          cell->face(f)->set_all_manifold_ids(ring_id);
}

void make_step(const GlassProfile &profile, const FootResolution &resolution, Triangulation<3> &triangulation)
{
  extrude(
    make_plan(profile, resolution), step_slabs(profile, resolution),
    [](const Point<3> &point) { return point; }, triangulation);
  mark_rings(
    core_radius(profile), [](const Point<3> &point) { return std::hypot(point[0], point[1]); },
    triangulation);
  triangulation.set_manifold(ring_id, CylindricalManifold<3>(2));
}

void make_foot(const GlassProfile &profile, const FootResolution &resolution, Triangulation<3> &triangulation)
{
  const auto core = make_core_manifold(profile), rings = make_ring_manifold(profile);
  extrude(
    make_plan(profile, resolution), foot_slabs(profile, resolution),
    [&](const Point<3> &straight) { return core->push_forward(straight); }, triangulation);
  triangulation.set_all_manifold_ids(core_id);
  mark_rings(
    core_radius(profile), [&](const Point<3> &point) { return rings->pull_back(point)[0]; }, triangulation);
  triangulation.set_manifold(core_id, *core);
  triangulation.set_manifold(ring_id, *rings);
}

void mark_boundaries(const GlassProfile &profile, Triangulation<3> &triangulation)
{
  const double tolerance = 1e-9 * profile.height();
  const auto is_on_land = [&](const Point<3> &vertex)
  {
    const double radius = std::hypot(vertex[0], vertex[1]);
    return std::abs(vertex[2]) < tolerance && radius > profile.land_inner_radius() - tolerance &&
           radius < profile.land_outer_radius() + tolerance;
  };
  for (const auto &cell : triangulation.active_cell_iterators())
    for (const auto &face : cell->face_iterators())
    {
      if (!face->at_boundary())
        continue;
      if (is_on_land(face->vertex(0)) && is_on_land(face->vertex(1)) && is_on_land(face->vertex(2)) &&
          is_on_land(face->vertex(3)))
        face->set_boundary_id(static_cast<types::boundary_id>(FootBoundary::contact_zone));
      else if (std::abs(face->center()[2] - profile.height()) < tolerance)
        face->set_boundary_id(static_cast<types::boundary_id>(FootBoundary::stem_cut));
    }
}

/// For a step, halves the cells with a vertex on the inner edge of the land. For a smooth underside, halves
/// the cells within one cell width @p size [m] of this edge.
void refine_edge(const GlassProfile &profile, unsigned int n_halvings, double size,
                 Triangulation<3> &triangulation)
{
  const double inner = profile.land_inner_radius(), tolerance = 1e-6 * profile.land_width;
  const auto is_near = [&](double radius, double height)
  {
    return profile.shape == GlassShape::step
             ? height < profile.land_height + tolerance && std::abs(radius - inner) < tolerance
             : std::hypot(radius - inner, height) < 1.001 * size;
  };
  for (unsigned int i = 0; i < n_halvings; ++i, size /= 2)
  {
    for (const auto &cell : triangulation.active_cell_iterators())
      for (const unsigned int v : cell->vertex_indices())
        if (cell->is_locally_owned() &&
            is_near(std::hypot(cell->vertex(v)[0], cell->vertex(v)[1]), cell->vertex(v)[2]))
          cell->set_refine_flag();
    triangulation.execute_coarsening_and_refinement();
  }
}

} // namespace

void make_foot_mesh(const GlassProfile &profile, const FootResolution &resolution,
                    Triangulation<3> &triangulation)
{
  profile.validate();
  resolution.validate();
  if (profile.shape == GlassShape::step)
    make_step(profile, resolution, triangulation);
  else
    make_foot(profile, resolution, triangulation);
  mark_boundaries(profile, triangulation);
  if (resolution.refinements > 0)
    triangulation.refine_global(resolution.refinements);
  const double land_cell = profile.land_width / resolution.radial_cells;
  refine_edge(profile, resolution.edge_halvings,
              std::ldexp(land_cell, -static_cast<int>(resolution.refinements)), triangulation);
}

} // namespace stemware::fem
