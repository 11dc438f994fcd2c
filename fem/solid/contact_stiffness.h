#pragma once

#include "fem/solid/contact_nodes.h"

#include <deal.II/lac/la_parallel_vector.h>

#include <Eigen/SparseCore>

#include <memory>

namespace stemware::fem
{

struct SolidLevel;

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
                 const dealii::LinearAlgebra::distributed::Vector<Number> &src) const;

  /// Adds the row sums of |T| over all parts: a diagonal bound of T.
  void add_row_sums(dealii::LinearAlgebra::distributed::Vector<float> &diagonal) const;

private:
  std::shared_ptr<const ContactNodes> contact_nodes;
  bool is_zero = true; ///< same value on all ranks
  RowMatrix stiffness;
};

/// Contact nodes of a coarse mesh, and their interpolation to the contact nodes of a finer mesh.
struct ContactInterpolation
{
  std::shared_ptr<const ContactNodes> coarse_nodes; ///< contact_dofs(), and nodes used by the rows
  Eigen::SparseMatrix<double> matrix;               ///< shape [n fine, n coarse]
};

/// Returns the interpolation from contact nodes of @p coarse to @p fine_nodes of @p fine. Cells of the two
/// meshes are equal or parent and child; elements and ranks may differ.
ContactInterpolation interpolation_between(const SolidLevel &coarse, const SolidLevel &fine,
                                           const ContactNodes &fine_nodes);

} // namespace stemware::fem
