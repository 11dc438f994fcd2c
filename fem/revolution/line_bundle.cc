#include "fem/revolution/line_bundle.h"

#include "fem/revolution/target_clones.h"

#include <algorithm>

namespace stemware::fem
{

namespace
{

using Index = Eigen::Index;

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
