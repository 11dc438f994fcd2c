#include "fem/solid/solid_contact_zone.h"
#include "fem/solid/solid_level.h"

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/index_set.h>
#include <deal.II/base/mpi.h>
#include <deal.II/fe/fe.h>
#include <deal.II/grid/cell_id.h>

#include <boost/serialization/utility.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace stemware::fem
{

using namespace dealii;
using types::global_dof_index;

namespace
{

using BinaryId = CellId::binary_type;

/// Value at a node as a sum over unconstrained dofs with weights.
using Row = std::vector<std::pair<global_dof_index, double>>;

/// Returns a row for each shape function of @p cell; empty for horizontal ones. At a hanging node, several
/// dofs share a shape function.
std::vector<Row> shares_in(const SolidLevel &elements, const DoFHandler<3>::active_cell_iterator &cell)
{
  std::vector<global_dof_index> dofs(elements.element.n_dofs_per_cell());
  cell->get_dof_indices(dofs);
  std::vector<Row> shares(dofs.size());
  for (unsigned int i = 0; i < dofs.size(); ++i)
    if (elements.element.system_to_component_index(i).first == 2)
    {
      const Row *const constrained = elements.constraints.get_constraint_entries(dofs[i]);
      shares[i] = constrained ? *constrained : Row{ { dofs[i], 1. } };
    }
  return shares;
}

/// Returns shares_in() of all cells of all ranks that have contact nodes. Collective.
std::map<BinaryId, std::vector<Row>> shares_at_contact_nodes(const SolidLevel &elements)
{
  const DoFHandler<3> &dof_handler = elements.dof_handler;
  const MPI_Comm &communicator = dof_handler.get_communicator();
  IndexSet in_zone(dof_handler.n_dofs());
  for (const auto &part : Utilities::MPI::all_gather(communicator, contact_dofs(elements)))
    in_zone.add_indices(part.begin(), part.end());
  const auto is_near = [&](const Row &row)
  {
    return std::any_of(row.begin(), row.end(),
                       [&](const auto &share) { return in_zone.is_element(share.first); });
  };
  std::vector<std::pair<BinaryId, std::vector<Row>>> own;
  for (const auto &cell : dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
      if (std::vector<Row> shares = shares_in(elements, cell);
          std::any_of(shares.begin(), shares.end(), is_near))
        own.emplace_back(cell->id().to_binary<3>(), std::move(shares));
  std::map<BinaryId, std::vector<Row>> all;
  for (const auto &part : Utilities::MPI::all_gather(communicator, own))
    all.insert(part.begin(), part.end());
  return all;
}

/// Returns the rows of this rank's contact nodes of @p fine over the dofs of @p coarse, by the fine dof.
std::vector<std::pair<global_dof_index, Row>> owned_rows(const SolidLevel &coarse, const SolidLevel &fine,
                                                         const ContactNodes &fine_nodes)
{
  const std::vector<Point<3>> &points = fine.element.get_unit_support_points();
  const std::map<BinaryId, std::vector<Row>> coarse_cells = shares_at_contact_nodes(coarse);
  std::vector<global_dof_index> dofs(fine.element.n_dofs_per_cell());
  std::vector<std::pair<global_dof_index, Row>> rows;
  for (unsigned int node = 0; node < fine_nodes.n_owned_nodes(); ++node)
    rows.emplace_back(fine_nodes.dofs()[node], Row());
  for (const auto &cell : fine.dof_handler.active_cell_iterators())
  {
    if (!cell->is_locally_owned())
      continue;
    const CellId id = cell->id();
    const auto same = coarse_cells.find(id.to_binary<3>());
    const auto place = same == coarse_cells.end() && cell->level() > 0
                         ? coarse_cells.find(cell->parent()->id().to_binary<3>())
                         : same;
    if (place == coarse_cells.end())
      continue; // the cell at most touches the zone; a neighbour in the zone gives the rows
    cell->get_dof_indices(dofs);
    for (unsigned int i = 0; i < dofs.size(); ++i)
    {
      const unsigned int node = fine_nodes.find(dofs[i]);
      if (node >= rows.size() || !rows[node].second.empty()) // neighbouring cells give the same row
        continue;
      const Point<3> point =
        place == same
          ? points[i]
          : GeometryInfo<3>::child_to_cell_coordinates(points[i], *(id.get_child_indices().end() - 1));
      std::map<global_dof_index, double> values;
      for (unsigned int shape = 0; shape < place->second.size(); ++shape)
        for (const auto &[dof, weight] : place->second[shape])
          values[dof] += weight * coarse.element.shape_value_component(shape, point, 2);
      for (const auto &[dof, value] : values)
        if (std::abs(value) > 1e-12)
          rows[node].second.emplace_back(dof, value);
    }
  }
  return rows;
}

} // namespace

ContactInterpolation interpolation_between(const SolidLevel &coarse, const SolidLevel &fine,
                                           const ContactNodes &fine_nodes)
{
  const MPI_Comm &communicator = fine.dof_handler.get_communicator();
  std::map<global_dof_index, Row> rows;
  for (const auto &part : Utilities::MPI::all_gather(communicator, owned_rows(coarse, fine, fine_nodes)))
    rows.insert(part.begin(), part.end());
  std::vector<global_dof_index> needed = contact_dofs(coarse);
  for (const global_dof_index dof : fine_nodes.dofs())
    for (const auto &entry : rows[dof])
      needed.push_back(entry.first);
  ContactInterpolation interpolation;
  interpolation.coarse_nodes =
    std::make_shared<ContactNodes>(coarse.dof_handler.locally_owned_dofs(), std::move(needed), communicator);
  std::vector<Eigen::Triplet<double>> entries;
  for (unsigned int i = 0; i < fine_nodes.n_nodes(); ++i)
    for (const auto &[dof, value] : rows[fine_nodes.dofs()[i]])
      entries.emplace_back(static_cast<int>(i), static_cast<int>(interpolation.coarse_nodes->find(dof)),
                           value);
  interpolation.matrix.resize(fine_nodes.n_nodes(), interpolation.coarse_nodes->n_nodes());
  interpolation.matrix.setFromTriplets(entries.begin(), entries.end());
  return interpolation;
}

} // namespace stemware::fem
