#pragma once

#include "fem/geometry/elastic_material.h"
#include "fem/solid/mesh_hierarchy.h"

#include <deal.II/lac/la_parallel_vector.h>

#include <Eigen/SparseCore>

#include <memory>

namespace stemware::fem
{

/// Stiffness K of a SolidBody on one level of a MeshHierarchy, without a matrix, and an approximate inverse
/// of K + B' T B with the table's tangent T: V-cycles in single precision. Copies share memory; each system
/// sets its T before it is solved.
class BodyStiffness
{
public:
  using Vector = MeshHierarchy::Vector;

  BodyStiffness(const std::shared_ptr<MeshHierarchy> &meshes, unsigned int level,
                const ElasticMaterial &material)
      : material(material)
      , hierarchy(meshes)
      , level(level)
      , elastic(
          make_elastic_operator<double>(mesh().mapping, mesh().dof_handler, mesh().constraints, material))
  {
  }
  virtual ~BodyStiffness() = default;

  const SolidLevel &mesh() const { return hierarchy->level(level); }
  std::shared_ptr<const ContactNodes> contact_nodes() const { return hierarchy->contact_nodes(level); }
  /// Returns a zero vector of this rank's unknowns.
  void initialize(Vector &vector) const { elastic->initialize_dof_vector(vector); }

  /// Computes @p dst = K @p src.
  virtual void vmult(Vector &dst, const Vector &src) const { elastic->vmult(dst, src); }
  /// Sets T (this rank's part of it) for precondition().
  virtual void set_contact(const Eigen::SparseMatrix<double> &tangent)
  {
    hierarchy->set_contact(level, tangent);
  }
  /// Computes an approximate solution @p dst of (K + B' T B) dst = @p src; symmetric and positive definite.
  virtual void precondition(Vector &dst, const Vector &src) const { hierarchy->v_cycle(level, dst, src); }

  /// Returns whether the mesh was refined from a coarser mesh.
  bool has_coarser_mesh() const { return level > hierarchy->coarsest_mesh(); }
  /// Returns the stiffness of this body on the next coarser mesh, which must exist.
  std::unique_ptr<BodyStiffness> coarser() const
  {
    return std::make_unique<BodyStiffness>(hierarchy, level - 1, material);
  }
  /// Interpolates @p coarse on the mesh of coarser() to @p fine, in single precision.
  template <typename Number>
  void prolongate(dealii::LinearAlgebra::distributed::Vector<Number> &fine,
                  const dealii::LinearAlgebra::distributed::Vector<Number> &coarse) const
  {
    hierarchy->prolongate(level, fine, coarse);
  }

  const ElasticMaterial material;

private:
  const std::shared_ptr<MeshHierarchy> hierarchy;
  const unsigned int level;
  const std::shared_ptr<const ElasticOperator<double>> elastic;
};

} // namespace stemware::fem
