#include "fem/solid/cell_numbers.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <tuple>

namespace stemware::fem
{

using namespace dealii;

namespace
{

/// Sorts @p group by @p value and splits it at every gap larger than @p tolerance.
std::vector<std::vector<std::size_t>> split(std::vector<std::size_t> group, const std::vector<double> &value,
                                            double tolerance)
{
  std::sort(group.begin(), group.end(),
            [&](std::size_t i, std::size_t j) { return std::tie(value[i], i) < std::tie(value[j], j); });
  std::vector<std::vector<std::size_t>> parts;
  for (const std::size_t member : group)
  {
    if (parts.empty() || value[member] - value[parts.back().back()] > tolerance)
      parts.emplace_back();
    parts.back().push_back(member);
  }
  return parts;
}

} // namespace

CellNumbers::CellNumbers(const Triangulation<3> &mesh)
    : mesh(mesh)
{
  std::vector<CellId::binary_type> local;
  for (const auto &cell : mesh.active_cell_iterators())
    if (cell->is_locally_owned())
      local.push_back(cell->id().to_binary<3>());
  for (const auto &part : Utilities::MPI::all_gather(mesh.get_communicator(), local))
    for (const CellId::binary_type &id : part)
      cells.emplace_back(id);
  std::sort(cells.begin(), cells.end());
}

std::size_t CellNumbers::operator()(const CellId &id) const
{
  // The order of ids is lexicographic, so no active cell lies between an id and its active ancestor.
  const auto next = std::upper_bound(cells.begin(), cells.end(), id);
  if (next == cells.begin() || !(*(next - 1) == id || (next - 1)->is_ancestor_of(id)))
    throw std::logic_error("a cell that is no part of the mesh whose cells are numbered");
  return static_cast<std::size_t>(next - cells.begin()) - 1;
}

std::vector<std::vector<std::size_t>> CellNumbers::rings() const
{
  std::vector<double> radii(size(), 0), heights(size(), 0);
  for (const auto &cell : mesh.active_cell_iterators())
    if (cell->is_locally_owned())
    {
      const std::size_t number = (*this)(cell->id());
      const Point<3> centre = cell->center();
      radii[number] = std::hypot(centre[0], centre[1]);
      heights[number] = centre[2];
    }
  for (std::vector<double> *values : { &radii, &heights })
    Utilities::MPI::sum(*values, mesh.get_communicator(), *values);
  const double tolerance = 1e-7 * *std::max_element(radii.begin(), radii.end());
  std::vector<std::size_t> numbers(size());
  std::iota(numbers.begin(), numbers.end(), std::size_t(0));
  std::vector<std::vector<std::size_t>> rings;
  for (const auto &at_radius : split(numbers, radii, tolerance))
    for (auto &ring : split(at_radius, heights, tolerance))
      rings.push_back(std::move(ring));
  return rings;
}

} // namespace stemware::fem
