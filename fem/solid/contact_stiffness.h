#pragma once

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <Eigen/SparseCore>

#include <array>
#include <vector>

namespace stemware::fem
{

/// Dofs of the vertical displacement on the faces with FootBoundary::contact_zone, of all ranks, ascending:
/// the order of the contact nodes. Hanging nodes are replaced by those that they hang on.
std::vector<dealii::types::global_dof_index>
contact_dofs(const dealii::DoFHandler<3> &dof_handler, const dealii::AffineConstraints<double> &constraints);

/// The contact nodes of a mesh among its dofs, and the table's share B' T B of the tangent stiffness.
class ContactStiffness
{
public:
  using RowMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

  ContactStiffness(const dealii::DoFHandler<3> &dof_handler,
                   const dealii::AffineConstraints<double> &constraints);

  unsigned int n_nodes() const { return static_cast<unsigned int>(node_dofs.size()); }
  const std::vector<dealii::types::global_dof_index> &dofs() const { return node_dofs; }

  /// T of ContactForces [N/m], shape [n_nodes, n_nodes], the same on all ranks.
  void set(const Eigen::SparseMatrix<double> &tangent);
  /// T without the entries that are 0.
  const RowMatrix &matrix() const { return stiffness; }

  /// Adds B' T B @p src to @p dst.
  template <typename Number>
  void vmult_add(dealii::LinearAlgebra::distributed::Vector<Number> &dst,
                 const dealii::LinearAlgebra::distributed::Vector<Number> &src) const;

  /// Adds the sums of the rows' absolute values: a diagonal that T does not exceed.
  template <typename Number>
  void add_row_sums(dealii::LinearAlgebra::distributed::Vector<Number> &diagonal) const;

  /// Adds B' @p nodal.
  void scatter_add(const Eigen::VectorXd &nodal,
                   dealii::LinearAlgebra::distributed::Vector<double> &vector) const;
  /// Adds what @p friction of shape [n_nodes, 2] makes of the normal forces @p nodal, horizontally.
  void scatter_friction_add(const Eigen::VectorXd &nodal, const Eigen::MatrixX2d &friction,
                            dealii::LinearAlgebra::distributed::Vector<double> &vector) const;
  /// B @p vector, the same on all ranks.
  template <typename Number>
  Eigen::VectorXd gather(const dealii::LinearAlgebra::distributed::Vector<Number> &vector) const;

private:
  MPI_Comm communicator;
  std::vector<dealii::types::global_dof_index> node_dofs;
  /// Contact nodes of this rank, and where they are among its dofs.
  std::vector<std::pair<Eigen::Index, unsigned int>> owned_nodes;
  /// Contact node, and where its displacement along x and y is among this rank's dofs.
  std::vector<std::array<unsigned int, 3>> owned_horizontal;
  RowMatrix stiffness;
};

/// A mesh's finite elements, as far as its contact nodes are concerned.
struct ContactElements
{
  const dealii::DoFHandler<3> &dof_handler;
  const dealii::AffineConstraints<double> &constraints;
};

/// Values at the contact nodes of @p fine of functions given at those of @p coarse, shape [n fine, n coarse].
/// The cells of the two are the same or parent and child; elements and ranks may differ.
Eigen::SparseMatrix<double> interpolation_between(const ContactElements &coarse, const ContactElements &fine);

} // namespace stemware::fem
