#include "fem/solid/multigrid_stiffness.h"

#include <utility>

namespace stemware::fem
{

MultigridStiffness::MultigridStiffness(std::shared_ptr<MeshHierarchy> meshes, unsigned int level,
                                       const ElasticMaterial &material)
    : hierarchy(std::move(meshes))
    , level(level)
    , material(material)
    , elastic(make_elastic_operator<double>(mesh().mapping, mesh().dof_handler, mesh().constraints, material))
{
}

std::unique_ptr<BodyStiffness> MultigridStiffness::coarser() const
{
  if (is_coarsest())
    return nullptr;
  return std::make_unique<MultigridStiffness>(hierarchy, level - 1, material);
}

} // namespace stemware::fem
