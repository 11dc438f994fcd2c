#pragma once

#include "fem/geometry/section_lengths.h"
#include "fem/geometry/triangulation.h"

#include <vector>

namespace stemware::fem
{

/// Returns the cells of a meridional mesh, with straight edges.
std::vector<SectionPolygon> section_cells(const dealii::Triangulation<2, 2> &triangulation);

/// Returns the section of a foot's cells (straight edges) with the half-plane through the axis at @p azimuth
/// [rad]; of a distributed mesh the whole section on each rank.
std::vector<SectionPolygon> section_cells(const dealii::Triangulation<3, 3> &triangulation, double azimuth);

} // namespace stemware::fem
