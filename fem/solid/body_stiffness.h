#pragma once

#include "fem/solid/mesh_hierarchy.h"

#include <deal.II/lac/la_parallel_vector.h>

#include <Eigen/SparseCore>

#include <memory>

namespace stemware::fem
{

/// Stiffness K of a SolidBody, and an approximate inverse of K + B' T B with the table's tangent T.
class BodyStiffness
{
public:
  using Vector = dealii::LinearAlgebra::distributed::Vector<double>;
  using FloatVector = dealii::LinearAlgebra::distributed::Vector<float>;

  virtual ~BodyStiffness() = default;

  virtual const SolidLevel &mesh() const = 0;
  virtual std::shared_ptr<const ContactNodes> contact_nodes() const = 0;
  /// Returns a zero vector of this rank's unknowns.
  virtual void initialize(Vector &vector) const = 0;

  /// Computes @p dst = K @p src.
  virtual void vmult(Vector &dst, const Vector &src) const = 0;
  /// Sets T (this rank's part of it) for precondition().
  virtual void set_contact(const Eigen::SparseMatrix<double> &tangent) = 0;
  /// Computes an approximate solution @p dst of (K + B' T B) dst = @p src; symmetric and positive definite.
  virtual void precondition(Vector &dst, const Vector &src) const = 0;
  /// Returns a stiffness that shares memory with this one, for a second system solved alternately, each after
  /// its set_contact(). nullptr: not supported.
  virtual std::unique_ptr<BodyStiffness> shared() const { return nullptr; }

  /// Returns whether the mesh was refined from a coarser mesh.
  virtual bool has_coarser_mesh() const { return false; }
  /// Returns the stiffness of this body on the next coarser mesh, if any.
  virtual std::unique_ptr<BodyStiffness> coarser() const { return nullptr; }
  /// Interpolates @p coarse on the mesh of coarser() to @p fine, in single precision.
  virtual void prolongate(Vector & /*fine*/, const Vector & /*coarse*/) const {}
  virtual void prolongate(FloatVector & /*fine*/, const FloatVector & /*coarse*/) const {}
};

} // namespace stemware::fem
