#include "fem/solid/coarse_solver.h"

#include "fem/solid/coarse_preconditioner.h"
#include "fem/solid/stiffness_3d.h"

namespace stemware::fem
{

using namespace dealii;

namespace
{

/// The preconditioner is set up again if T changes relatively by more than this bound. The smoother always
/// uses the present T.
constexpr double tolerated_change = 0.1;

/// Returns the rigid translations and rotations at the owned dofs of linear elements, one motion after the
/// other; 0 at constrained dofs. (deal.II 9.6 has DoFTools::extract_rigid_body_modes().)
std::vector<double> rigid_motions(const SolidLevel &level)
{
  const IndexSet &owned = level.dof_handler.locally_owned_dofs();
  const auto n = static_cast<std::size_t>(owned.n_elements());
  std::vector<double> modes(6 * n, 0.);
  std::vector<types::global_dof_index> dofs(level.element.n_dofs_per_cell());
  for (const auto &cell : level.dof_handler.active_cell_iterators())
  {
    if (cell->is_artificial())
      continue;
    cell->get_dof_indices(dofs);
    for (unsigned int i = 0; i < dofs.size(); ++i)
    {
      if (!owned.is_element(dofs[i]) || level.constraints.is_constrained(dofs[i]))
        continue;
      const auto [component, vertex] = level.element.system_to_component_index(i);
      const unsigned int next = (component + 1) % 3, last = (component + 2) % 3;
      const Point<3> x = cell->vertex(vertex);
      double *const at_dof = modes.data() + owned.index_within_set(dofs[i]);
      at_dof[component * n] = 1;
      at_dof[(3 + next) * n] = x[last]; // rotation e_next x x
      at_dof[(3 + last) * n] = -x[next];
    }
  }
  return modes;
}

} // namespace

CoarseSolver::CoarseSolver(const SolidLevel &level, const LevelMatrix &matrix,
                           const ElasticMaterial &material, const std::shared_ptr<const ContactNodes> &nodes)
    : level(level)
    , matrix(matrix)
    , material(material)
    , nodes(nodes)
{
  smoother.initialize(matrix, smoothing_of(matrix));
  FloatVector vector;
  matrix.initialize_dof_vector(vector);
  smoother.estimate_eigenvalues(vector);
}

void CoarseSolver::set_contact(const Eigen::SparseMatrix<double> &tangent)
{
  if (!correction)
  {
    assemble_stiffness(level.mapping, level.dof_handler, material, level.constraints, stiffness);
    modes = rigid_motions(level);
    for (Vector *vector : { &residual, &solution })
      vector->reinit(level.dof_handler.locally_owned_dofs(), level.dof_handler.get_communicator());
  }
  else
  {
    const SurfaceParts &parts = nodes->parts();
    const Eigen::SparseMatrix<double> change = tangent - aggregated;
    if (parts.sum(double(change.cwiseAbs().sum())) <=
        tolerated_change * parts.sum(double(tangent.cwiseAbs().sum())))
      return;
  }
  aggregated = tangent;
  correction.reset(); // it refers to the old `sum`
  sum.copy_from(stiffness);
  for (const ContactNodes::Entry &entry : nodes->owned_rows(tangent))
    sum.add(entry.row, entry.column, entry.value); // within the pattern of K: the nodes share a cell
  sum.compress(VectorOperation::add);
  correction = coarse_preconditioner(sum, modes);
}

void CoarseSolver::operator()(unsigned int, FloatVector &dst, const FloatVector &src) const
{
  smoother.vmult(dst, src);
  FloatVector left;
  matrix.initialize_dof_vector(left);
  matrix.vmult(left, dst);
  left.sadd(-1, 1, src);
  residual.copy_locally_owned_data_from(left);
  correction->vmult(solution, residual);
  left.copy_locally_owned_data_from(solution);
  dst += left;
  smoother.step(dst, src);
}

} // namespace stemware::fem
