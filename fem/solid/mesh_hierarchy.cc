#include "fem/solid/mesh_hierarchy.h"

#include "fem/solid/solid_contact_zone.h"

namespace stemware::fem
{

using namespace dealii;

std::vector<LevelElements> levels_of(const Triangulation<3> &triangulation, unsigned int degree)
{
  std::vector<LevelElements> levels;
  for (const auto &mesh :
       MGTransferGlobalCoarseningTools::create_geometric_coarsening_sequence(triangulation))
  {
    if (levels.empty() && degree > 1)
      levels.push_back({ mesh, 1 });
    levels.push_back({ mesh, degree });
  }
  return levels;
}

MeshHierarchy::MeshHierarchy(const std::vector<LevelElements> &elements, unsigned int mapping_degree,
                             const ElasticMaterial &material)
{
  for (const auto &[mesh, degree] : elements)
    levels.push_back(std::make_unique<SolidLevel>(mesh, degree, mapping_degree));
  cycles.resize(n_levels());
  find_contact_nodes();
  matrices.resize(0, n_levels() - 1);
  for (unsigned int l = 0; l < n_levels(); ++l)
    matrices[l].reinit(*levels[l], material, nodes[l]);
  make_transfer();
  make_smoothers();
  coarse_solver = std::make_unique<CoarseSolver>(*levels[0], matrices[0], material, nodes[0]);
  matrix.initialize(matrices);
}

void MeshHierarchy::find_contact_nodes()
{
  const unsigned int finest = n_levels() - 1;
  const DoFHandler<3> &dofs = levels[finest]->dof_handler;
  nodes.resize(finest + 1);
  nodes[finest] = std::make_shared<ContactNodes>(dofs.locally_owned_dofs(), contact_dofs(*levels[finest]),
                                                 dofs.get_communicator());
  interpolations.resize(finest + 1);
  for (unsigned int l = finest; l > 0; --l)
  {
    ContactInterpolation found = interpolation_between(*levels[l - 1], *levels[l], *nodes[l]);
    nodes[l - 1] = std::move(found.coarse_nodes);
    interpolations[l] = found.matrix;
  }
}

void MeshHierarchy::make_transfer()
{
  const unsigned int finest = n_levels() - 1;
  transfers.resize(0, finest);
  std::vector<AffineConstraints<float>> constraints(finest + 1);
  for (unsigned int l = 0; l <= finest; ++l)
    constraints[l].copy_from(levels[l]->constraints);
  for (unsigned int l = 1; l <= finest; ++l)
  {
    const DoFHandler<3> &fine = levels[l]->dof_handler;
    const DoFHandler<3> &coarse = levels[l - 1]->dof_handler;
    if (fine.get_fe().degree > coarse.get_fe().degree)
      transfers[l].reinit_polynomial_transfer(fine, coarse, constraints[l], constraints[l - 1]);
    else
      transfers[l].reinit_geometric_transfer(fine, coarse, constraints[l], constraints[l - 1]);
  }
  transfer = std::make_unique<Transfer>(transfers, [this](unsigned int l, FloatVector &vector)
                                        { matrices[l].initialize_dof_vector(vector); });
#if !DEAL_II_VERSION_GTE(9, 5, 0)
  transfers.resize(0, 0); // before deal.II 9.5, `transfer` has its own copy
#endif
}

void MeshHierarchy::make_smoothers()
{
  const unsigned int finest = n_levels() - 1;
  MGLevelObject<LevelSmoother::AdditionalData> data(0, finest);
  for (unsigned int l = 0; l <= finest; ++l)
    data[l] = smoothing_of(matrices[l]);
  smoother.initialize(matrices, data);
  for (unsigned int l = 1; l <= finest; ++l)
  {
    FloatVector vector;
    matrices[l].initialize_dof_vector(vector);
    smoother[l].estimate_eigenvalues(vector);
  }
}

MeshHierarchy::Cycle::Cycle(const MeshHierarchy &hierarchy, unsigned int l)
    : multigrid(hierarchy.matrix, *hierarchy.coarse_solver, *hierarchy.transfer, hierarchy.smoother,
                hierarchy.smoother, 0, l)
    , preconditioner(hierarchy.level(l).dof_handler, multigrid, *hierarchy.transfer)
{
}

void MeshHierarchy::set_contact(unsigned int l, const Eigen::SparseMatrix<double> &tangent)
{
  Eigen::SparseMatrix<double> on_level = tangent;
  on_level.prune(0., 0.);
  for (;; --l)
  {
    matrices[l].set_contact(on_level);
    if (l == 0)
      break;
    on_level = (interpolations[l].transpose() * on_level * interpolations[l]).eval();
  }
  coarse_solver->set_contact(on_level);
}

void MeshHierarchy::v_cycle(unsigned int l, Vector &dst, const Vector &src) const
{
  if (!cycles[l])
    cycles[l] = std::make_unique<Cycle>(*this, l);
  cycles[l]->preconditioner.vmult(dst, src);
}

} // namespace stemware::fem
