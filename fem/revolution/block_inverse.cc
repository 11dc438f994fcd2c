#include "fem/revolution/block_inverse.h"

#include <deal.II/lac/sparse_matrix.h>

#include <Eigen/CholmodSupport>
#include <Eigen/Dense>

#include <algorithm>
#include <cholmod.h>
#include <dlfcn.h>
#include <mutex>
#include <new>
#include <omp.h>
#include <stdexcept>
#include <string>

namespace stemware::fem
{

namespace
{

/// Serialises BLAS calls, because some BLAS libraries are not thread-safe.
std::mutex entering_blas;

/// Guards the two numbers below.
std::mutex holding_threads;
unsigned int n_holders = 0; ///< number of objects SingleThread
int blas_threads = 1;       ///< number of BLAS threads while no SingleThread exists

/// Returns the function @p name of the BLAS library; nullptr if the library is not OpenBLAS.
template <typename Function>
Function *of_openblas(const char *name)
{
  return reinterpret_cast<Function *>(dlsym(RTLD_DEFAULT, name));
}

/// Returns whether several threads may use BLAS together; serial OpenBLAS would give wrong numbers.
bool blas_takes_threads()
{
  const auto built_for_threads = of_openblas<int()>("openblas_get_parallel");
  return built_for_threads == nullptr || built_for_threads() != 0;
}

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

SingleThread::SingleThread()
    : omp_threads(omp_get_max_threads())
    , omp_levels(omp_get_max_active_levels())
{
  omp_set_num_threads(1);       // also limits an OpenBLAS that is built with OpenMP
  omp_set_max_active_levels(0); // CHOLMOD would start four more threads per calling thread
  const std::lock_guard<std::mutex> lock(holding_threads);
  const auto get = of_openblas<int()>("openblas_get_num_threads");
  const auto set = of_openblas<void(int)>("openblas_set_num_threads");
  if (n_holders++ == 0 && get != nullptr && set != nullptr)
  {
    blas_threads = get();
    set(1);
  }
}

SingleThread::~SingleThread()
{
  omp_set_num_threads(omp_threads);
  omp_set_max_active_levels(omp_levels);
  const std::lock_guard<std::mutex> lock(holding_threads);
  if (const auto set = of_openblas<void(int)>("openblas_set_num_threads"); --n_holders == 0 && set != nullptr)
    set(blas_threads);
}

/// Factors L L' of symmetric positive definite matrices of equal pattern, by CHOLMOD. Functions throw
/// std::runtime_error if CHOLMOD fails, std::bad_alloc without memory.
class CholmodFactors
{
public:
  /// Prepares factors of matrices with the lower triangle @p pattern, eliminated in the order of its rows.
  explicit CholmodFactors(const LowerTriangle &pattern)
      : CholmodFactors()
  {
    cholmod_sparse view = Eigen::viewAsCholmod(pattern.selfadjointView<Eigen::Lower>());
    require_success((factor = cholmod_analyze(&view, &common)), common);
  }

  CholmodFactors(const CholmodFactors &other)
      : CholmodFactors()
  {
    require_success((factor = cholmod_copy_factor(other.factor, &common)), common);
  }

  ~CholmodFactors()
  {
    cholmod_free_factor(&factor, &common);
    cholmod_finish(&common);
  }

  /// Returns whether factorise() proceeds by blocks, with BLAS.
  bool use_blas() const { return factor->is_super != 0; }

  void factorise(const LowerTriangle &matrix)
  {
    cholmod_sparse view = Eigen::viewAsCholmod(matrix.selfadjointView<Eigen::Lower>());
    require_success(cholmod_factorize(&view, factor, &common), common);
  }

  /// Returns the last @p n rows and columns of L.
  Eigen::MatrixXd end(int n) const
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

  /// Returns a minimum-degree order of elimination of @p pattern in which the rows @p last come last.
  static std::vector<int> order_with_last(const LowerTriangle &pattern, const std::vector<unsigned int> &last)
  {
    std::vector<int> part(static_cast<std::size_t>(pattern.rows()), 0), order(part.size());
    for (const unsigned int row : last)
      part[row] = 1;
    CholmodFactors work;
    cholmod_sparse view = Eigen::viewAsCholmod(pattern.selfadjointView<Eigen::Lower>());
    require_success(cholmod_camd(&view, nullptr, 0, part.data(), order.data(), &work.common), work.common);
    return order;
  }

private:
  CholmodFactors()
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

  cholmod_common common;
  cholmod_factor *factor = nullptr;
};

LowerTriangle lower_triangle_of(const dealii::SparseMatrix<double> &matrix)
{
  // In a symmetric matrix, row i from the diagonal on equals column i of the lower triangle.
  const auto n = static_cast<Eigen::Index>(matrix.m());
  LowerTriangle lower(n, n);
  lower.reserve(static_cast<Eigen::Index>(matrix.n_nonzero_elements() / 2 + matrix.m()));
  for (unsigned int column = 0; column < matrix.m(); ++column)
  {
    lower.startVec(column);
    // deal.II stores the diagonal entry first, then the other entries of the row in ascending order.
    for (auto entry = matrix.begin(column); entry != matrix.end(column); ++entry)
      if (entry->column() >= column)
        lower.insertBack(static_cast<Eigen::Index>(entry->column()), column) = entry->value();
  }
  lower.finalize();
  return lower;
}

struct BlockInverse::Plan
{
  Eigen::SparseMatrix<Eigen::Index> numbers; ///< index of each entry in the pattern, in elimination order
  std::vector<Eigen::Index> of_kept;         ///< indices of the kept rows among the last rows
  std::unique_ptr<const CholmodFactors> symbolic;
};

BlockInverse::BlockInverse(const LowerTriangle &pattern, const std::vector<unsigned int> &kept)
    : plan(std::make_unique<Plan>())
{
  const std::vector<int> order = CholmodFactors::order_with_last(pattern, kept);
  std::vector<int> place(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    place[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
  for (const unsigned int row : kept)
    plan->of_kept.push_back(place[row] - static_cast<Eigen::Index>(order.size() - kept.size()));

  std::vector<Eigen::Triplet<Eigen::Index>> entries;
  for (Eigen::Index column = 0; column < pattern.cols(); ++column)
    for (LowerTriangle::InnerIterator entry(pattern, column); entry; ++entry)
    {
      const int a = place[static_cast<std::size_t>(entry.row())], b = place[static_cast<std::size_t>(column)];
      entries.emplace_back(std::max(a, b), std::min(a, b), static_cast<Eigen::Index>(entries.size()));
    }
  plan->numbers.resize(pattern.rows(), pattern.cols());
  plan->numbers.setFromTriplets(entries.begin(), entries.end());
  const SingleThread hold;
  plan->symbolic = std::make_unique<CholmodFactors>(plan->numbers.cast<double>());
}

BlockInverse::~BlockInverse() = default;

Eigen::MatrixXd BlockInverse::operator()(const Eigen::VectorXd &entries, unsigned int n_columns) const
{
  const LowerTriangle matrix = plan->numbers.unaryExpr([&](Eigen::Index number) { return entries(number); });
  CholmodFactors numeric(*plan->symbolic);
  {
    const SingleThread hold;
    std::unique_lock<std::mutex> alone(entering_blas, std::defer_lock);
    if (numeric.use_blas() && !blas_takes_threads())
      alone.lock();
    numeric.factorise(matrix);
  }

  // The kept rows come last, so their block of (L L')^-1 is (L_e L_e')^-1 with the trailing block L_e of L.
  const auto n_kept = static_cast<Eigen::Index>(plan->of_kept.size());
  const Eigen::MatrixXd end = numeric.end(static_cast<int>(n_kept));
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(n_kept, n_columns);
  for (unsigned int j = 0; j < n_columns; ++j)
    columns(plan->of_kept[j], j) = 1;
  end.triangularView<Eigen::Lower>().solveInPlace(columns);
  end.triangularView<Eigen::Lower>().transpose().solveInPlace(columns);
  Eigen::MatrixXd result(n_kept, n_columns);
  for (Eigen::Index i = 0; i < n_kept; ++i)
    result.row(i) = columns.row(plan->of_kept[static_cast<std::size_t>(i)]);
  return result;
}

} // namespace stemware::fem
