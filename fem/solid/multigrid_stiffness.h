#pragma once

#include "fem/geometry/elastic_material.h"
#include "fem/solid/body_stiffness.h"

namespace stemware::fem
{

/// Stiffness on one level of a MeshHierarchy, without a matrix, with V-cycles in single precision.
class MultigridStiffness : public BodyStiffness
{
public:
  MultigridStiffness(const std::shared_ptr<MeshHierarchy> &meshes, unsigned int level,
                     const ElasticMaterial &material)
      : hierarchy(meshes)
      , level(level)
      , material(material)
      , elastic(
          make_elastic_operator<double>(mesh().mapping, mesh().dof_handler, mesh().constraints, material))
  {
  }

  const SolidLevel &mesh() const override { return hierarchy->level(level); }
  std::shared_ptr<const ContactNodes> contact_nodes() const override
  {
    return hierarchy->contact_nodes(level);
  }
  void initialize(Vector &vector) const override { elastic->initialize_dof_vector(vector); }
  void vmult(Vector &dst, const Vector &src) const override { elastic->vmult(dst, src); }
  void set_contact(const Eigen::SparseMatrix<double> &tangent) override
  {
    hierarchy->set_contact(level, tangent);
  }
  void precondition(Vector &dst, const Vector &src) const override { hierarchy->v_cycle(level, dst, src); }
  /// Returns a copy: each system sets its T before it is solved.
  std::unique_ptr<BodyStiffness> shared() const override
  {
    return std::make_unique<MultigridStiffness>(*this);
  }
  bool has_coarser_mesh() const override { return level > hierarchy->coarsest_mesh(); }
  std::unique_ptr<BodyStiffness> coarser() const override
  {
    return has_coarser_mesh() ? std::make_unique<MultigridStiffness>(hierarchy, level - 1, material)
                              : nullptr;
  }
  void prolongate(Vector &fine, const Vector &coarse) const override
  {
    hierarchy->prolongate(level, fine, coarse);
  }
  void prolongate(FloatVector &fine, const FloatVector &coarse) const override
  {
    hierarchy->prolongate(level, fine, coarse);
  }

private:
  const std::shared_ptr<MeshHierarchy> hierarchy;
  const unsigned int level;
  const ElasticMaterial material;
  const std::shared_ptr<const ElasticOperator<double>> elastic;
};

} // namespace stemware::fem
