#include "fem/factorisation/sparse_cholesky.h"

#include "fem/factorisation/blas_threads.h"

#include <deal.II/lac/sparse_matrix.h>

#include <Eigen/CholmodSupport>
#include <Eigen/Dense>

#include <algorithm>
#include <mutex>
#include <new>
#include <omp.h>
#include <stdexcept>

namespace stemware::fem
{

namespace
{

/// Lock of a BLAS that does not take threads together.
std::mutex entering_blas;

/// The lock, held if the BLAS asks for it.
std::unique_lock<std::mutex> enter_blas()
{
  std::unique_lock<std::mutex> lock(entering_blas, std::defer_lock);
  if (!blas_takes_threads())
    lock.lock();
  return lock;
}

/// Keeps BLAS and CHOLMOD to the calling thread.
void hold_to_one_thread()
{
  hold_blas_to_one_thread();
  omp_set_num_threads(1);       // an OpenBLAS built on OpenMP goes by the number of each thread
  omp_set_max_active_levels(0); // CHOLMOD starts four threads of its own for each of the caller's
}

/// Throws std::bad_alloc if CHOLMOD ran out of memory in its last step, std::runtime_error if it failed
/// otherwise.
template <typename Factors>
void require_success(Factors &factors)
{
  if (factors.cholmod().status == CHOLMOD_OUT_OF_MEMORY)
    throw std::bad_alloc();
  if (factors.cholmod().status < 0 || factors.info() != Eigen::Success)
    throw std::runtime_error(
      "A stiffness matrix is not positive definite: the mesh is distorted or the body is not fixed.");
}

} // namespace

LowerTriangle lower_triangle_of(const dealii::SparseMatrix<double> &matrix)
{
  // Rows of the symmetric matrix, begun at the diagonal, are the columns of its lower triangle.
  const auto n = static_cast<Eigen::Index>(matrix.m());
  LowerTriangle lower(n, n);
  lower.reserve(static_cast<Eigen::Index>(matrix.n_nonzero_elements() / 2 + matrix.m()));
  for (unsigned int column = 0; column < matrix.m(); ++column)
  {
    lower.startVec(column);
    // deal.II keeps the diagonal first, then the others in ascending order.
    for (auto entry = matrix.begin(column); entry != matrix.end(column); ++entry)
      if (entry->column() >= column)
        lower.insertBack(static_cast<Eigen::Index>(entry->column()), column) = entry->value();
  }
  lower.finalize();
  return lower;
}

struct SparseCholesky::Factors : Eigen::CholmodSimplicialLLT<LowerTriangle, Eigen::Lower>
{
  explicit Factors(const LowerTriangle &lower)
  {
    cholmod().nmethods = 1;
    cholmod().method[0].ordering = CHOLMOD_AMD;
    cholmod().postorder = 1;
    cholmod().print = 0; // what goes wrong is said by the caller
    analyzePattern(lower);
    require_success(*this);
    factorize(lower);
    require_success(*this);
  }
};

SparseCholesky::SparseCholesky(const dealii::SparseMatrix<double> &matrix)
    : factors(std::make_unique<Factors>(lower_triangle_of(matrix)))
{
}

SparseCholesky::~SparseCholesky() = default;

Eigen::MatrixXd SparseCholesky::solve(const Eigen::MatrixXd &right_hand_sides) const
{
  Eigen::MatrixXd solutions = factors->solve(right_hand_sides);
  require_success(*factors);
  return solutions;
}

struct BlockCholesky::Factors : Eigen::CholmodSupernodalLLT<LowerTriangle, Eigen::Lower>
{
  Factors()
  {
    hold_to_one_thread();
    cholmod().nmethods = 1;
    cholmod().method[0].ordering = CHOLMOD_AMD;
    cholmod().postorder = 1;
    cholmod().print = 0;
  }
};

BlockCholesky::BlockCholesky(const LowerTriangle &pattern)
    : factors(std::make_unique<Factors>())
{
  factors->analyzePattern(pattern);
  require_success(*factors);
}

BlockCholesky::~BlockCholesky() = default;

void BlockCholesky::factorise(const LowerTriangle &matrix)
{
  const auto alone = enter_blas();
  factors->factorize(matrix);
  require_success(*factors);
}

Eigen::VectorXd BlockCholesky::solve(const Eigen::VectorXd &right_hand_side) const
{
  const auto alone = enter_blas();
  Eigen::VectorXd solution = factors->solve(right_hand_side);
  require_success(*factors);
  return solution;
}

/// Factors L L' in the order of the matrix, of blocks where that pays.
struct BlockInverse::Factors : Eigen::CholmodSimplicialLLT<LowerTriangle, Eigen::Lower>
{
  Factors()
  {
    hold_to_one_thread();
    cholmod().print = 0;
    cholmod().nmethods = 1;
    cholmod().method[0].ordering = CHOLMOD_NATURAL;
    cholmod().postorder = 0;
    cholmod().supernodal = CHOLMOD_AUTO;
    cholmod().final_super = 0;
  }
  /// With the pattern of @p symbolic.
  Factors(const Factors &symbolic)
      : Factors()
  {
    m_cholmodFactor = cholmod_copy_factor(symbolic.m_cholmodFactor, &cholmod());
    require_success(*this);
    m_isInitialized = true;
    m_analysisIsOk = 1;
  }
  Factors &operator=(const Factors &) = delete;

  bool are_blocks() const { return m_cholmodFactor->is_super != 0; }

  /// The last @p n rows and columns of L.
  Eigen::MatrixXd end(Eigen::Index n) const
  {
    const auto *starts = static_cast<const int *>(m_cholmodFactor->p);
    const auto *lengths = static_cast<const int *>(m_cholmodFactor->nz);
    const auto *rows = static_cast<const int *>(m_cholmodFactor->i);
    const auto *values = static_cast<const double *>(m_cholmodFactor->x);
    const Eigen::Index first = static_cast<Eigen::Index>(m_cholmodFactor->n) - n;
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(n, n);
    for (Eigen::Index j = 0; j < n; ++j)
      for (int k = starts[first + j]; k < starts[first + j] + lengths[first + j]; ++k)
        result(rows[k] - first, j) = values[k];
    return result;
  }
};

struct BlockInverse::Plan
{
  LowerTriangle reordered;           ///< pattern in the order of elimination
  std::vector<Eigen::Index> sources; ///< of its values in the matrix as given
  std::vector<Eigen::Index> of_kept; ///< places of the kept rows among the last ones
  Factors symbolic;
};

BlockInverse::BlockInverse(const LowerTriangle &pattern, const std::vector<unsigned int> &kept)
    : plan(std::make_unique<Plan>())
{
  std::vector<int> part(static_cast<std::size_t>(pattern.rows()), 0), order(part.size()), place(part.size());
  for (const unsigned int row : kept)
    part[row] = 1;
  cholmod_sparse view = Eigen::viewAsCholmod(pattern.selfadjointView<Eigen::Lower>());
  cholmod_camd(&view, nullptr, 0, part.data(), order.data(), &plan->symbolic.cholmod());
  for (std::size_t i = 0; i < order.size(); ++i)
    place[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
  for (const unsigned int row : kept)
    plan->of_kept.push_back(place[row] - static_cast<Eigen::Index>(order.size() - kept.size()));

  // Entries carry their numbers through the sorting.
  std::vector<Eigen::Triplet<double>> entries;
  for (Eigen::Index column = 0; column < pattern.cols(); ++column)
    for (LowerTriangle::InnerIterator entry(pattern, column); entry; ++entry)
    {
      const int a = place[static_cast<std::size_t>(entry.row())], b = place[static_cast<std::size_t>(column)];
      entries.emplace_back(std::max(a, b), std::min(a, b), static_cast<double>(entries.size()));
    }
  plan->reordered.resize(pattern.rows(), pattern.cols());
  plan->reordered.setFromTriplets(entries.begin(), entries.end());
  for (Eigen::Index k = 0; k < plan->reordered.nonZeros(); ++k)
    plan->sources.push_back(static_cast<Eigen::Index>(plan->reordered.valuePtr()[k]));
  plan->symbolic.analyzePattern(plan->reordered);
  require_success(plan->symbolic);
}

BlockInverse::~BlockInverse() = default;

Eigen::MatrixXd BlockInverse::operator()(const Eigen::VectorXd &entries, unsigned int n_columns) const
{
  LowerTriangle matrix = plan->reordered;
  for (Eigen::Index k = 0; k < matrix.nonZeros(); ++k)
    matrix.valuePtr()[k] = entries(plan->sources[static_cast<std::size_t>(k)]);
  Factors numeric(plan->symbolic);
  {
    std::unique_lock<std::mutex> alone;
    if (numeric.are_blocks())
      alone = enter_blas();
    numeric.factorize(matrix);
  }
  require_success(numeric);

  // With the kept rows last, (L L')^-1 has (L_e L_e')^-1 in their rows and columns, L_e the end of L.
  const auto n_kept = static_cast<Eigen::Index>(plan->of_kept.size());
  const Eigen::MatrixXd end = numeric.end(n_kept);
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
