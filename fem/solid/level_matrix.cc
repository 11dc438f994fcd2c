#include "fem/solid/level_matrix.h"

#include "fem/solid/stiffness_3d.h"

#include <deal.II/base/mpi.h>

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
  // Row sums, not T's diagonal: whichever part of a cell carries load, the largest eigenvalue stays that of
  // the elastic operator, for which the smoother was set up.
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
  data.smoothing_range = multigrid_numbers.smoothing_range;
  data.degree = multigrid_numbers.degree;
  data.eig_cg_n_iterations = multigrid_numbers.n_eigenvalue_iterations;
  data.preconditioner = matrix.jacobi();
  return data;
}

FactorizedLevel::FactorizedLevel(const SolidLevel &level, const ElasticMaterial &material,
                                 std::shared_ptr<const ContactNodes> contact_nodes)
    : communicator(level.dof_handler.get_communicator())
    , owned(level.dof_handler.locally_owned_dofs())
    , nodes(std::move(contact_nodes))
{
  TrilinosWrappers::SparseMatrix matrix;
  assemble_stiffness(level.mapping, level.dof_handler, material, level.constraints, matrix);
  std::vector<std::array<double, 3>> local;
  for (const auto row : owned)
    for (auto entry = matrix.begin(row); entry != matrix.end(row); ++entry)
      local.push_back({ double(row), double(entry->column()), entry->value() });
  std::vector<Eigen::Triplet<double>> entries;
  for (const auto &part : Utilities::MPI::all_gather(communicator, local))
    for (const auto &[row, column, value] : part)
      entries.emplace_back(static_cast<int>(row), static_cast<int>(column), value);
  const auto n = static_cast<Eigen::Index>(level.dof_handler.n_dofs());
  stiffness.resize(n, n);
  stiffness.setFromTriplets(entries.begin(), entries.end());
}

void FactorizedLevel::set_contact(const Eigen::SparseMatrix<double> &tangent)
{
  std::vector<double> packed; // row, column, value: of a level as small as this, a rank can have all
  for (Eigen::Index column = 0; column < tangent.outerSize(); ++column)
    for (Eigen::SparseMatrix<double>::InnerIterator entry(tangent, column); entry; ++entry)
      packed.insert(packed.end(), { double(nodes->dofs()[static_cast<std::size_t>(entry.row())]),
                                    double(nodes->dofs()[static_cast<std::size_t>(column)]), entry.value() });
  packed = nodes->parts().gather_everywhere(std::move(packed));
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t i = 0; i < packed.size(); i += 3)
    entries.emplace_back(static_cast<int>(packed[i]), static_cast<int>(packed[i + 1]), packed[i + 2]);
  Eigen::SparseMatrix<double> table(stiffness.rows(), stiffness.cols());
  table.setFromTriplets(entries.begin(), entries.end());
  factors.compute(stiffness + table);
  if (factors.info() != Eigen::Success)
    throw std::runtime_error("the stiffness of the coarsest mesh is not positive definite.");
}

void FactorizedLevel::operator()(unsigned int, FloatVector &dst, const FloatVector &src) const
{
  Eigen::VectorXd rhs = Eigen::VectorXd::Zero(stiffness.rows());
  for (unsigned int i = 0; i < src.locally_owned_size(); ++i)
    rhs(static_cast<Eigen::Index>(owned.nth_index_in_set(i))) = src.local_element(i);
  const ArrayView<double> values(rhs.data(), static_cast<std::size_t>(rhs.size()));
  Utilities::MPI::sum(ArrayView<const double>(values), communicator, values);
  const Eigen::VectorXd solution = factors.solve(rhs);
  for (unsigned int i = 0; i < dst.locally_owned_size(); ++i)
    dst.local_element(i) = static_cast<float>(solution(static_cast<Eigen::Index>(owned.nth_index_in_set(i))));
}

} // namespace stemware::fem
