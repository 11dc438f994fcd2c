#include "fem/solid/level_matrix.h"

#include <stdexcept>

namespace stemware::fem
{

using namespace dealii;

void LevelMatrix::reinit(const SolidLevel &level, const ElasticMaterial &material,
                         const std::shared_ptr<const ContactNodes> &nodes)
{
  elastic = make_elastic_operator<float>(level.mapping, level.dof_handler, level.constraints, material);
  contact = std::make_unique<ContactStiffness>(nodes);
  n_rows = level.dof_handler.n_dofs();
  elastic->compute_diagonal(elastic_diagonal);
  inverse_diagonal = std::make_shared<DiagonalMatrix<FloatVector>>();
  set_contact(Eigen::SparseMatrix<double>(nodes->n_nodes(), nodes->n_nodes()));
}

void LevelMatrix::set_contact(const Eigen::SparseMatrix<double> &tangent)
{
  contact->set(tangent);
  FloatVector &diagonal = inverse_diagonal->get_vector();
  diagonal = elastic_diagonal;
  // Adds row sums instead of T's diagonal. Whichever part of a cell is loaded, the largest eigenvalue then
  // equals the largest eigenvalue of the elastic operator, for which the smoother was set up.
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
  data.smoothing_range = multigrid_parameters.smoothing_range;
  data.degree = multigrid_parameters.degree;
  data.eig_cg_n_iterations = multigrid_parameters.n_eigenvalue_iterations;
  data.preconditioner = matrix.jacobi();
  return data;
}

} // namespace stemware::fem
