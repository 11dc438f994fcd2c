#include "fem/geometry/boundary_ids.h"
#include "fem/solid/solid_contact_zone.h"
#include "fem/solid/solid_level.h"

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe.h>
#include <deal.II/grid/cell_id.h>

#include <boost/serialization/utility.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace stemware::fem
{

using namespace dealii;
using types::global_dof_index;

namespace
{

using BinaryId = CellId::binary_type;

/// Weight of a dof in a shape function. At a hanging node, several dofs share a shape function.
struct DofShare
{
  unsigned int shape;
  global_dof_index dof;
  double weight;

  template <typename Archive>
  void serialize(Archive &archive, unsigned int)
  {
    archive &shape &dof &weight;
  }
};
using DofShares = std::vector<DofShare>;

/// Row of the interpolation matrix for one fine node: coarse dofs with their weights.
using Row = std::vector<std::pair<global_dof_index, double>>;

template <typename T>
using ToRanks = std::map<unsigned int, std::vector<T>>;

DofShares shares_of(const SolidLevel &elements, const DoFHandler<3>::active_cell_iterator &cell)
{
  const FiniteElement<3> &element = elements.dof_handler.get_fe();
  std::vector<global_dof_index> dofs(element.n_dofs_per_cell());
  cell->get_dof_indices(dofs);
  DofShares shares;
  for (unsigned int i = 0; i < dofs.size(); ++i)
  {
    if (element.system_to_component_index(i).first != 2)
      continue;
    if (!elements.constraints.is_constrained(dofs[i]))
      shares.push_back({ i, dofs[i], 1 });
    else
      for (const auto &[dof, weight] : *elements.constraints.get_constraint_entries(dofs[i]))
        shares.push_back({ i, dof, weight });
  }
  return shares;
}

/// Returns the shares of all cells of all ranks that have contact nodes. Collective.
std::map<BinaryId, DofShares> cells_at_contact_nodes(const SolidLevel &elements)
{
  const DoFHandler<3> &dof_handler = elements.dof_handler;
  ComponentMask vertical(3, false);
  vertical.set(2, true);
  IndexSet near_zone = DoFTools::extract_boundary_dofs(
    dof_handler, vertical, { static_cast<types::boundary_id>(FootBoundary::contact_zone) });
  const std::vector<global_dof_index> resolved = contact_dofs(elements);
  near_zone.add_indices(resolved.begin(), resolved.end());
  std::vector<std::pair<BinaryId, DofShares>> own;
  for (const auto &cell : dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
    {
      DofShares shares = shares_of(elements, cell);
      if (std::any_of(shares.begin(), shares.end(),
                      [&](const DofShare &share) { return near_zone.is_element(share.dof); }))
        own.emplace_back(cell->id().to_binary<3>(), std::move(shares));
    }
  std::map<BinaryId, DofShares> cells;
  for (const auto &part : Utilities::MPI::all_gather(dof_handler.get_communicator(), own))
    cells.insert(part.begin(), part.end());
  return cells;
}

/// Returns the parent of a cell and the cell's child number; std::nullopt for a cell of the coarsest mesh.
std::optional<std::pair<BinaryId, unsigned int>> parent_of(const CellId &id)
{
  const auto children = id.get_child_indices();
  if (children.size() == 0)
    return std::nullopt;
  std::vector<std::uint8_t> ancestors(children.begin(), children.end());
  const unsigned int child = ancestors.back();
  ancestors.pop_back();
  return std::pair(CellId(id.get_coarse_cell_id(), ancestors).to_binary<3>(), child);
}

std::vector<Row> owned_rows(const SolidLevel &coarse, const SolidLevel &fine, const ContactNodes &fine_nodes)
{
  const FiniteElement<3> &coarse_element = coarse.dof_handler.get_fe();
  const std::vector<Point<3>> &points = fine.dof_handler.get_fe().get_unit_support_points();
  const std::map<BinaryId, DofShares> coarse_cells = cells_at_contact_nodes(coarse);
  std::vector<global_dof_index> dofs(fine.dof_handler.get_fe().n_dofs_per_cell());
  std::vector<Row> rows(fine_nodes.n_owned_nodes());
  for (const auto &cell : fine.dof_handler.active_cell_iterators())
  {
    if (!cell->is_locally_owned())
      continue;
    const CellId id = cell->id();
    const auto same = coarse_cells.find(id.to_binary<3>());
    const auto parent = parent_of(id);
    const auto place = same == coarse_cells.end() && parent ? coarse_cells.find(parent->first) : same;
    if (place ==
        coarse_cells.end()) // the cell at most touches the zone; a neighbour in the zone gives the rows
      continue;
    cell->get_dof_indices(dofs);
    for (unsigned int i = 0; i < dofs.size(); ++i)
    {
      const unsigned int node = fine_nodes.find(dofs[i]);
      if (node >= rows.size() || !rows[node].empty()) // neighbouring cells give the same row
        continue;
      const Point<3> point =
        place == same ? points[i] : GeometryInfo<3>::child_to_cell_coordinates(points[i], parent->second);
      std::map<global_dof_index, double> values;
      for (const DofShare &share : place->second)
        values[share.dof] += share.weight * coarse_element.shape_value_component(share.shape, point, 2);
      for (const auto &[dof, value] : values)
        if (std::abs(value) > 1e-12)
          rows[node].emplace_back(dof, value);
    }
  }
  return rows;
}

} // namespace

ContactInterpolation interpolation_between(const SolidLevel &coarse, const SolidLevel &fine,
                                           const ContactNodes &fine_nodes)
{
  const MPI_Comm &communicator = fine.dof_handler.get_communicator();
  std::vector<Row> rows = owned_rows(coarse, fine, fine_nodes);

  // The answers arrive in the order of the requests.
  ToRanks<global_dof_index> questions;
  for (std::size_t i = fine_nodes.n_owned_nodes(); i < fine_nodes.n_nodes(); ++i)
    questions[fine_nodes.ghost_ranks()[i - fine_nodes.n_owned_nodes()]].push_back(fine_nodes.dofs()[i]);
  ToRanks<Row> answers;
  for (const auto &[rank, dofs] : Utilities::MPI::some_to_some(communicator, questions))
    for (const global_dof_index dof : dofs)
      answers[rank].push_back(rows[fine_nodes.find(dof)]);
  for (const auto &received : Utilities::MPI::some_to_some(communicator, answers))
    rows.insert(rows.end(), received.second.begin(), received.second.end());

  std::vector<global_dof_index> needed = contact_dofs(coarse);
  for (const Row &row : rows)
    for (const auto &entry : row)
      needed.push_back(entry.first);
  ContactInterpolation interpolation;
  interpolation.coarse_nodes =
    std::make_shared<ContactNodes>(coarse.dof_handler.locally_owned_dofs(), std::move(needed), communicator);
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (const auto &[dof, value] : rows[i])
      entries.emplace_back(static_cast<int>(i), static_cast<int>(interpolation.coarse_nodes->find(dof)),
                           value);
  interpolation.matrix.resize(fine_nodes.n_nodes(), interpolation.coarse_nodes->n_nodes());
  interpolation.matrix.setFromTriplets(entries.begin(), entries.end());
  return interpolation;
}

} // namespace stemware::fem
