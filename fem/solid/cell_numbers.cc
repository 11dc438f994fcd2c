#include "fem/solid/cell_numbers.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <set>
#include <stdexcept>

namespace stemware::fem
{

using namespace dealii;

CellNumbers::CellNumbers(const Triangulation<3> &mesh)
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
  const auto children = id.get_child_indices();
  std::vector<std::uint8_t> ancestors(children.begin(), children.end());
  for (;; ancestors.pop_back())
  {
    const CellId ancestor(id.get_coarse_cell_id(), ancestors);
    const auto place = std::lower_bound(cells.begin(), cells.end(), ancestor);
    if (place != cells.end() && *place == ancestor)
      return static_cast<std::size_t>(place - cells.begin());
    if (ancestors.empty())
      throw std::logic_error("a cell that is no part of the mesh whose cells are numbered");
  }
}

void halve(parallel::distributed::Triangulation<3> &mesh, const std::vector<unsigned int> &marked)
{
  const CellNumbers number(mesh);
  const std::set<std::size_t> among(marked.begin(), marked.end());
  for (const auto &cell : mesh.active_cell_iterators())
    if (cell->is_locally_owned() && among.count(number(cell->id())) > 0)
      cell->set_refine_flag();
  mesh.execute_coarsening_and_refinement();
}

} // namespace stemware::fem
