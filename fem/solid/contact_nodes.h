#pragma once

#include "fem/contact/surface_parts.h"

#include <deal.II/base/index_set.h>
#include <deal.II/base/partitioner.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <Eigen/SparseCore>

#include <memory>
#include <vector>

namespace stemware::fem
{

/// Returns SurfaceParts with one part on each rank of @p communicator.
SurfaceParts parts_on_ranks(const MPI_Comm &communicator);

/// Contact nodes of a rank, in the order of their dofs: owned nodes, then ghost nodes. Nodal values come in
/// the two layouts of ContactSurface. Collective.
class ContactNodes
{
public:
  using Dof = dealii::types::global_dof_index;

  /// @p dofs: of this rank's part of the surface. Nodes in @p owned that other ranks have are added.
  ContactNodes(const dealii::IndexSet &owned, std::vector<Dof> dofs, const MPI_Comm &communicator);

  unsigned int n_nodes() const { return static_cast<unsigned int>(all_dofs.size()); }
  unsigned int n_owned_nodes() const { return static_cast<unsigned int>(places.size()); }
  /// Returns the dofs of the vertical displacement of the nodes, shape [n_nodes].
  const std::vector<Dof> &dofs() const { return all_dofs; }
  /// Returns the positions of the owned nodes among this rank's dofs, shape [n_owned_nodes].
  const std::vector<unsigned int> &owned_positions() const { return places; }
  /// Returns the number of the node with @p dof; n_nodes() if this rank does not have it.
  unsigned int find(Dof dof) const;
  const SurfaceParts &parts() const { return all_parts; }

  /// Returns the nodal values of @p vector over the dofs.
  template <typename Number>
  Eigen::VectorXd gather(const dealii::LinearAlgebra::distributed::Vector<Number> &vector) const
  {
    Eigen::VectorXd own(n_owned_nodes());
    for (unsigned int i = 0; i < n_owned_nodes(); ++i)
      own(i) = vector.local_element(places[i]);
    return spread(own);
  }

  /// Returns the values at all nodes from the values @p own at owned nodes, shape [n_owned_nodes].
  Eigen::VectorXd spread(const Eigen::VectorXd &own) const;
  /// Returns the sums over all parts at the owned nodes; @p parts has the shape [n_nodes].
  Eigen::VectorXd summed(const Eigen::VectorXd &parts) const;
  /// Returns the Euclidean norm over all nodes of the sums of summed().
  double norm(const Eigen::VectorXd &parts) const;

  /// Adds the sums over all parts to the entries of the nodes in @p vector.
  template <typename Number>
  void scatter_add(const Eigen::VectorXd &parts,
                   dealii::LinearAlgebra::distributed::Vector<Number> &vector) const
  {
    const Eigen::VectorXd sums = summed(parts);
    for (unsigned int i = 0; i < n_owned_nodes(); ++i)
      vector.local_element(places[i]) += static_cast<Number>(sums(i));
  }

  /// Entries of a matrix between dofs.
  struct Entry
  {
    Dof row, column;
    double value;
  };
  /// Returns the owned rows of the sum of @p parts, [n_nodes, n_nodes], over all ranks; entries may repeat.
  std::vector<Entry> owned_rows(const Eigen::SparseMatrix<double> &parts) const;

private:
  MPI_Comm communicator;
  SurfaceParts all_parts;
  std::vector<Dof> all_dofs;
  std::vector<unsigned int> places;
  std::vector<unsigned int> other_ranks; ///< ranks that own the ghost nodes
  /// Work vector of nodal values, owned nodes first.
  mutable dealii::LinearAlgebra::distributed::Vector<double> values;
};

/// Contribution B' T B of the table to the tangent stiffness of a mesh.
class ContactStiffness
{
public:
  using RowMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

  explicit ContactStiffness(std::shared_ptr<const ContactNodes> nodes);

  const ContactNodes &nodes() const { return *contact_nodes; }

  /// Sets this rank's part of T of ContactForces [N/m], shape [n_nodes, n_nodes].
  void set(const Eigen::SparseMatrix<double> &tangent);
  /// Returns this rank's part of T without zero entries.
  const RowMatrix &matrix() const { return stiffness; }

  /// Adds B' T B @p src to @p dst.
  template <typename Number>
  void vmult_add(dealii::LinearAlgebra::distributed::Vector<Number> &dst,
                 const dealii::LinearAlgebra::distributed::Vector<Number> &src) const
  {
    if (!is_zero)
      contact_nodes->scatter_add(stiffness * contact_nodes->gather(src), dst);
  }

  /// Adds the row sums of |T| over all parts: a diagonal bound of T.
  void add_row_sums(dealii::LinearAlgebra::distributed::Vector<float> &diagonal) const;

private:
  std::shared_ptr<const ContactNodes> contact_nodes;
  bool is_zero = true; ///< same value on all ranks
  RowMatrix stiffness;
};

} // namespace stemware::fem
