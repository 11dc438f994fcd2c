#pragma once

#include "fem/geometry/section_lengths.h"
#include "fem/geometry/triangulation.h"

#include <vector>

namespace stemware::fem
{

/// Returns the cells of a meridional mesh, with straight edges.
std::vector<SectionPolygon> section_cells(const dealii::Triangulation<2, 2> &triangulation);

/// Returns the section of the cells of a foot (straight edges) with the half-plane at @p azimuth [rad]
/// through the axis. A distributed mesh is cut as a whole on each rank.
std::vector<SectionPolygon> section_cells(const dealii::Triangulation<3, 3> &triangulation, double azimuth);

} // namespace stemware::fem
