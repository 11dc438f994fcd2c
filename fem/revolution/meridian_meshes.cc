#include "fem/revolution/meridian_meshes.h"

#include "fem/geometry/boundary_ids.h"
#include "fem/geometry/contact_cells.h"
#include "fem/geometry/meridian_mesh.h"
#include "ring_model/load/constants.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <vector>

namespace stemware::fem
{

using namespace dealii;

namespace
{

/// Returns the radii of the contact face of @p cell, inner first; equal radii if there is no contact face.
std::pair<double, double> contact_of(const Triangulation<2>::active_cell_iterator &cell)
{
  for (const auto &face : cell->face_iterators())
    if (is_on(face, FootBoundary::contact_zone))
      return std::minmax({ face->vertex(0)[0], face->vertex(1)[0] });
  return { 0, 0 };
}

/// Flags the contact cells of @p one that a cell border of @p other divides. Returns true if any is flagged.
bool flag_cut_cells(Triangulation<2> &one, const Triangulation<2> &other)
{
  std::vector<double> borders;
  for (const auto &cell : other.active_cell_iterators())
    if (const auto [begin, end] = contact_of(cell); begin < end)
      borders.push_back(begin);
  std::sort(borders.begin(), borders.end());
  bool is_any_flagged = false;
  for (const auto &cell : one.active_cell_iterators())
  {
    const auto [begin, end] = contact_of(cell);
    const double margin = 1e-3 * (end - begin);
    const auto border = std::upper_bound(borders.begin(), borders.end(), begin + margin);
    if (begin == end || border == borders.end() || *border >= end - margin)
      continue;
    cell->set_refine_flag();
    is_any_flagged = true;
  }
  return is_any_flagged;
}

std::set<unsigned int> reentrant_corners(const Triangulation<2> &triangulation)
{
  std::map<unsigned int, double> angles;
  for (const auto &cell : triangulation.active_cell_iterators())
    for (const unsigned int v : cell->vertex_indices())
    {
      constexpr unsigned int next[] = { 1, 3, 0, 2 }, previous[] = { 2, 0, 3, 1 };
      const Tensor<1, 2> one = cell->vertex(next[v]) - cell->vertex(v),
                         other = cell->vertex(previous[v]) - cell->vertex(v);
      angles[cell->vertex_index(v)] +=
        std::acos(std::clamp(one * other / (one.norm() * other.norm()), -1., 1.));
    }
  std::set<unsigned int> corners;
  for (const auto &cell : triangulation.active_cell_iterators())
    for (const auto &face : cell->face_iterators())
      if (face->at_boundary())
        for (unsigned int v = 0; v < 2; ++v)
          // The margin above pi excludes the vertices of curved boundaries.
          if (angles[face->vertex_index(v)] > 1.2 * ring::pi)
            corners.insert(face->vertex_index(v));
  return corners;
}

} // namespace

MeridianMeshes::MeridianMeshes(const RevolutionSetup &setup)
{
  make_meridian_mesh(setup.profile, setup.resolution, foot);
  if (setup.table.substrate)
    make_meridian_mesh(setup.table.substrate->disc, setup.profile, setup.resolution, disc);
  for (unsigned int i = 0; i < setup.corner_halvings; ++i)
  {
    const std::set<unsigned int> corners = reentrant_corners(foot);
    for (const auto &cell : foot.active_cell_iterators())
      for (const unsigned int v : cell->vertex_indices())
        if (corners.count(cell->vertex_index(v)) > 0)
          cell->set_refine_flag();
    refine();
  }
  for (const std::vector<unsigned int> &cells : setup.halved_cells)
  {
    const std::set<unsigned int> marked(cells.begin(), cells.end());
    for (const auto &cell : foot.active_cell_iterators())
      if (marked.count(cell->active_cell_index()) > 0)
        cell->set_refine_flag();
    refine();
  }
  for (unsigned int i = 0; i < setup.halvings_beyond_zone; ++i)
    refine_beyond_zone(setup);
}

void MeridianMeshes::refine()
{
  foot.execute_coarsening_and_refinement();
  if (disc.n_levels() == 0)
    return;
  disc.execute_coarsening_and_refinement();
  const auto flag_both = [this]
  {
    const bool cuts_foot = flag_cut_cells(foot, disc);
    return flag_cut_cells(disc, foot) || cuts_foot;
  };
  while (flag_both())
  {
    foot.execute_coarsening_and_refinement();
    disc.execute_coarsening_and_refinement();
  }
}

void MeridianMeshes::refine_beyond_zone(const RevolutionSetup &setup)
{
  const ContactCells contact = contact_cells(setup.profile, setup.resolution);
  for (Triangulation<2> *body : { &foot, &disc })
    if (body->n_levels() > 0)
      for (const auto &cell : body->active_cell_iterators())
      {
        const auto [begin, end] = contact_of(cell);
        const bool is_focused = contact.has_focus && begin < end &&
                                (end - begin < 2.01 * setup.resolution.focus_size ||
                                 (begin < contact.focus_end && end > contact.focus_begin));
        const Tensor<1, 2> from_contact = cell->center() - Point<2>(setup.profile.contact_radius, 0);
        if (!is_focused && from_contact.norm() > setup.zone_half_width())
          cell->set_refine_flag();
      }
  refine();
}

std::shared_ptr<const ContactCompliance> compliance_of(const RevolutionSetup &setup,
                                                       const MeridianMeshes &meshes,
                                                       const MeridianOptions &options, ComplianceCache &cache)
{
  const auto foot = cache.get(meshes.foot, setup.material, options);
  if (!setup.table.substrate && !setup.foot_is_rigid && setup.friction_in_foot)
    return foot;
  const auto disc =
    setup.table.substrate ? cache.get(meshes.disc, setup.table.substrate->material, options) : nullptr;
  return std::make_shared<const ContactCompliance>(setup.total_compliance(*foot, disc.get()));
}

} // namespace stemware::fem
