#include "fem/solid/coarse_solver.h"

#include "fem/solid/stiffness_3d.h"

#include <Teuchos_ParameterList.hpp>
#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <ml_MultiLevelPreconditioner.h>

#include <memory>
#include <stdexcept>
#include <vector>

namespace stemware::fem
{

using namespace dealii;

namespace
{

/// Returns smoothed aggregation (ML of Trilinos) for the stiffness @p matrix of linear elements; a small
/// matrix is factorised instead. vmult() is one W-cycle, symmetric and positive semidefinite. The caller
/// smooths the finest level. The parameters are tuned on feet of 48 x 2 x 2 to 192 x 8 x 8 cells
/// (docs/method/solid_measurements.md).
///
/// @p modes: rigid motions as in rigid_motions(). References to both arguments are kept.
std::unique_ptr<dealii::TrilinosWrappers::PreconditionAMG>
coarse_preconditioner(const dealii::TrilinosWrappers::SparseMatrix &matrix, std::vector<double> &modes)
{
  Teuchos::ParameterList list;
  ML_Epetra::SetDefaults("SA", list);
  list.set("prec type", "MGW"); // W-cycle, because the iterations of a V-cycle increase with mesh refinement
  list.set("PDE equations", 3);
  list.set("null space: type", "pre-computed");
  list.set("null space: dimension", 6);
  list.set("null space: vectors", modes.data());
  list.set("null space: add default vectors", false);
  list.set("aggregation: type", "Uncoupled");
  list.set("smoother: type", "Chebyshev");
  list.set("smoother: type (level 0)", "do-nothing"); // the caller smooths this level
  list.set("smoother: sweeps", 4);            // degree of the Chebyshev smoother on the intermediate levels
  list.set("smoother: Chebyshev alpha", 20.); // largest eigenvalue over the lower end of the smoothed range
  list.set("smoother: pre or post", "both");
  list.set("coarse: type", "Amesos-KLU");
  // Rows up to which a matrix is factorised. Aggregated levels have denser rows, so their limit is lower.
  constexpr int max_sparse_rows = 10000, max_aggregated_rows = 4000;
  list.set("coarse: max size", matrix.m() <= max_sparse_rows ? max_sparse_rows : max_aggregated_rows);
  list.set("ML output", 0);
  auto result = std::make_unique<dealii::TrilinosWrappers::PreconditionAMG>();
  result->initialize(matrix, list);
  return result;
}

/// Relative change of the contact tangent above which the preconditioner is set up again.
constexpr double tolerated_change = 0.1;

/// Returns the three translations and three rotations at the owned dofs of linear elements, one motion after
/// the other; 0 at constrained dofs. (deal.II 9.6 has DoFTools::extract_rigid_body_modes().)
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
      at_dof[(3 + next) * n] = x[last]; // rotation about axis `next`
      at_dof[(3 + last) * n] = -x[next];
    }
  }
  return modes;
}

} // namespace

void LevelMatrix::reinit(const SolidLevel &level, const ElasticMaterial &material,
                         const std::shared_ptr<const ContactNodes> &nodes)
{
  elastic = make_elastic_operator<float>(level.mapping, level.dof_handler, level.constraints, material);
  contact = std::make_unique<ContactStiffness>(nodes);
  elastic->compute_diagonal(elastic_diagonal);
  inverse_diagonal = std::make_shared<DiagonalMatrix<FloatVector>>();
  set_contact(Eigen::SparseMatrix<double>(nodes->n_nodes(), nodes->n_nodes()));
}

void LevelMatrix::set_contact(const Eigen::SparseMatrix<double> &tangent)
{
  contact->set(tangent);
  FloatVector &diagonal = inverse_diagonal->get_vector();
  diagonal = elastic_diagonal;
  // The smoother was set up for the largest eigenvalue of D^-1 K (D: diagonal of K). If the contact tangent
  // is added to K and its row sums, not its diagonal, to D, the largest eigenvalue does not increase.
  contact->add_row_sums(diagonal);
  for (float &entry : diagonal)
    entry = 1 / entry;
}

void LevelMatrix::vmult(FloatVector &dst, const FloatVector &src) const
{
  elastic->vmult(dst, src);
  contact->vmult_add(dst, src);
}

float LevelMatrix::el(size_type, size_type) const
{
  throw std::logic_error("an entry of a matrix that has none");
}

LevelSmoother::AdditionalData smoothing_of(const LevelMatrix &matrix)
{
  LevelSmoother::AdditionalData data;
  data.smoothing_range = 40; // ratio of the largest to the smallest smoothed eigenvalue
  data.degree = 5;
  data.eig_cg_n_iterations = 15; // for the largest eigenvalue
  data.preconditioner = matrix.jacobi();
  return data;
}

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
    // A rank without contact nodes has an empty matrix, which Eigen's SparseMatrix::sum() refuses.
    const auto size_of = [this](const Eigen::SparseMatrix<double> &part)
    { return nodes->parts().sum(double(part.coeffs().abs().sum())); };
    if (size_of(tangent - aggregated) <= tolerated_change * size_of(tangent))
      return;
  }
  aggregated = tangent;
  correction.reset(); // it refers to the old `sum`
  sum.copy_from(stiffness);
  for (const ContactNodes::Entry &entry : nodes->owned_rows(tangent))
    sum.add(entry.row, entry.column, entry.value); // in the sparsity pattern: both nodes share a cell
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
