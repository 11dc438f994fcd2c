#include "fem/geometry/meridian_mesh.h"

#include "fem/geometry/boundary_ids.h"
#include "fem/geometry/meridian_section.h"
#include "fem/geometry/profile_manifold.h"
#include "fem/geometry/require.h"

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold.h>
#include <deal.II/grid/tria.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace stemware::fem
{

using namespace dealii;

namespace
{

using GridLines = std::vector<double>;

void append_equal(GridLines &lines, double end, unsigned int n_cells)
{
  const double begin = lines.back();
  for (unsigned int i = 1; i <= n_cells; ++i)
    lines.push_back(begin + (end - begin) * i / n_cells);
}

/// Appends equal cells of about @p size up to @p end; nothing if the lines already reach @p end.
void append_sized(GridLines &lines, double end, double size)
{
  if (std::abs(end - lines.back()) < 1e-6 * size)
    return;
  append_equal(lines, end,
               static_cast<unsigned int>(std::max(1., std::ceil((end - lines.back()) / size - 1e-9))));
}

struct Growth
{
  double first = 0; ///< approximate size of the first cell [m]
  double factor = 2;
  double largest = std::numeric_limits<double>::infinity(); ///< maximum cell size [m]
};

void append_growing(GridLines &lines, double end, const Growth &growth)
{
  const double begin = lines.back();
  double total = 0;
  std::vector<double> sizes;
  for (double size = growth.first; total < (end - begin) * (1 - 1e-9); size *= growth.factor)
  {
    sizes.push_back(std::min(size, growth.largest));
    total += sizes.back();
  }
  double sum = 0;
  for (const double size : sizes)
  {
    sum += size;
    lines.push_back(begin + (end - begin) * sum / total);
  }
}

void append_shrinking(GridLines &lines, double end, const Growth &growth)
{
  GridLines distances = { 0 };
  append_growing(distances, end - lines.back(), growth);
  for (auto distance = distances.rbegin() + 1; distance != distances.rend(); ++distance)
    lines.push_back(end - *distance);
}

/// Makes a tensor-product grid without the cells whose centre lies outside the section.
void make_grid(const GridLines &radii, const GridLines &heights,
               const std::function<bool(double radius, double height)> &is_inside,
               Triangulation<2> &triangulation)
{
  std::vector<std::vector<double>> sizes(2);
  for (std::size_t i = 1; i < radii.size(); ++i)
    sizes[0].push_back(radii[i] - radii[i - 1]);
  for (std::size_t j = 1; j < heights.size(); ++j)
    sizes[1].push_back(heights[j] - heights[j - 1]);
  Table<2, types::material_id> kept(sizes[0].size(), sizes[1].size());
  for (unsigned int i = 0; i < sizes[0].size(); ++i)
    for (unsigned int j = 0; j < sizes[1].size(); ++j)
      kept(i, j) = is_inside((radii[i] + radii[i + 1]) / 2, (heights[j] + heights[j + 1]) / 2)
                     ? types::material_id(0)
                     : numbers::invalid_material_id;
  GridGenerator::subdivided_hyper_rectangle(triangulation, sizes, Point<2>(radii.front(), heights.front()),
                                            kept);
}

void mark_boundary(double clamped_height, const GlassProfile &profile, Triangulation<2> &triangulation)
{
  const double tolerance = 1e-9 * profile.contact_radius;
  for (const auto &cell : triangulation.active_cell_iterators())
    for (const auto &face : cell->face_iterators())
    {
      if (!face->at_boundary())
        continue;
      const Point<2> centre = face->center();
      FootBoundary boundary = FootBoundary::free;
      if (std::abs(centre[1] - clamped_height) < tolerance)
        boundary = FootBoundary::stem_cut;
      else if (std::abs(centre[1]) < tolerance && centre[0] > profile.land_inner_radius() &&
               centre[0] < profile.land_outer_radius())
        boundary = FootBoundary::contact_zone;
      face->set_boundary_id(static_cast<types::boundary_id>(boundary));
    }
}

bool touches_table(const Triangulation<2>::active_cell_iterator &cell)
{
  for (const auto &face : cell->face_iterators())
    if (is_on(face, FootBoundary::contact_zone))
      return true;
  return false;
}

bool is_cut(const Triangulation<2>::active_cell_iterator &cell, const std::vector<double> &borders)
{
  // Vertices 0 and 1 are the ends of the lower side.
  const double begin = cell->vertex(0)[0];
  const double end = cell->vertex(1)[0];
  const double margin = 1e-3 * (end - begin);
  const auto border = std::upper_bound(borders.begin(), borders.end(), begin + margin);
  return border != borders.end() && *border < end - margin;
}

/// Returns the distance [m] of @p cell from the focus, which is an interval of radii in the plane z = 0.
double distance_from_focus(const Triangulation<2>::active_cell_iterator &cell, const ContactCells &contact)
{
  const auto [low, high] = cell->bounding_box().get_boundary_points();
  const double across = std::max({ low[0] - contact.focus_end, contact.focus_begin - high[0], 0. });
  const double away = std::max({ low[1], -high[1], 0. });
  return std::hypot(across, away);
}

/// Returns the maximum number of halvings of @p cell for which the rule for hanging nodes (a difference of
/// one level between neighbours) does not split a contact cell.
unsigned int max_halvings(const Triangulation<2>::active_cell_iterator &cell, const ContactCells &contact)
{
  const auto [low, high] = cell->bounding_box().get_boundary_points();
  if (high[0] <= contact.borders.front() || low[0] >= contact.borders.back())
    return 1 + (high[0] <= contact.borders.front() ? contact.n_halvings.front() : contact.n_halvings.back());
  const double margin = 1e-3 * (high[0] - low[0]);
  unsigned int max_below = 0;
  for (std::size_t i = 0; i < contact.n_halvings.size(); ++i)
    if (contact.borders[i] < high[0] - margin && contact.borders[i + 1] > low[0] + margin)
      max_below = std::max(max_below, contact.n_halvings[i]);
  return max_below;
}

/// Halves cells until the contact cells have the borders of @p contact and other cells meet their size bound.
void divide(const ContactCells &contact, const MeridianResolution &resolution,
            Triangulation<2> &triangulation)
{
  const auto is_large = [&](const Triangulation<2>::active_cell_iterator &cell)
  {
    if (touches_table(cell))
      return is_cut(cell, contact.borders);
    return cell->diameter() >
             numbers::SQRT2 * resolution.size_at(distance_from_focus(cell, contact)) * 1.01 &&
           static_cast<unsigned int>(cell->level()) < max_halvings(cell, contact);
  };
  for (bool done = false; !done;)
  {
    done = true;
    for (const auto &cell : triangulation.active_cell_iterators())
      if (is_large(cell))
      {
        cell->set_refine_flag();
        done = false;
      }
    triangulation.execute_coarsening_and_refinement();
  }
}

/// Marks the boundary and refines, first around the smallest contact cells (focus) and then globally. In this
/// order, meshes with different numbers of global refinements are nested.
void refine(double clamped_height, const GlassProfile &profile, const ContactCells &contact,
            const MeridianResolution &resolution, Triangulation<2> &triangulation)
{
  mark_boundary(clamped_height, profile, triangulation);
  if (resolution.has_focus())
    divide(contact, resolution, triangulation);
  triangulation.refine_global(resolution.refinements);
}

/// Returns the maximum cell size [m] away from the land. It is of the order of the thickness, because the
/// displacements in bending are smooth.
double largest_cell(const GlassProfile &profile)
{
  return 1.25 * profile.thickness();
}

/// Appends the radial grid lines up to the edge of the foot. If contact cells are halved (focus), the cells
/// next to the land are at most twice as large as the coarse contact cells.
void append_foot(const GlassProfile &profile, const ContactCells &contact, GridLines &radii)
{
  const double size = largest_cell(profile);
  const Growth growth = { contact.has_focus ? std::min(2 * contact.coarse_size, size) : size, 2, size };
  if (profile.land_inner_radius() > radii.back())
    append_shrinking(radii, profile.land_inner_radius(), growth);
  radii.insert(radii.end(), contact.coarse.begin() + 1, contact.coarse.end());
  append_growing(radii, profile.outer_radius(), growth);
}

/// Aligns radial grid lines with the corners of a user-defined section outside the fillet and the land. The
/// nearest line is moved to a corner or a line is inserted, unless a cell would become too narrow.
void meet_corners(const GlassProfile &profile, double size, GridLines &radii)
{
  if (!profile.section)
    return;
  const double end = profile.fillet().end_radius, tolerance = 1e-6 * size;
  std::vector<double> met = { 0, profile.fillet().middle_radius, end, profile.outer_radius() };
  const auto is_fixed = [&](double line)
  {
    return line <= end + tolerance || std::find(met.begin(), met.end(), line) != met.end() ||
           (line > profile.land_inner_radius() - tolerance && line < profile.land_outer_radius() + tolerance);
  };
  for (const double corner : profile.section->corner_radii())
  {
    const auto next = std::lower_bound(radii.begin() + 1, radii.end() - 1, corner);
    const auto nearest = corner - *(next - 1) < *next - corner ? next - 1 : next;
    const double distance = std::abs(*nearest - corner);
    if (is_fixed(corner) || distance < tolerance)
      continue;
    if (!is_fixed(*nearest) && distance < 0.4 * (*next - *(next - 1)))
      *nearest = corner;
    else if (distance > 0.05 * (*next - *(next - 1)))
      radii.insert(next, corner);
    else
      continue;
    met.push_back(corner);
  }
}

/// Returns the growth of the cell heights from the land up to @p end. If contact cells are halved (focus),
/// the lowest cells are at most as high as the coarse contact cells are wide.
Growth rows_of(const ContactCells &contact, const GlassProfile &profile, double end)
{
  return { contact.has_focus ? end * std::min(1., contact.coarse_size / lowest_cell_height(profile)) : end };
}

void make_step(const GlassProfile &profile, const ContactCells &contact, Triangulation<2> &triangulation)
{
  const double size = largest_cell(profile);
  GridLines radii = { 0 };
  append_sized(radii, profile.stem_radius, size);
  append_foot(profile, contact, radii);

  GridLines heights = { 0 };
  append_growing(heights, profile.land_height, rows_of(contact, profile, profile.land_height));
  append_equal(heights, profile.foot_top(), 2);
  append_sized(heights, profile.height(), size);

  const auto is_inside = [&](double radius, double height)
  {
    if (height < profile.land_height)
      return radius > profile.land_inner_radius() && radius < profile.land_outer_radius();
    return height < profile.foot_top() || radius < profile.stem_radius;
  };
  make_grid(radii, heights, is_inside, triangulation);
}

/// Makes the grid of the straight section in ProfileChart coordinates and maps it to the section.
void make_foot(const GlassProfile &profile, const ContactCells &contact, Triangulation<2> &triangulation)
{
  const double size = largest_cell(profile);
  const ProfileChart chart(profile);
  const Fillet fillet = profile.fillet();
  GridLines radii = { 0 };
  append_sized(radii, fillet.middle_radius, size);
  append_sized(radii, fillet.end_radius, size);
  append_foot(profile, contact, radii);
  meet_corners(profile, size, radii);

  const double stem_length = profile.height() - fillet.middle_height;
  GridLines levels = { 0 };
  append_growing(levels, lowest_level, rows_of(contact, profile, lowest_level));
  append_sized(levels, 1, 1);
  append_sized(levels, chart.pull_back({ 0, fillet.centre_height })[1], size / stem_length);
  append_sized(levels, 2, size / stem_length);

  make_grid(
    radii, levels, [&](double radius, double level) { return level < 1 || radius < fillet.middle_radius; },
    triangulation);
  const auto section = make_section_manifold(profile);
  GridTools::transform([&](const Point<2> &straight) { return section->push_forward(straight); },
                       triangulation);
  constexpr types::manifold_id profile_id = 1;
  triangulation.set_all_manifold_ids(profile_id);
  triangulation.set_manifold(profile_id, *section);
}

} // namespace

void make_meridian_mesh(const GlassProfile &profile, const MeridianResolution &resolution,
                        Triangulation<2> &triangulation)
{
  const ContactCells contact = contact_cells(profile, resolution);
  if (profile.shape == GlassShape::step)
    make_step(profile, contact, triangulation);
  else
    make_foot(profile, contact, triangulation);
  refine(profile.height(), profile, contact, resolution, triangulation);
}

void make_meridian_mesh(const TableDisc &disc, const GlassProfile &profile,
                        const MeridianResolution &resolution, Triangulation<2> &triangulation)
{
  const ContactCells contact = contact_cells(profile, resolution);
  disc.validate(profile);
  const double first_size = contact.has_focus ? 2 * contact.coarse_size : profile.land_width;
  GridLines radii = { 0 };
  append_shrinking(radii, profile.land_inner_radius(), { first_size, contact.has_focus ? 2 : 1.5 });
  radii.insert(radii.end(), contact.coarse.begin() + 1, contact.coarse.end());
  append_growing(radii, disc.radius, { first_size });
  GridLines heights = { -disc.thickness };
  append_shrinking(heights, 0, { contact.has_focus ? contact.coarse_size : profile.land_width / 4 });
  make_grid(
    radii, heights, [](double, double) { return true; }, triangulation);
  refine(-disc.thickness, profile, contact, resolution, triangulation);
}

} // namespace stemware::fem
