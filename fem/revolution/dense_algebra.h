#pragma once

#include "fem/revolution/line_bundle.h"

#include <Eigen/Core>

namespace stemware::fem
{

// Loops that are compiled for several kinds of processors: several times as fast as a library that is
// compiled for all of them.

/// Solves the dense systems A X = B by Gauss's elimination with row pivots. @p system is [A, B], shape [n, n
/// + @p n_columns]; X takes the place of B, what A becomes is of no use. A singular A leaves numbers that are
/// not finite.
void solve_dense(RowMatrix &system, Eigen::Index n_columns);

/// Adds @p a times @p b to @p sum, which none of them overlaps.
void add_product(const Eigen::Ref<const Eigen::MatrixXd> &a, const Eigen::Ref<const Eigen::MatrixXd> &b,
                 Eigen::Ref<Eigen::MatrixXd> sum);

} // namespace stemware::fem
