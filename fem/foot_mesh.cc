#include "fem/foot_mesh.h"

#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>
#include <deal.II/grid/tria.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <stdexcept>

namespace stemware::fem
{

using namespace dealii;

namespace
{

constexpr types::manifold_id cylinder_id = 1;

/// Largest radial extent of a cell, as a share of the contact radius, and how fast cells grow away from the
/// land.
constexpr double largest_cell = 0.2;
constexpr double growth = 1.6;

/// Radii from @p begin to @p end (either may be the larger), cells starting at @p first_cell and growing up
/// to @p limit, stretched to fit.
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

/// A cell of the plan view: quadrilateral in deal.II's lexicographic order, with the band of radii that it
/// lies in.
struct PlanCell
{
  std::array<unsigned int, 4> vertices;
  double inner_radius = 0; ///< 0 for cells of the core and of the ring round it
  double outer_radius = 0;
};

/// The foot seen from above: square core, a ring of cells that ends at the stem's surface, more rings out to
/// the edge of the foot.
class Plan
{
public:
  Plan(double stem_radius, unsigned int n_core_sectors)
      : n_sectors(n_core_sectors)
  {
    const std::vector<unsigned int> core = add_core(0.62 * stem_radius);
    loop = core;
    add_ring(0, stem_radius);
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

  /// A ring whose outer side has three cells for each one of its inner side: four quadrilaterals a sector.
  void add_tripling_ring(double inner_radius, double outer_radius)
  {
    const std::vector<unsigned int> next = add_circle(outer_radius, 3 * n_sectors);
    const double middle = (inner_radius + outer_radius) / 2;
    for (unsigned int i = 0; i < n_sectors; ++i)
    {
      const unsigned int a = loop[i];
      const unsigned int b = loop[(i + 1) % n_sectors];
      // Drawn a little apart, so that the inner trapezium keeps good angles.
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
  static double angle(double sector, unsigned int n) { return -numbers::PI_4 + 2 * numbers::PI * sector / n; }

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

  /// A square of (n_sectors / 4)^2 cells with bulging sides, corners at @p corner_radius; returns its border,
  /// counter-clockwise.
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

  /// Half-way between the square [-1, 1]^2 and the disc that equal angles make of it, towards the border.
  static Point<2> core_point(double x, double y, double corner_radius)
  {
    const double size = std::max(std::abs(x), std::abs(y));
    if (size == 0)
      return {};
    const Point<2> square(x * corner_radius / std::sqrt(2.), y * corner_radius / std::sqrt(2.));
    const bool sideways = std::abs(x) >= std::abs(y);
    const double tilt = numbers::PI_4 * (sideways ? y / std::abs(x) : x / std::abs(y));
    const double radius = size * corner_radius;
    const Point<2> disc = sideways
                            ? Point<2>(std::copysign(radius * std::cos(tilt), x), radius * std::sin(tilt))
                            : Point<2>(radius * std::sin(tilt), std::copysign(radius * std::cos(tilt), y));
    return square + 0.5 * size * (disc - square);
  }

  unsigned int n_sectors;
  std::vector<unsigned int> loop; ///< outer border so far, counter-clockwise from -45 degrees
};

Plan make_plan(const GlassProfile &profile, const FootResolution &resolution)
{
  const double land_cell = profile.land_width / resolution.radial_cells;
  const double limit = largest_cell * profile.contact_radius;
  std::vector<double> radii =
    graded_radii(profile.land_inner_radius(), profile.stem_radius, 2 * land_cell, limit);
  std::reverse(radii.begin(), radii.end());
  for (unsigned int i = 1; i <= resolution.radial_cells; ++i)
    radii.push_back(profile.land_inner_radius() + i * land_cell);
  const std::vector<double> edge =
    graded_radii(profile.land_outer_radius(), profile.foot_radius, 2 * land_cell, limit);
  radii.insert(radii.end(), edge.begin() + 1, edge.end());

  const bool tripled = resolution.azimuthal_cells % 12 == 0 && resolution.azimuthal_cells >= 24;
  Plan plan(profile.stem_radius, resolution.azimuthal_cells / (tripled ? 3 : 1));
  for (unsigned int i = 0; i + 1 < radii.size(); ++i)
    if (i == 0 && tripled)
      plan.add_tripling_ring(radii[i], radii[i + 1]);
    else
      plan.add_ring(radii[i], radii[i + 1]);
  return plan;
}

/// A slab of the foot: cells of the plan between two heights that lie within two radii.
struct Slab
{
  double bottom = 0;
  double top = 0;
  double inner_radius = 0;
  double outer_radius = 0;
};

std::vector<Slab> make_slabs(const GlassProfile &profile, const FootResolution &resolution)
{
  std::vector<Slab> slabs;
  const auto stack = [&](double bottom, double height, unsigned int n, double inner, double outer)
  {
    for (unsigned int i = 0; i < n; ++i)
      slabs.push_back({ bottom + height * i / n, bottom + height * (i + 1) / n, inner, outer });
  };
  const double foot_top = profile.land_height + profile.foot_thickness;
  const double layer = profile.foot_thickness / resolution.foot_layers;
  const auto n_land_layers = static_cast<unsigned int>(std::ceil(profile.land_height / layer - 0.5));
  const auto n_stem_layers = static_cast<unsigned int>(std::ceil(profile.stem_height / (2.5 * layer) - 0.25));
  stack(0, profile.land_height, std::max(1u, n_land_layers), profile.land_inner_radius(),
        profile.land_outer_radius());
  stack(profile.land_height, profile.foot_thickness, resolution.foot_layers, 0, profile.foot_radius);
  stack(foot_top, profile.stem_height, std::max(2u, n_stem_layers), 0, profile.stem_radius);
  return slabs;
}

/// Stacks the plan's cells into hexahedra.
void extrude(const Plan &plan, const std::vector<Slab> &slabs, Triangulation<3> &triangulation)
{
  std::vector<Point<3>> vertices;
  std::vector<CellData<3>> cells;
  std::map<std::pair<unsigned int, unsigned int>, unsigned int> index;
  const auto vertex = [&](unsigned int plan_vertex, unsigned int level, double z)
  {
    const auto [entry, is_new] = index.emplace(std::make_pair(plan_vertex, level), vertices.size());
    if (is_new)
      vertices.emplace_back(plan.vertices[plan_vertex][0], plan.vertices[plan_vertex][1], z);
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
  // p4est wants edges that all their cells see in one direction; an O-grid does not come with such.
  GridTools::consistently_order_cells(cells);
  triangulation.create_triangulation(vertices, cells, SubCellData());
}

/// Everything at or outside the stem's surface follows the cylinder; the core and the ring round it stay
/// straight inside.
void attach_cylinder(double stem_radius, Triangulation<3> &triangulation)
{
  const double limit = stem_radius * (1 - 1e-9);
  const auto lies_outside = [&](const auto &object, unsigned int n_vertices)
  {
    for (unsigned int v = 0; v < n_vertices; ++v)
      if (std::hypot(object->vertex(v)[0], object->vertex(v)[1]) < limit)
        return false;
    return true;
  };
  for (const auto &cell : triangulation.active_cell_iterators())
    if (lies_outside(cell, 8))
      cell->set_all_manifold_ids(cylinder_id);
    else
      for (const unsigned int f : cell->face_indices())
        if (lies_outside(cell->face(f), 4))
          cell->face(f)->set_all_manifold_ids(cylinder_id);
  triangulation.set_manifold(cylinder_id, CylindricalManifold<3>(2));
}

void mark_boundaries(double height, Triangulation<3> &triangulation)
{
  const double tolerance = 1e-9 * height;
  for (const auto &cell : triangulation.active_cell_iterators())
    for (const auto &face : cell->face_iterators())
    {
      if (!face->at_boundary())
        continue;
      const double z = face->center()[2];
      if (std::abs(z) < tolerance)
        face->set_boundary_id(static_cast<types::boundary_id>(FootBoundary::contact_zone));
      else if (std::abs(z - height) < tolerance)
        face->set_boundary_id(static_cast<types::boundary_id>(FootBoundary::stem_cut));
    }
}

} // namespace

void FootResolution::validate() const
{
  std::ostringstream message;
  if (azimuthal_cells < 8 || azimuthal_cells % 4 != 0)
    message << "Azimuthal cells = " << azimuthal_cells
            << " is not allowed; give a multiple of 4, at least 8.";
  else if (radial_cells < 2 || radial_cells % 2 != 0)
    message << "Radial cells = " << radial_cells << " is not allowed; give an even number, at least 2.";
  else if (foot_layers < 1)
    message << "Foot layers = " << foot_layers << " is not allowed; give at least 1.";
  if (!message.str().empty())
    throw std::invalid_argument(message.str());
}

void make_foot_mesh(const GlassProfile &profile, const FootResolution &resolution,
                    Triangulation<3> &triangulation)
{
  profile.validate();
  resolution.validate();
  extrude(make_plan(profile, resolution), make_slabs(profile, resolution), triangulation);
  attach_cylinder(profile.stem_radius, triangulation);
  mark_boundaries(profile.height(), triangulation);
}

} // namespace stemware::fem
