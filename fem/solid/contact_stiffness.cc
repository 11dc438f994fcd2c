#include "fem/solid/contact_stiffness.h"

#include "fem/geometry/boundary_ids.h"
#include "fem/solid/solid_contact_zone.h"

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe.h>
#include <deal.II/grid/cell_id.h>

#include <algorithm>
#include <map>
#include <stdexcept>

namespace stemware::fem
{

using namespace dealii;
using types::global_dof_index;

namespace
{

constexpr auto contact_zone_id = static_cast<types::boundary_id>(FootBoundary::contact_zone);

/// Which contact nodes a cell's shapes belong to, with which weights: one each, unless the shape's own node
/// hangs on others.
struct NodeShare
{
  unsigned int shape;
  unsigned int node;
  double weight;

  template <typename Archive>
  void serialize(Archive &archive, unsigned int)
  {
    archive &shape &node &weight;
  }
};
using NodeShares = std::vector<NodeShare>;

class NodeIndex
{
public:
  NodeIndex(const ContactElements &elements)
      : elements(elements)
      , nodes(contact_dofs(elements.dof_handler, elements.constraints))
  {
  }

  std::size_t size() const { return nodes.size(); }

  /// Calls @p visit(cell id, shares) for this rank's cells that have contact nodes, of faces, edges or
  /// corners.
  template <typename Visit>
  void for_each_cell(const Visit &visit) const
  {
    const FiniteElement<3> &element = elements.dof_handler.get_fe();
    std::vector<global_dof_index> cell_dofs(element.n_dofs_per_cell());
    for (const auto &cell : elements.dof_handler.active_cell_iterators())
    {
      if (!cell->is_locally_owned())
        continue;
      cell->get_dof_indices(cell_dofs);
      NodeShares shares;
      for (unsigned int i = 0; i < cell_dofs.size(); ++i)
        if (element.system_to_component_index(i).first == 2)
          add_shares(i, cell_dofs[i], shares);
      if (!shares.empty())
        visit(cell->id(), shares);
    }
  }

  bool is_hanging(unsigned int shape, const NodeShares &shares) const
  {
    return std::count_if(shares.begin(), shares.end(),
                         [shape](const NodeShare &share) { return share.shape == shape; }) > 1;
  }

private:
  void add_shares(unsigned int shape, global_dof_index dof, NodeShares &shares) const
  {
    if (!elements.constraints.is_constrained(dof))
      add_share(shape, dof, 1, shares);
    else
      for (const auto &[other, weight] : *elements.constraints.get_constraint_entries(dof))
        add_share(shape, other, weight, shares);
  }

  void add_share(unsigned int shape, global_dof_index dof, double weight, NodeShares &shares) const
  {
    const auto place = std::lower_bound(nodes.begin(), nodes.end(), dof);
    if (place != nodes.end() && *place == dof)
      shares.push_back({ shape, static_cast<unsigned int>(place - nodes.begin()), weight });
  }

  const ContactElements elements;
  const std::vector<global_dof_index> nodes;
};

/// A row of the interpolation, as it travels between ranks.
using Entry = std::array<double, 3>;

} // namespace

std::vector<global_dof_index> contact_dofs(const DoFHandler<3> &dof_handler,
                                           const AffineConstraints<double> &constraints)
{
  ComponentMask vertical(3, false);
  vertical.set(2, true);
  const IndexSet on_zone = DoFTools::extract_boundary_dofs(dof_handler, vertical, { contact_zone_id });
  std::vector<global_dof_index> local;
  for (const auto dof : on_zone)
    if (!constraints.is_constrained(dof))
      local.push_back(dof);
    else
      for (const auto &entry : *constraints.get_constraint_entries(dof))
        local.push_back(entry.first);
  std::vector<global_dof_index> all;
  for (const auto &part : Utilities::MPI::all_gather(dof_handler.get_communicator(), local))
    all.insert(all.end(), part.begin(), part.end());
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

ContactStiffness::ContactStiffness(const DoFHandler<3> &dof_handler,
                                   const AffineConstraints<double> &constraints)
    : communicator(dof_handler.get_communicator())
    , node_dofs(contact_dofs(dof_handler, constraints))
    , stiffness(n_nodes(), n_nodes())
{
  const IndexSet &owned = dof_handler.locally_owned_dofs();
  for (std::size_t i = 0; i < node_dofs.size(); ++i)
    if (owned.is_element(node_dofs[i]))
      owned_nodes.emplace_back(static_cast<Eigen::Index>(i),
                               static_cast<unsigned int>(owned.index_within_set(node_dofs[i])));
  for (const HorizontalDofs &dofs : owned_horizontal_dofs(dof_handler, node_dofs))
    owned_horizontal.push_back({ dofs.node, static_cast<unsigned int>(owned.index_within_set(dofs.x)),
                                 static_cast<unsigned int>(owned.index_within_set(dofs.y)) });
}

void ContactStiffness::scatter_friction_add(const Eigen::VectorXd &nodal, const Eigen::MatrixX2d &friction,
                                            LinearAlgebra::distributed::Vector<double> &vector) const
{
  for (const auto &[node, x, y] : owned_horizontal)
  {
    vector.local_element(x) += friction(node, 0) * nodal(node);
    vector.local_element(y) += friction(node, 1) * nodal(node);
  }
}

void ContactStiffness::set(const Eigen::SparseMatrix<double> &tangent)
{
  stiffness = tangent;
  stiffness.prune(0., 0.);
}

template <typename Number>
Eigen::VectorXd ContactStiffness::gather(const LinearAlgebra::distributed::Vector<Number> &vector) const
{
  Eigen::VectorXd nodal = Eigen::VectorXd::Zero(n_nodes());
  for (const auto &[node, i] : owned_nodes)
    nodal(node) = vector.local_element(i);
  if (Utilities::MPI::n_mpi_processes(communicator) > 1)
  {
    const ArrayView<double> values(nodal.data(), n_nodes());
    Utilities::MPI::sum(ArrayView<const double>(values), communicator, values);
  }
  return nodal;
}

template <typename Number>
void ContactStiffness::vmult_add(LinearAlgebra::distributed::Vector<Number> &dst,
                                 const LinearAlgebra::distributed::Vector<Number> &src) const
{
  if (stiffness.nonZeros() == 0)
    return;
  const Eigen::VectorXd nodal = gather(src);
  for (const auto &[node, i] : owned_nodes)
  {
    double force = 0;
    for (RowMatrix::InnerIterator entry(stiffness, node); entry; ++entry)
      force += entry.value() * nodal(entry.col());
    dst.local_element(i) += static_cast<Number>(force);
  }
}

template <typename Number>
void ContactStiffness::add_row_sums(LinearAlgebra::distributed::Vector<Number> &diagonal) const
{
  for (const auto &[node, i] : owned_nodes)
    for (RowMatrix::InnerIterator entry(stiffness, node); entry; ++entry)
      diagonal.local_element(i) += static_cast<Number>(std::abs(entry.value()));
}

void ContactStiffness::scatter_add(const Eigen::VectorXd &nodal,
                                   LinearAlgebra::distributed::Vector<double> &vector) const
{
  for (const auto &[node, i] : owned_nodes)
    vector.local_element(i) += nodal(node);
}

Eigen::SparseMatrix<double> interpolation_between(const ContactElements &coarse, const ContactElements &fine)
{
  const NodeIndex coarse_nodes(coarse), fine_nodes(fine);
  std::vector<std::pair<CellId::binary_type, NodeShares>> local_cells;
  coarse_nodes.for_each_cell([&](const CellId &id, const NodeShares &shares)
                             { local_cells.emplace_back(id.to_binary<3>(), shares); });
  std::map<CellId, NodeShares> coarse_cells;
  const MPI_Comm &communicator = fine.dof_handler.get_communicator();
  for (const auto &part : Utilities::MPI::all_gather(communicator, local_cells))
    for (const auto &[id, shares] : part)
      coarse_cells.emplace(CellId(id), shares);

  const std::vector<Point<3>> &points = fine.dof_handler.get_fe().get_unit_support_points();
  std::vector<Entry> local;
  fine_nodes.for_each_cell(
    [&](const CellId &id, const NodeShares &shares)
    {
      auto cell = coarse_cells.find(id);
      unsigned int child = numbers::invalid_unsigned_int;
      if (cell == coarse_cells.end())
      {
        const auto children = id.get_child_indices();
        if (children.size() == 0)
          return;
        std::vector<std::uint8_t> ancestors(children.begin(), children.end());
        child = ancestors.back();
        ancestors.pop_back();
        cell = coarse_cells.find(CellId(id.get_coarse_cell_id(), ancestors));
        if (cell == coarse_cells.end()) // the cell only touches the zone, and has a neighbour in it
          return;
      }
      for (const NodeShare &row : shares)
      {
        if (row.weight != 1 || fine_nodes.is_hanging(row.shape, shares))
          continue;
        const Point<3> point = child == numbers::invalid_unsigned_int
                                 ? points[row.shape]
                                 : GeometryInfo<3>::child_to_cell_coordinates(points[row.shape], child);
        std::map<unsigned int, double> values;
        for (const NodeShare &column : cell->second)
          values[column.node] +=
            column.weight * coarse.dof_handler.get_fe().shape_value_component(column.shape, point, 2);
        for (const auto &[node, value] : values)
          local.push_back({ double(row.node), double(node), value });
      }
    });
  std::vector<Eigen::Triplet<double>> entries;
  for (const auto &part : Utilities::MPI::all_gather(communicator, local))
    for (const Entry &entry : part)
      if (std::abs(entry[2]) > 1e-12)
        entries.emplace_back(static_cast<Eigen::Index>(entry[0]), static_cast<Eigen::Index>(entry[1]),
                             entry[2]);
  Eigen::SparseMatrix<double> interpolation(static_cast<Eigen::Index>(fine_nodes.size()),
                                            static_cast<Eigen::Index>(coarse_nodes.size()));
  // Neighbouring faces say the same about the nodes that they share.
  interpolation.setFromTriplets(entries.begin(), entries.end(), [](double, double last) { return last; });
  return interpolation;
}

template void ContactStiffness::vmult_add(LinearAlgebra::distributed::Vector<double> &,
                                          const LinearAlgebra::distributed::Vector<double> &) const;
template void ContactStiffness::vmult_add(LinearAlgebra::distributed::Vector<float> &,
                                          const LinearAlgebra::distributed::Vector<float> &) const;
template void ContactStiffness::add_row_sums(LinearAlgebra::distributed::Vector<float> &) const;
template Eigen::VectorXd ContactStiffness::gather(const LinearAlgebra::distributed::Vector<double> &) const;
template Eigen::VectorXd ContactStiffness::gather(const LinearAlgebra::distributed::Vector<float> &) const;

} // namespace stemware::fem
