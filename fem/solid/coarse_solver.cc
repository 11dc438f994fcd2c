#include "fem/solid/coarse_solver.h"

#include "fem/factorisation/sparse_cholesky.h"
#include "fem/solid/axisymmetric_coarse_space.h"
#include "fem/solid/stiffness_3d.h"

#include <deal.II/base/mpi.h>

#include <memory>

namespace stemware::fem
{

using namespace dealii;

namespace
{

class FactorizedLevel : public CoarseSolver
{
public:
  FactorizedLevel(const SolidLevel &level, const ElasticMaterial &material,
                  const std::shared_ptr<const ContactNodes> &nodes)
      : communicator(level.dof_handler.get_communicator())
      , owned(level.dof_handler.locally_owned_dofs())
      , nodes(nodes)
  {
    TrilinosWrappers::SparseMatrix matrix;
    assemble_stiffness(level.mapping, level.dof_handler, material, level.constraints, matrix);
    std::vector<double> packed;
    for (const auto row : owned)
      for (auto entry = matrix.begin(row); entry != matrix.end(row); ++entry)
        packed.insert(packed.end(), { double(row), double(entry->column()), entry->value() });
    stiffness = sum_of_all_ranks(std::move(packed));
  }

  void set_contact(const Eigen::SparseMatrix<double> &tangent) override
  {
    std::vector<double> packed;
    for (Eigen::Index column = 0; column < tangent.outerSize(); ++column)
      for (Eigen::SparseMatrix<double>::InnerIterator entry(tangent, column); entry; ++entry)
        packed.insert(packed.end(),
                      { double(nodes->dofs()[static_cast<std::size_t>(entry.row())]),
                        double(nodes->dofs()[static_cast<std::size_t>(column)]), entry.value() });
    const Eigen::SparseMatrix<double> sum = stiffness + sum_of_all_ranks(std::move(packed));
    const bool fits = sum.nonZeros() == stiffness.nonZeros();
    if (!factors || !fits || !have_pattern_of_stiffness)
      factors = std::make_unique<BlockCholesky>(sum);
    have_pattern_of_stiffness = fits;
    factors->factorise(sum);
  }

  void operator()(unsigned int, FloatVector &dst, const FloatVector &src) const override
  {
    Eigen::VectorXd rhs = Eigen::VectorXd::Zero(stiffness.rows());
    for (unsigned int i = 0; i < src.locally_owned_size(); ++i)
      rhs(static_cast<Eigen::Index>(owned.nth_index_in_set(i))) = src.local_element(i);
    const ArrayView<double> values(rhs.data(), static_cast<std::size_t>(rhs.size()));
    Utilities::MPI::sum(ArrayView<const double>(values), communicator, values);
    const Eigen::VectorXd solution = factors->solve(rhs);
    for (unsigned int i = 0; i < dst.locally_owned_size(); ++i)
      dst.local_element(i) =
        static_cast<float>(solution(static_cast<Eigen::Index>(owned.nth_index_in_set(i))));
  }

private:
  /// The matrix of all ranks' entries, each @p packed as row, column, value: of a level as small as this, a
  /// rank can have all.
  Eigen::SparseMatrix<double> sum_of_all_ranks(std::vector<double> packed) const
  {
    packed = nodes->parts().all_gather(std::move(packed));
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t i = 0; i < packed.size(); i += 3)
      entries.emplace_back(static_cast<int>(packed[i]), static_cast<int>(packed[i + 1]), packed[i + 2]);
    const auto n = static_cast<Eigen::Index>(owned.size());
    Eigen::SparseMatrix<double> matrix(n, n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
  }

  const MPI_Comm communicator;
  const IndexSet owned;
  const std::shared_ptr<const ContactNodes> nodes;
  Eigen::SparseMatrix<double> stiffness;
  std::unique_ptr<BlockCholesky> factors;
  bool have_pattern_of_stiffness = false;
};

class RevolvedCycle : public CoarseSolver
{
public:
  RevolvedCycle(const SolidLevel &level, const LevelMatrix &matrix, const ElasticMaterial &material,
                const std::shared_ptr<const ContactNodes> &nodes)
      : matrix(matrix)
      , body(level, material, nodes)
  {
    smoother.initialize(matrix, smoothing_of(matrix));
    FloatVector vector;
    matrix.initialize_dof_vector(vector);
    smoother.estimate_eigenvalues(vector);
  }

  void set_contact(const Eigen::SparseMatrix<double> &tangent) override { body.set_contact(tangent); }

  void operator()(unsigned int, FloatVector &dst, const FloatVector &src) const override
  {
    smoother.vmult(dst, src);
    FloatVector residual;
    matrix.initialize_dof_vector(residual);
    matrix.vmult(residual, dst);
    residual.sadd(-1, 1, src);
    body.add_correction(dst, residual);
    smoother.step(dst, src);
  }

private:
  const LevelMatrix &matrix;
  AxisymmetricCoarseSpace body;
  LevelSmoother smoother;
};

} // namespace

std::unique_ptr<CoarseSolver> make_coarse_solver(const SolidLevel &level, const LevelMatrix &matrix,
                                                 const ElasticMaterial &material,
                                                 const std::shared_ptr<const ContactNodes> &nodes)
{
  if (level.dof_handler.n_dofs() <= multigrid_parameters.max_factorized_unknowns)
    return std::make_unique<FactorizedLevel>(level, material, nodes);
  return std::make_unique<RevolvedCycle>(level, matrix, material, nodes);
}

} // namespace stemware::fem
