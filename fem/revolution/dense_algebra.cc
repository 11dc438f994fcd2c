#include "fem/revolution/dense_algebra.h"

#include <algorithm>
#include <cmath>
#include <functional>

// Attribute of functions that are compiled for several processors, selected at run time. The thread
// sanitizer crashes in the selection, which the loader calls before the sanitizer is ready.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__gnu_linux__) &&             \
  !defined(__SANITIZE_THREAD__)
#define STEMWARE_TARGET_CLONES __attribute__((target_clones("avx512f", "fma", "default")))
#else
#define STEMWARE_TARGET_CLONES
#endif

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

/// Computes local = normal + radial diag(slides).
STEMWARE_TARGET_CLONES
void make_local(Index n, const double *normal, const double *radial, const Lanes *slides, Lanes *local)
{
  for (Index i = 0; i < n; ++i)
    for (Index k = 0; k < n; ++k)
      for (int lane = 0; lane < Lanes::n; ++lane)
        local[i * n + k].value[lane] =
          normal[i * n + k] + (radial ? radial[i * n + k] * slides[k].value[lane] : 0);
}

/// Adds row @p i of the product of the tangent (@p bands) and @p table to @p result.
STEMWARE_TARGET_CLONES
void apply_tangent(Index n, Index band, const Lanes *bands, Index i, const Lanes *__restrict table,
                   Index n_columns, Lanes *__restrict result)
{
  for (Index k = std::max<Index>(0, i - band); k <= std::min(n - 1, i + band); ++k)
  {
    const Lanes factor = bands[k - i + band];
    for (Index c = 0; c < n_columns; ++c)
      for (int lane = 0; lane < Lanes::n; ++lane)
        result[c].value[lane] += factor.value[lane] * table[k * n_columns + c].value[lane];
  }
}

/// Solves @p n linear equations in each lane of @p system by elimination. The solutions overwrite the
/// right-hand sides, which are the last @p n_rhs columns.
STEMWARE_TARGET_CLONES
void eliminate(Index n, Index n_rhs, Lanes *system)
{
  constexpr Index max_pivots = 4;
  const Index width = n + n_rhs;
  for (Index first = 0; first < n; first += max_pivots)
  {
    const Index n_pivots = std::min(max_pivots, n - first), end = first + n_pivots;
    for (Index i = first; i < n; ++i)
    {
      Lanes *__restrict row = system + i * width;
      const Index n_before = std::min(i - first, n_pivots);
      std::array<Lanes, max_pivots> factors = {};
      for (Index k = 0; k < n_before; ++k)
      {
        const Lanes *__restrict pivot = system + (first + k) * width;
        factors[k] = row[first + k];
        for (Index c = first + k + 1; c < end; ++c)
          for (int lane = 0; lane < Lanes::n; ++lane)
            row[c].value[lane] -= factors[k].value[lane] * pivot[c].value[lane];
      }
      const Lanes *__restrict pivots = system + first * width;
      if (n_before == max_pivots)
        for (Index c = end; c < width; ++c)
          for (int lane = 0; lane < Lanes::n; ++lane)
            row[c].value[lane] -= factors[0].value[lane] * pivots[c].value[lane] +
                                  factors[1].value[lane] * pivots[width + c].value[lane] +
                                  factors[2].value[lane] * pivots[2 * width + c].value[lane] +
                                  factors[3].value[lane] * pivots[3 * width + c].value[lane];
      else
        for (Index k = 0; k < n_before; ++k)
          for (Index c = end; c < width; ++c)
            for (int lane = 0; lane < Lanes::n; ++lane)
              row[c].value[lane] -= factors[k].value[lane] * pivots[k * width + c].value[lane];
      if (i >= end)
        continue;
      Lanes inverse;
      for (int lane = 0; lane < Lanes::n; ++lane)
        inverse.value[lane] = 1 / row[i].value[lane];
      for (Index c = i + 1; c < width; ++c)
        for (int lane = 0; lane < Lanes::n; ++lane)
          row[c].value[lane] *= inverse.value[lane];
    }
  }
  for (Index k = n - 1; k > 0; --k)
    for (Index i = 0; i < k; ++i)
    {
      const Lanes factor = system[i * width + k];
      Lanes *__restrict row = system + i * width + n;
      const Lanes *__restrict found = system + k * width + n;
      for (Index c = 0; c < n_rhs; ++c)
        for (int lane = 0; lane < Lanes::n; ++lane)
          row[c].value[lane] -= factor.value[lane] * found[c].value[lane];
    }
}

STEMWARE_TARGET_CLONES
void add_product(Index n_weights, Index n_columns, const Lanes *__restrict weights,
                 const Lanes *__restrict values, Lanes *__restrict products)
{
  for (Index a = 0; a < n_weights; ++a)
  {
    const Lanes weight = weights[a];
    for (Index c = 0; c < n_columns; ++c)
      for (int lane = 0; lane < Lanes::n; ++lane)
        products[a * n_columns + c].value[lane] += weight.value[lane] * values[c].value[lane];
  }
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

void LineBundle::reset(Index n_circles, Index band, Index n_columns)
{
  n_unknowns = n_circles;
  n_band = band;
  n_rhs = n_columns;
  bands.set_zero(n_circles, 2 * band + 1);
  slides.set_zero(n_circles, 1);
  shapes.set_zero(n_circles, n_columns - 1);
  system.set_zero(n_circles, n_circles + n_columns);
}

LaneTable LineBundle::solve(const RowMatrix &normal, const RowMatrix &radial)
{
  local.set_zero(n_unknowns, n_unknowns);
  make_local(n_unknowns, normal.data(), radial.size() > 0 ? radial.data() : nullptr, slides.row(0),
             local.row(0));
  for (Index i = 0; i < n_unknowns; ++i)
  {
    Lanes *row = system.row(i);
    apply_tangent(n_unknowns, n_band, bands.row(i), i, local.row(0), n_unknowns, row);
    apply_tangent(n_unknowns, n_band, bands.row(i), i, shapes.row(0), n_rhs - 1, row + n_unknowns);
    for (double &diagonal : row[i].value)
      diagonal += 1;
  }
  eliminate(n_unknowns, n_rhs, system.row(0));
  LaneTable solution(n_unknowns, n_rhs);
  for (Index i = 0; i < n_unknowns; ++i)
    std::copy_n(system.row(i) + n_unknowns, n_rhs, solution.row(i));
  return solution;
}

LaneTable products(const LaneTable &weights, const LaneTable &values)
{
  LaneTable sums(weights.n_columns(), values.n_columns());
  for (Index i = 0; i < values.n_rows(); ++i)
    add_product(weights.n_columns(), values.n_columns(), weights.row(i), values.row(i), sums.row(0));
  return sums;
}

} // namespace stemware::fem
