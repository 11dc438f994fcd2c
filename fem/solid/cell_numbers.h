#pragma once

#include <deal.II/grid/cell_id.h>
#include <deal.II/grid/tria.h>

#include <vector>

namespace stemware::fem
{

/// Global numbers of the active cells of a distributed mesh: positions in the sorted list of all cell ids.
class CellNumbers
{
public:
  /// Numbers the cells of @p mesh, which must outlive the numbers. Collective.
  explicit CellNumbers(const dealii::Triangulation<3> &mesh);

  std::size_t size() const { return cells.size(); }
  /// Returns the number of cell @p id or its active ancestor. Throws std::logic_error if there is none.
  std::size_t operator()(const dealii::CellId &id) const;

  /// Returns groups of cells of equal radius and height: rings on a mesh of revolution. Collective.
  std::vector<std::vector<std::size_t>> rings() const;

private:
  const dealii::Triangulation<3> &mesh;
  std::vector<dealii::CellId> cells;
};

} // namespace stemware::fem
