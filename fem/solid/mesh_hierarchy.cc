#include "fem/solid/mesh_hierarchy.h"

#include "fem/geometry/boundary_ids.h"
#include "fem/solid/coarse_solver.h"
#include "fem/solid/conforming_mapping.h"
#include "fem/solid/solid_contact_zone.h"

#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/multigrid/mg_coarse.h>
#include <deal.II/multigrid/mg_matrix.h>
#include <deal.II/multigrid/mg_smoother.h>
#include <deal.II/multigrid/mg_transfer_global_coarsening.h>
#include <deal.II/multigrid/multigrid.h>

#include <stdexcept>

namespace stemware::fem
{

using namespace dealii;

AffineConstraints<double> clamp_stem_cut(const DoFHandler<3> &dof_handler)
{
  constexpr auto stem_cut_id = static_cast<types::boundary_id>(FootBoundary::stem_cut);
  const IndexSet clamped =
    DoFTools::extract_boundary_dofs(dof_handler, ComponentMask(3, true), { stem_cut_id });
  if (Utilities::MPI::sum(clamped.n_elements(), dof_handler.get_communicator()) == 0)
    throw std::invalid_argument(
      "The mesh has no stem cut: no boundary face carries the id 1; mark the faces where the stem was cut.");
  const IndexSet relevant = DoFTools::extract_locally_relevant_dofs(dof_handler);
  AffineConstraints<double> constraints(relevant);
  DoFTools::make_hanging_node_constraints(dof_handler, constraints);
  DoFTools::make_zero_boundary_constraints(dof_handler, stem_cut_id, constraints);
  constraints.close();
  return constraints;
}

SolidLevel::SolidLevel(std::shared_ptr<const Triangulation<3>> mesh, unsigned int degree,
                       unsigned int mapping_degree)
    : triangulation(std::move(mesh))
    , geometry(conforming_mapping(*triangulation, mapping_degree))
    , mapping(*geometry)
    , element(FE_Q<3>(degree), 3)
    , dof_handler(*triangulation)
{
  dof_handler.distribute_dofs(element);
  constraints = clamp_stem_cut(dof_handler);
}

struct MeshHierarchy::Cycle
{
  using Transfer = MGTransferGlobalCoarsening<3, FloatVector>;

  Cycle(const std::vector<LevelElements> &elements, unsigned int mapping_degree,
        const ElasticMaterial &material)
  {
    for (const auto &[mesh, degree] : elements)
      levels.push_back(std::make_unique<SolidLevel>(mesh, degree, mapping_degree));
    const auto finest = static_cast<unsigned int>(levels.size() - 1);
    cycles.resize(finest + 1);
    find_contact_nodes(finest);
    matrices.resize(0, finest);
    for (unsigned int l = 0; l <= finest; ++l)
      matrices[l].reinit(*levels[l], material, contact_nodes[l]);
    make_transfer(finest);
    make_smoothers(finest);
    coarse_solver = std::make_unique<CoarseSolver>(*levels[0], matrices[0], material, contact_nodes[0]);
    matrix.initialize(matrices);
  }

  void find_contact_nodes(unsigned int finest)
  {
    const DoFHandler<3> &dofs = levels[finest]->dof_handler;
    contact_nodes.resize(finest + 1);
    contact_nodes[finest] = std::make_shared<ContactNodes>(
      dofs.locally_owned_dofs(), contact_dofs(*levels[finest]), dofs.get_communicator());
    interpolations.resize(finest + 1);
    for (unsigned int l = finest; l > 0; --l)
    {
      ContactInterpolation found = interpolation_between(*levels[l - 1], *levels[l], *contact_nodes[l]);
      contact_nodes[l - 1] = std::move(found.coarse_nodes);
      interpolations[l] = found.matrix;
    }
  }

  void make_transfer(unsigned int finest)
  {
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

  void make_smoothers(unsigned int finest)
  {
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

  struct FromLevel
  {
    FromLevel(const Cycle &cycle, unsigned int l)
        : multigrid(cycle.matrix, *cycle.coarse_solver, *cycle.transfer, cycle.smoother, cycle.smoother, 0, l)
        , preconditioner(cycle.levels[l]->dof_handler, multigrid, *cycle.transfer)
    {
    }
    Multigrid<FloatVector> multigrid;
    PreconditionMG<3, FloatVector, Transfer> preconditioner;
  };

  std::vector<std::unique_ptr<SolidLevel>> levels;
  std::vector<std::shared_ptr<const ContactNodes>> contact_nodes;
  /// Interpolation to the contact nodes of each level from the next coarser level.
  std::vector<Eigen::SparseMatrix<double>> interpolations;
  MGLevelObject<LevelMatrix> matrices;
  MGLevelObject<MGTwoLevelTransfer<3, FloatVector>> transfers;
  std::unique_ptr<Transfer> transfer; ///< refers to `transfers`
  mg::SmootherRelaxation<LevelSmoother, FloatVector> smoother;
  std::unique_ptr<CoarseSolver> coarse_solver;
  mg::Matrix<FloatVector> matrix;
  std::vector<std::unique_ptr<FromLevel>> cycles; ///< each created on first use
};

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
    : cycle(std::make_unique<Cycle>(elements, mapping_degree, material))
{
}

MeshHierarchy::~MeshHierarchy() = default;

unsigned int MeshHierarchy::n_levels() const
{
  return static_cast<unsigned int>(cycle->levels.size());
}

unsigned int MeshHierarchy::coarsest_mesh() const
{
  return cycle->levels.front()->element.degree < cycle->levels.back()->element.degree ? 1 : 0;
}

const SolidLevel &MeshHierarchy::level(unsigned int l) const
{
  return *cycle->levels[l];
}

const std::shared_ptr<const ContactNodes> &MeshHierarchy::contact_nodes(unsigned int l) const
{
  return cycle->contact_nodes[l];
}

void MeshHierarchy::set_contact(unsigned int l, const Eigen::SparseMatrix<double> &tangent)
{
  Eigen::SparseMatrix<double> on_level = tangent;
  on_level.prune(0., 0.);
  for (;; --l)
  {
    cycle->matrices[l].set_contact(on_level);
    if (l == 0)
      break;
    on_level = (cycle->interpolations[l].transpose() * on_level * cycle->interpolations[l]).eval();
  }
  cycle->coarse_solver->set_contact(on_level);
}

void MeshHierarchy::v_cycle(unsigned int l, Vector &dst, const Vector &src) const
{
  std::unique_ptr<Cycle::FromLevel> &from = cycle->cycles[l];
  if (!from)
    from = std::make_unique<Cycle::FromLevel>(*cycle, l);
  from->preconditioner.vmult(dst, src);
}

template <typename Number>
void MeshHierarchy::prolongate(unsigned int l, LinearAlgebra::distributed::Vector<Number> &fine,
                               const LinearAlgebra::distributed::Vector<Number> &coarse) const
{
  FloatVector from, to;
  cycle->matrices[l - 1].initialize_dof_vector(from);
  cycle->matrices[l].initialize_dof_vector(to);
  from.copy_locally_owned_data_from(coarse);
  cycle->transfer->prolongate(l, to, from);
  fine.copy_locally_owned_data_from(to);
  cycle->levels[l]->constraints.set_zero(fine); // distribute() interpolates hanging nodes later
}

template void MeshHierarchy::prolongate(unsigned int, FloatVector &, const FloatVector &) const;
template void MeshHierarchy::prolongate(unsigned int, Vector &, const Vector &) const;

} // namespace stemware::fem
