#include "fem/revolution/dense_algebra.h"

#include "fem/revolution/target_clones.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace stemware::fem
{

namespace
{

using Index = Eigen::Index;

constexpr Index max_pivots = 8;

/// Eliminates and updates the columns [@p first, @p end). The factors replace the eliminated entries.
STEMWARE_TARGET_CLONES
void eliminate_panel(double *system, Index n, Index width, Index first, Index end)
{
  for (Index k = first; k < end; ++k)
  {
    Index pivot = k;
    for (Index i = k + 1; i < n; ++i)
      if (std::abs(system[i * width + k]) > std::abs(system[pivot * width + k]))
        pivot = i;
    if (pivot != k)
      std::swap_ranges(system + k * width, system + (k + 1) * width, system + pivot * width);
    const double *__restrict above = system + k * width;
    const double inverse = 1 / above[k];
    for (Index i = k + 1; i < n; ++i)
    {
      double *__restrict row = system + i * width;
      row[k] *= inverse;
      for (Index c = k + 1; c < end; ++c)
        row[c] -= row[k] * above[c];
    }
  }
}

/// Adds @p n_terms rows of @p terms, @p stride apart, times @p factors to the @p n entries of @p sum.
STEMWARE_TARGET_CLONES
void add_scaled(double *__restrict sum, Index n, const double *__restrict terms, Index stride,
                const double *__restrict factors, Index n_terms)
{
  Index k = 0;
  for (; k + 8 <= n_terms; k += 8)
  {
    const double *__restrict t = terms + k * stride;
    const double f0 = factors[k], f1 = factors[k + 1], f2 = factors[k + 2], f3 = factors[k + 3],
                 f4 = factors[k + 4], f5 = factors[k + 5], f6 = factors[k + 6], f7 = factors[k + 7];
    for (Index c = 0; c < n; ++c)
      sum[c] += (f0 * t[c] + f1 * t[stride + c]) + (f2 * t[2 * stride + c] + f3 * t[3 * stride + c]) +
                (f4 * t[4 * stride + c] + f5 * t[5 * stride + c]) +
                (f6 * t[6 * stride + c] + f7 * t[7 * stride + c]);
  }
  for (; k < n_terms; ++k)
    for (Index c = 0; c < n; ++c)
      sum[c] += factors[k] * terms[k * stride + c];
}

} // namespace

void solve_dense(RowMatrix &system, Index n_columns)
{
  const Index n = system.rows(), width = system.cols();
  double *const values = system.data();
  for (Index first = 0; first < n; first += max_pivots)
  {
    const Index end = std::min(first + max_pivots, n);
    eliminate_panel(values, n, width, first, end);
    const double *const pivots = values + first * width;
    for (Index i = first + 1; i < n; ++i)
    {
      double *const row = values + i * width;
      double factors[max_pivots];
      std::transform(row + first, row + end, factors, std::negate<>());
      add_scaled(row + end, width - end, pivots + end, width, factors, std::min(i, end) - first);
    }
  }
  auto solution = system.rightCols(n_columns);
  for (Index k = n - 1; k >= 0; --k)
  {
    solution.row(k) -= system.row(k).segment(k + 1, n - 1 - k) * solution.bottomRows(n - 1 - k);
    solution.row(k) /= system(k, k);
  }
}

void add_product(const Eigen::Ref<const Eigen::MatrixXd> &a, const Eigen::Ref<const Eigen::MatrixXd> &b,
                 Eigen::Ref<Eigen::MatrixXd> sum)
{
  for (Index column = 0; column < b.cols(); ++column)
    add_scaled(sum.col(column).data(), a.rows(), a.data(), a.outerStride(), b.col(column).data(), a.cols());
}

} // namespace stemware::fem
