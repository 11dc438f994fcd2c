#include "fem/pipeline/variants/refinement_axis.h"

#include "fem/pipeline/study/study_file.h"
#include "fem/pipeline/support/failures.h"

#include <algorithm>
#include <utility>

namespace stemware::pipeline
{

namespace
{

constexpr unsigned int highest_degree = 4;
constexpr unsigned int most_halvings = 6;

/// Adds the levels on which @p parameter, a member of @p study, has the @p sizes to @p axis, and keeps that
/// unless it is only the study itself.
void add_axis(RefinementAxis axis, const std::vector<unsigned int> &sizes, Study &study,
              unsigned int &parameter, std::vector<RefinementAxis> &axes)
{
  const unsigned int own = parameter;
  for (const unsigned int size : sizes)
  {
    parameter = size;
    if (size == own)
      axis.own = axis.levels.size();
    axis.levels.push_back({ { axis.key, axis.name, study }, size });
  }
  parameter = own;
  if (axis.levels.size() > 1)
    axes.push_back(std::move(axis));
}

/// @p own, @p own + 1, ... : at most @p n of them, none above @p most.
std::vector<unsigned int> counted(unsigned int own, unsigned int n, unsigned int most)
{
  std::vector<unsigned int> sizes;
  for (unsigned int size = own; size < own + n && size <= most; ++size)
    sizes.push_back(size);
  return sizes;
}

/// Numbers that a parameter may take: multiples of `step` from `least` to `most`.
struct Allowed
{
  unsigned int least = 1;
  unsigned int most = 1000000;
  unsigned int step = 1;
};

/// Half of @p own where that is allowed, then @p own and its doubles: at most @p n of them.
std::vector<unsigned int> doubled(unsigned int own, unsigned int n, const Allowed &allowed)
{
  std::vector<unsigned int> sizes;
  if (own % (2 * allowed.step) == 0 && own / 2 >= allowed.least)
    sizes.push_back(own / 2);
  for (unsigned int size = own; sizes.size() < n && (size == own || size <= allowed.most); size *= 2)
    sizes.push_back(size);
  return sizes;
}

/// The degree below the study's own, its own and those above.
void add_degree_axis(Study &study, unsigned int highest, std::vector<RefinementAxis> &axes)
{
  unsigned int &degree = study.contact.degree;
  const unsigned int lowest = degree > 1 ? degree - 1 : 1;
  add_axis({ "degree", "degree of the elements", "degree", false, Decay::spectral, AxisRole::order },
           counted(lowest, highest - lowest + 1, highest), study, degree, axes);
}

std::vector<RefinementAxis> axes_of_revolution(Study study, unsigned int n_levels)
{
  ContactSection &contact = study.contact;
  std::vector<RefinementAxis> axes;
  add_axis({ "meridional_mesh", "meridional mesh", "halvings of every cell" },
           counted(contact.refinements, n_levels, most_halvings), study, contact.refinements, axes);
  add_degree_axis(study, highest_degree, axes);
  add_axis({ "harmonics", "elastic harmonics", "harmonics", true, Decay::spectral, AxisRole::azimuth },
           doubled(contact.harmonics, n_levels, { 1, (contact.azimuth_lines - 1) / 2 }), study,
           contact.harmonics, axes);
  add_axis({ "azimuth_lines", "azimuth lines", "lines", true, Decay::spectral, AxisRole::azimuth },
           doubled(contact.azimuth_lines, n_levels, { std::max(16u, 2 * contact.harmonics + 1) }), study,
           contact.azimuth_lines, axes);
  return axes;
}

std::vector<RefinementAxis> axes_of_solid(Study study, unsigned int n_levels)
{
  std::vector<RefinementAxis> axes;
  // Numbers of cells of a generated mesh.
  const auto add_cells = [&](const char *key, const char *name, unsigned int &cells, const Allowed &allowed) {
    add_axis({ key, name, "cells", true }, doubled(cells, n_levels, allowed), study, cells, axes);
  };
  if (study.contact.mesh_file.empty())
  {
    fem::FootResolution &resolution = study.contact.resolution;
    add_cells("azimuthal_cells", "cells round the rim", resolution.azimuthal_cells, { 8, 2000, 4 });
    add_cells("radial_cells", "cells across the land", resolution.radial_cells, { 2, 200, 2 });
    add_cells("foot_layers", "cells through the foot", resolution.foot_layers, { 1, 100, 1 });
  }
  add_degree_axis(study, 2, axes);
  return axes;
}

} // namespace

std::vector<RefinementAxis> refinement_axes(const Study &study, unsigned int n_levels)
{
  if (!study.load.is_from_contact())
    throw BadInput("This study's load does not come from a contact, so it has no discretisation to refine; "
                   "set Load/Source = contact.");
  if (study.has_waviness())
    throw BadInput(
      "A refinement study takes a rim and a table that are flat; leave the waviness of Glass and "
      "Table empty.");
  Study on_its_mesh = study; // which stays the goal's on all levels
  on_its_mesh.contact.goal = Goal::none;
  const std::vector<RefinementAxis> axes = abilities(study.contact.body).is_of_revolution
                                             ? axes_of_revolution(on_its_mesh, n_levels)
                                             : axes_of_solid(on_its_mesh, n_levels);
  for (const RefinementAxis &axis : axes)
    for (const RefinementLevel &level : axis.levels)
      check_study(level.study);
  return axes;
}

unsigned int n_contact_azimuths(const Study &study)
{
  if (!abilities(study.contact.body).is_of_revolution)
    return study.contact.resolution.azimuthal_cells;
  return study.contact.azimuth_lines;
}

} // namespace stemware::pipeline
