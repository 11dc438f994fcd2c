#include "fem/geometry/section_view.h"

#include <deal.II/grid/tria.h>

#include <algorithm>
#include <cmath>

namespace stemware::fem
{

using namespace dealii;

namespace
{

SectionPolygon in_cyclic_order(SectionPolygon corners)
{
  std::array<double, 2> centre = { 0, 0 };
  for (const auto &corner : corners)
    for (unsigned int d = 0; d < 2; ++d)
      centre[d] += corner[d] / static_cast<double>(corners.size());
  const auto direction = [&](const std::array<double, 2> &corner)
  { return std::atan2(corner[1] - centre[1], corner[0] - centre[0]); };
  std::sort(corners.begin(), corners.end(),
            [&](const auto &one, const auto &other) { return direction(one) < direction(other); });
  return corners;
}

} // namespace

std::vector<SectionPolygon> section_cells(const Triangulation<2> &triangulation)
{
  std::vector<SectionPolygon> polygons;
  for (const auto &cell : triangulation.active_cell_iterators())
  {
    SectionPolygon polygon;
    for (const unsigned int v : { 0u, 1u, 3u, 2u })
      polygon.push_back({ cell->vertex(v)[0], cell->vertex(v)[1] });
    polygons.push_back(polygon);
  }
  return polygons;
}

std::vector<SectionPolygon> section_cells(const Triangulation<3> &triangulation, double azimuth)
{
  const Point<3> outwards(std::cos(azimuth), std::sin(azimuth), 0);
  const Point<3> across(-std::sin(azimuth), std::cos(azimuth), 0);
  std::vector<SectionPolygon> polygons;
  for (const auto &cell : triangulation.active_cell_iterators())
  {
    SectionPolygon polygon;
    double outermost = 0;
    for (const unsigned int l : cell->line_indices())
    {
      const Point<3> begin = cell->line(l)->vertex(0), end = cell->line(l)->vertex(1);
      const double before = begin * across, after = end * across;
      if ((before >= 0) == (after >= 0))
        continue;
      const Point<3> point = begin + before / (before - after) * (end - begin);
      polygon.push_back({ std::max(0., point * outwards), point[2] });
      outermost = std::max(outermost, polygon.back()[0]);
    }
    if (polygon.size() > 2 && outermost > 1e-9 * cell->diameter())
      polygons.push_back(in_cyclic_order(std::move(polygon)));
  }
  return polygons;
}

} // namespace stemware::fem
