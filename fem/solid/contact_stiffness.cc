#include "fem/solid/contact_stiffness.h"

#include "fem/geometry/boundary_ids.h"

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

/// The shapes of a cell that have support on its contact face: their index in the cell and their contact
/// node.
using FaceShapes = std::vector<std::pair<unsigned int, unsigned int>>;

template <typename Visit>
void for_each_contact_face(const DoFHandler<3> &dof_handler, const std::vector<global_dof_index> &node_dofs,
                           const Visit &visit)
{
  const FiniteElement<3> &element = dof_handler.get_fe();
  std::vector<global_dof_index> cell_dofs(element.n_dofs_per_cell());
  for (const auto &cell : dof_handler.active_cell_iterators())
    for (const unsigned int f : cell->face_indices())
    {
      if (!cell->is_locally_owned() || !cell->face(f)->at_boundary() ||
          cell->face(f)->boundary_id() != contact_zone_id)
        continue;
      cell->get_dof_indices(cell_dofs);
      FaceShapes shapes;
      for (unsigned int i = 0; i < cell_dofs.size(); ++i)
        if (element.system_to_component_index(i).first == 2 && element.has_support_on_face(i, f))
          shapes.emplace_back(i, std::lower_bound(node_dofs.begin(), node_dofs.end(), cell_dofs[i]) -
                                   node_dofs.begin());
      visit(cell->id(), shapes);
    }
}

std::map<CellId, FaceShapes> all_contact_faces(const DoFHandler<3> &dof_handler,
                                               const std::vector<global_dof_index> &node_dofs)
{
  std::vector<std::pair<CellId::binary_type, FaceShapes>> local;
  for_each_contact_face(dof_handler, node_dofs,
                        [&](const CellId &id, const FaceShapes &shapes)
                        { local.emplace_back(id.to_binary<3>(), shapes); });
  std::map<CellId, FaceShapes> faces;
  for (const auto &part : Utilities::MPI::all_gather(dof_handler.get_communicator(), local))
    for (const auto &[id, shapes] : part)
      faces.emplace(CellId(id), shapes);
  return faces;
}

/// A row of the interpolation, as it travels between ranks.
using Entry = std::array<double, 3>;

} // namespace

std::vector<global_dof_index> contact_dofs(const DoFHandler<3> &dof_handler)
{
  ComponentMask vertical(3, false);
  vertical.set(2, true);
  const IndexSet on_zone = DoFTools::extract_boundary_dofs(dof_handler, vertical, { contact_zone_id });
  const std::vector<global_dof_index> local(on_zone.begin(), on_zone.end());
  std::vector<global_dof_index> all;
  for (const auto &part : Utilities::MPI::all_gather(dof_handler.get_communicator(), local))
    all.insert(all.end(), part.begin(), part.end());
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

ContactStiffness::ContactStiffness(const DoFHandler<3> &dof_handler)
    : communicator(dof_handler.get_communicator())
    , node_dofs(contact_dofs(dof_handler))
    , stiffness(n_nodes(), n_nodes())
{
  const IndexSet &owned = dof_handler.locally_owned_dofs();
  for (std::size_t i = 0; i < node_dofs.size(); ++i)
    if (owned.is_element(node_dofs[i]))
      owned_nodes.emplace_back(static_cast<Eigen::Index>(i),
                               static_cast<unsigned int>(owned.index_within_set(node_dofs[i])));
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

Eigen::SparseMatrix<double> interpolation_between(const DoFHandler<3> &coarse, const DoFHandler<3> &fine)
{
  const std::vector<global_dof_index> coarse_nodes = contact_dofs(coarse);
  const std::vector<global_dof_index> fine_nodes = contact_dofs(fine);
  const std::map<CellId, FaceShapes> coarse_faces = all_contact_faces(coarse, coarse_nodes);
  const std::vector<Point<3>> &points = fine.get_fe().get_unit_support_points();
  std::vector<Entry> local;
  for_each_contact_face(fine, fine_nodes,
                        [&](const CellId &id, const FaceShapes &shapes)
                        {
                          auto face = coarse_faces.find(id);
                          unsigned int child = numbers::invalid_unsigned_int;
                          if (face == coarse_faces.end())
                          {
                            const auto children = id.get_child_indices();
                            std::vector<std::uint8_t> ancestors(children.begin(), children.end());
                            child = ancestors.back();
                            ancestors.pop_back();
                            face = coarse_faces.find(CellId(id.get_coarse_cell_id(), ancestors));
                            if (face == coarse_faces.end())
                              throw std::logic_error("a contact face of the finer mesh without a parent");
                          }
                          for (const auto &[i, row] : shapes)
                          {
                            const Point<3> point =
                              child == numbers::invalid_unsigned_int
                                ? points[i]
                                : GeometryInfo<3>::child_to_cell_coordinates(points[i], child);
                            for (const auto &[j, column] : face->second)
                              local.push_back({ double(row), double(column),
                                                coarse.get_fe().shape_value_component(j, point, 2) });
                          }
                        });
  std::vector<Eigen::Triplet<double>> entries;
  for (const auto &part : Utilities::MPI::all_gather(fine.get_communicator(), local))
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
