#include "fem/revolution/cholmod_factors.h"

#include <Eigen/CholmodSupport>

namespace stemware::fem
{

namespace
{

void require_success(bool is_done, const cholmod_common &common)
{
  if (common.status == CHOLMOD_OUT_OF_MEMORY)
    throw std::bad_alloc();
  if (common.status == CHOLMOD_NOT_POSDEF)
    throw std::runtime_error(
      "A stiffness matrix is not positive definite: the mesh is distorted or the body is not fixed.");
  if (!is_done || common.status < CHOLMOD_OK)
    throw std::runtime_error("CHOLMOD failed with status " + std::to_string(common.status) + ".");
}

} // namespace

CholmodFactors::CholmodFactors()
{
  cholmod_start(&common);
  common.print = 0;
  common.nmethods = 1;
  common.method[0].ordering = CHOLMOD_NATURAL;
  common.postorder = 0;
  common.final_asis = 0; // end() requires L stored by columns
  common.final_ll = 1;
  common.final_super = 0;
}

CholmodFactors::CholmodFactors(const LowerTriangle &pattern)
    : CholmodFactors()
{
  cholmod_sparse view = Eigen::viewAsCholmod(pattern.selfadjointView<Eigen::Lower>());
  require_success((factor = cholmod_analyze(&view, &common)), common);
}

CholmodFactors::CholmodFactors(const CholmodFactors &other)
    : CholmodFactors()
{
  require_success((factor = cholmod_copy_factor(other.factor, &common)), common);
}

CholmodFactors::~CholmodFactors()
{
  cholmod_free_factor(&factor, &common);
  cholmod_finish(&common);
}

void CholmodFactors::factorise(const LowerTriangle &matrix)
{
  cholmod_sparse view = Eigen::viewAsCholmod(matrix.selfadjointView<Eigen::Lower>());
  require_success(cholmod_factorize(&view, factor, &common), common);
}

Eigen::MatrixXd CholmodFactors::end(int n) const
{
  const auto *starts = static_cast<const int *>(factor->p), *lengths = static_cast<const int *>(factor->nz),
             *rows = static_cast<const int *>(factor->i);
  const int first = static_cast<int>(factor->n) - n;
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(n, n);
  for (int j = 0; j < n; ++j)
    for (int k = starts[first + j]; k < starts[first + j] + lengths[first + j]; ++k)
      result(rows[k] - first, j) = static_cast<const double *>(factor->x)[k];
  return result;
}

std::vector<int> CholmodFactors::order_with_last(const LowerTriangle &pattern,
                                                 const std::vector<unsigned int> &last)
{
  std::vector<int> part(static_cast<std::size_t>(pattern.rows()), 0), order(part.size());
  for (const unsigned int row : last)
    part[row] = 1;
  CholmodFactors work;
  cholmod_sparse view = Eigen::viewAsCholmod(pattern.selfadjointView<Eigen::Lower>());
  require_success(cholmod_camd(&view, nullptr, 0, part.data(), order.data(), &work.common), work.common);
  return order;
}

} // namespace stemware::fem
