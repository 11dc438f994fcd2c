#pragma once

#include <deal.II/distributed/tria.h>
#include <deal.II/grid/cell_id.h>

#include <vector>

namespace stemware::fem
{

/// Global numbers of the active cells of a distributed mesh, independent of the number of ranks: positions in
/// the sorted list of all cell ids.
class CellNumbers
{
public:
  /// Collective; the same on all ranks. @p mesh must outlive it.
  explicit CellNumbers(const dealii::Triangulation<3> &mesh);

  std::size_t size() const { return cells.size(); }
  /// Returns the number of the cell @p id, or of its active ancestor. Throws std::logic_error if there is
  /// none.
  std::size_t operator()(const dealii::CellId &id) const;

  /// Returns groups of cells at the same radius and height: rings of cells on a foot of revolution, single
  /// cells on a mesh without symmetry. Collective.
  std::vector<std::vector<std::size_t>> rings() const;

private:
  const dealii::Triangulation<3> &mesh;
  std::vector<dealii::CellId> cells;
};

/// Halves the cells with the numbers @p marked in all directions, and neighbours so that adjacent cells
/// differ by at most one level. Collective.
void halve(dealii::parallel::distributed::Triangulation<3> &mesh, const std::vector<unsigned int> &marked);

} // namespace stemware::fem
