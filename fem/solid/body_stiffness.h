#pragma once

#include "fem/solid/mesh_hierarchy.h"

#include <deal.II/lac/la_parallel_vector.h>

#include <Eigen/SparseCore>

#include <memory>

namespace stemware::fem
{

/// The stiffness K of a body, and an approximate inverse of K + B' T B, T that of the table between its
/// contact nodes: what a SolidBody is solved with.
class BodyStiffness
{
public:
  using Vector = dealii::LinearAlgebra::distributed::Vector<double>;
  using FloatVector = dealii::LinearAlgebra::distributed::Vector<float>;

  virtual ~BodyStiffness() = default;

  virtual const SolidLevel &mesh() const = 0;
  virtual std::shared_ptr<const ContactNodes> contact_nodes() const = 0;
  /// Zero, with a place for each unknown of this rank.
  virtual void initialize(Vector &vector) const = 0;

  /// @p dst = K @p src.
  virtual void vmult(Vector &dst, const Vector &src) const = 0;
  /// T from now on, this rank's part of it, for precondition().
  virtual void set_contact(const Eigen::SparseMatrix<double> &tangent) = 0;
  /// @p dst is an approximate solution of (K + B' T B) dst = @p src: symmetric and positive definite.
  virtual void precondition(Vector &dst, const Vector &src) const = 0;
  /// The same for another system, in turn with this one; nothing where one would feel the other's T.
  virtual std::unique_ptr<BodyStiffness> shared() const { return nullptr; }
  /// How many iterations that has cost the last system, of which set_contact() may learn.
  virtual void learn(unsigned int /*n_iterations*/) {}

  /// Whether there are coarser ones of the meshes that its own was refined from.
  virtual bool has_coarser() const { return false; }
  /// The stiffness of this body on the next coarser of them; nothing where there is none.
  virtual std::unique_ptr<BodyStiffness> coarser() const { return nullptr; }
  /// @p fine becomes the function that @p coarse is on the mesh of coarser(), to single precision.
  virtual void prolongate(Vector & /*fine*/, const Vector & /*coarse*/) const {}
  virtual void prolongate(FloatVector & /*fine*/, const FloatVector & /*coarse*/) const {}
};

} // namespace stemware::fem
