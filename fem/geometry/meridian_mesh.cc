#include "fem/geometry/meridian_mesh.h"

#include "fem/geometry/boundary_ids.h"
#include "fem/geometry/profile_manifold.h"

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold.h>
#include <deal.II/grid/tria.h>

#include <cmath>
#include <functional>
#include <sstream>
#include <stdexcept>

namespace stemware::fem
{

using namespace dealii;

namespace
{

/// Grid lines of a coordinate, ascending.
using GridLines = std::vector<double>;

/// Appends @p n_cells equal cells up to @p end.
void append_equal(GridLines &lines, double end, unsigned int n_cells)
{
  const double begin = lines.back();
  for (unsigned int i = 1; i <= n_cells; ++i)
    lines.push_back(begin + (end - begin) * i / n_cells);
}

/// Appends equal cells of about @p size up to @p end, none if the lines end there.
void append_sized(GridLines &lines, double end, double size)
{
  if (lines.back() == end)
    return;
  append_equal(lines, end,
               static_cast<unsigned int>(std::max(1., std::ceil((end - lines.back()) / size - 1e-9))));
}

/// Appends cells up to @p end, the first of about @p first and each at most @p growth times its neighbour.
void append_growing(GridLines &lines, double end, double first, double growth)
{
  const double begin = lines.back();
  double total = 0;
  std::vector<double> sizes;
  for (double size = first; total < (end - begin) * (1 - 1e-9); size *= growth)
  {
    sizes.push_back(size);
    total += size;
  }
  double sum = 0;
  for (const double size : sizes)
  {
    sum += size;
    lines.push_back(begin + (end - begin) * sum / total);
  }
}

/// Borders of the contact cells: finest at the contact radius, mirror images on both sides of it.
GridLines land_lines(const GlassProfile &profile, const MeridianResolution &resolution)
{
  const unsigned int half = resolution.land_cells / 2;
  GridLines offsets = { 0 };
  for (unsigned int i = 0; i < half; ++i)
    offsets.push_back(offsets.back() + std::pow(resolution.land_grading, i));
  GridLines lines;
  for (unsigned int i = 0; i <= 2 * half; ++i)
  {
    const double offset = i < half ? -offsets[half - i] : offsets[i - half];
    lines.push_back(profile.contact_radius + offset / offsets.back() * profile.land_width / 2);
  }
  return lines;
}

/// Tensor grid of the lines without the cells whose centre is not inside.
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

/// Marks the boundary faces at the height of the clamp, and those at z = 0 under the land.
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

/// Distance of @p point from the cell's box, in units of the cell's radial size: the contact cells then split
/// alike in foot and disc.
double relative_distance(const Triangulation<2>::active_cell_iterator &cell, const Point<2> &point)
{
  const Point<2> low = cell->vertex(0);
  const Point<2> high = cell->vertex(3);
  Tensor<1, 2> away;
  for (unsigned int d = 0; d < 2; ++d)
    away[d] = std::max({ low[d] - point[d], point[d] - high[d], 0. });
  return away.norm() / (high[0] - low[0]);
}

void refine(const MeridianResolution &resolution, const GlassProfile &profile,
            Triangulation<2> &triangulation)
{
  const Point<2> focus(resolution.focus_radius > 0 ? resolution.focus_radius : profile.contact_radius, 0);
  for (unsigned int level = 0; level < resolution.focus_levels; ++level)
  {
    for (const auto &cell : triangulation.active_cell_iterators())
      if (relative_distance(cell, focus) < 1.01)
        cell->set_refine_flag();
    triangulation.execute_coarsening_and_refinement();
  }
  // Last, so that meshes with more halvings are nested in those with fewer.
  triangulation.refine_global(resolution.refinements);
}

/// Largest cell of the foot: a little longer than the foot is thick. Bending is smooth, two quadratic cells
/// through the thickness carry it.
double largest_cell(const GlassProfile &profile)
{
  return 1.25 * profile.foot_thickness;
}

void make_step(const GlassProfile &profile, const MeridianResolution &resolution,
               Triangulation<2> &triangulation)
{
  const double size = largest_cell(profile);
  GridLines radii = { 0 };
  append_sized(radii, profile.stem_radius, size);
  append_sized(radii, profile.land_inner_radius(), size);
  const GridLines land = land_lines(profile, resolution);
  radii.insert(radii.end(), land.begin() + 1, land.end());
  append_sized(radii, profile.foot_radius, size);

  GridLines heights = { 0, profile.land_height };
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

/// The grid of the straightened section (ProfileChart), bent.
void make_foot(const GlassProfile &profile, const MeridianResolution &resolution,
               Triangulation<2> &triangulation)
{
  const double size = largest_cell(profile);
  const ProfileChart chart(profile);
  const Fillet fillet = profile.fillet();
  GridLines radii = { 0 };
  append_sized(radii, fillet.middle_radius, size);
  append_sized(radii, fillet.end_radius, size);
  append_sized(radii, profile.land_inner_radius(), size);
  const GridLines land = land_lines(profile, resolution);
  radii.insert(radii.end(), land.begin() + 1, land.end());
  append_sized(radii, profile.foot_radius, size);

  const double stem_length = profile.height() - fillet.middle_height;
  GridLines levels = { 0, 0.3, 1 };
  append_sized(levels, chart.pull_back({ 0, fillet.centre_height }).level, size / stem_length);
  append_sized(levels, 2, size / stem_length);

  make_grid(
    radii, levels, [&](double radius, double level) { return level < 1 || radius < fillet.middle_radius; },
    triangulation);
  GridTools::transform(
    [&](const Point<2> &straight) -> Point<2>
    {
      const SectionPoint point = chart.push_forward({ straight[0], straight[1] });
      return { point.radius, point.height };
    },
    triangulation);
  constexpr types::manifold_id profile_id = 1;
  triangulation.set_all_manifold_ids(profile_id);
  triangulation.set_manifold(profile_id, *make_section_manifold(profile));
}

} // namespace

void TableDisc::validate(const GlassProfile &profile) const
{
  std::ostringstream message;
  if (!(std::isfinite(thickness) && thickness > 0))
    message << "Table/Disc thickness = " << thickness
            << " m is not allowed; give a finite number greater than 0.";
  else if (!(std::isfinite(radius) && radius > profile.land_outer_radius()))
    message << "Table/Disc radius = " << radius
            << " m is not allowed; it must be larger than the outer radius of the land, "
            << profile.land_outer_radius() << " m.";
  if (!message.str().empty())
    throw std::invalid_argument(message.str());
}

void MeridianResolution::validate() const
{
  std::ostringstream message;
  if (land_cells < 2 || land_cells % 2 != 0)
    message << "Contact/Radial cells = " << land_cells
            << " is not allowed for a body of revolution; give an even number of at least 2.";
  else if (!(land_grading >= 1 && land_grading <= 10))
    message << "The grading of the land, " << land_grading << ", must lie between 1 (equal cells) and 10.";
  else if (refinements > 6)
    message << refinements << " halvings of every meridional cell are too many; give at most 6.";
  else if (focus_levels > 24)
    message << focus_levels << " halvings towards the contact are too many; give at most 24.";
  else if (!(std::isfinite(focus_radius) && focus_radius >= 0))
    message << "The focus of the refinement, r = " << focus_radius << " m, must be a radius.";
  if (!message.str().empty())
    throw std::invalid_argument(message.str());
}

void make_meridian_mesh(const GlassProfile &profile, const MeridianResolution &resolution,
                        Triangulation<2> &triangulation)
{
  profile.validate();
  resolution.validate();
  if (profile.shape == GlassShape::step)
    make_step(profile, resolution, triangulation);
  else
    make_foot(profile, resolution, triangulation);
  refine(resolution, profile, triangulation);
  mark_boundary(profile.height(), profile, triangulation);
}

void make_meridian_mesh(const TableDisc &disc, const GlassProfile &profile,
                        const MeridianResolution &resolution, Triangulation<2> &triangulation)
{
  profile.validate();
  disc.validate(profile);
  resolution.validate();
  // Cells grow from the land inwards to the axis, outwards to the edge and downwards.
  GridLines inward = { 0 };
  append_growing(inward, profile.land_inner_radius(), profile.land_width, 1.5);
  GridLines radii;
  for (auto distance = inward.rbegin(); distance != inward.rend(); ++distance)
    radii.push_back(profile.land_inner_radius() - *distance);
  radii.front() = 0;
  const GridLines land = land_lines(profile, resolution);
  radii.insert(radii.end(), land.begin() + 1, land.end());
  append_growing(radii, disc.radius, profile.land_width, 2);
  GridLines depths = { 0 };
  append_growing(depths, disc.thickness, profile.land_width / 4, 2);
  const GridLines heights = [&]
  {
    GridLines lines;
    for (auto depth = depths.rbegin(); depth != depths.rend(); ++depth)
      lines.push_back(-*depth);
    return lines;
  }();
  make_grid(
    radii, heights, [](double, double) { return true; }, triangulation);
  refine(resolution, profile, triangulation);
  mark_boundary(-disc.thickness, profile, triangulation);
}

} // namespace stemware::fem
