#pragma once

#include "fem/revolution/line_bundle.h"

#include <Eigen/Core>

namespace stemware::fem
{

// Loops compiled for several processors: with 60 unknowns 1.5 times, with 300 unknowns 2.3 times as fast as
// Eigen's portable PartialPivLU (tests/benchmark/dense_benchmark.cc); thread-safe, unlike Debian's serial
// OpenBLAS.

/// Solves A X = B by Gaussian elimination with row pivots. @p system is [A, B], shape [n, n + @p n_columns].
/// X overwrites B, A is overwritten. A singular A gives non-finite numbers.
void solve_dense(RowMatrix &system, Eigen::Index n_columns);

/// Adds @p a times @p b to @p sum. The arguments must not alias.
void add_product(const Eigen::Ref<const Eigen::MatrixXd> &a, const Eigen::Ref<const Eigen::MatrixXd> &b,
                 Eigen::Ref<Eigen::MatrixXd> sum);

} // namespace stemware::fem
