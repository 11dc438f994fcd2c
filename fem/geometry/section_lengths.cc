#include "fem/geometry/section_lengths.h"

#include <algorithm>
#include <limits>

namespace stemware::fem
{

SectionLengths lengths_of(const std::vector<SectionPolygon> &cells, double radius)
{
  SectionLengths lengths;
  double lower = std::numeric_limits<double>::infinity(), upper = -lower;
  for (const SectionPolygon &cell : cells)
    for (std::size_t i = 0; i < cell.size(); ++i)
    {
      const auto &begin = cell[i], &end = cell[(i + 1) % cell.size()];
      lengths.outer_radius = std::max(lengths.outer_radius, begin[0]);
      lengths.height = std::max(lengths.height, begin[1]);
      const double before = begin[0] - radius, after = end[0] - radius;
      if ((before < 0) == (after < 0))
        continue;
      const double crossing = begin[1] + before / (before - after) * (end[1] - begin[1]);
      lower = std::min(lower, crossing);
      upper = std::max(upper, crossing);
    }
  lengths.thickness = upper - lower;
  for (const SectionPolygon &cell : cells)
    for (const auto &corner : cell)
      if (corner[1] > lengths.height * (1 - 1e-6))
        lengths.stem_radius = std::max(lengths.stem_radius, corner[0]);
  return lengths;
}

} // namespace stemware::fem
