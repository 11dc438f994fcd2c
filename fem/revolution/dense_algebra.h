#pragma once

#include <Eigen/Core>

#include <array>
#include <vector>

namespace stemware::fem
{

// Loops compiled for several processors: with 60 unknowns 1.5 times, with 300 unknowns 2.3 times as fast as
// Eigen's portable PartialPivLU (tests/benchmark/dense_benchmark.cc); thread-safe, unlike Debian's serial
// OpenBLAS.

/// Row-major matrix.
using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Solves A X = B by Gaussian elimination with row pivots. @p system is [A, B], shape [n, n + @p n_columns].
/// X overwrites B, A is overwritten. A singular A gives non-finite numbers.
void solve_dense(RowMatrix &system, Eigen::Index n_columns);

/// Adds @p a times @p b to @p sum. The arguments must not alias.
void add_product(const Eigen::Ref<const Eigen::MatrixXd> &a, const Eigen::Ref<const Eigen::MatrixXd> &b,
                 Eigen::Ref<Eigen::MatrixXd> sum);

/// One number per line of a bundle, in one or two SIMD registers.
struct alignas(64) Lanes
{
  static constexpr int n = 8;
  std::array<double, n> value;
};

/// Table of Lanes, row by row.
class LaneTable
{
public:
  LaneTable() = default;
  /// Sets all entries to zero.
  LaneTable(Eigen::Index n_rows, Eigen::Index n_columns) { set_zero(n_rows, n_columns); }

  /// Sets shape and zeros; keeps the memory.
  void set_zero(Eigen::Index n_rows, Eigen::Index n_columns)
  {
    rows = n_rows;
    columns = n_columns;
    values.assign(static_cast<std::size_t>(n_rows * n_columns), Lanes{});
  }

  Eigen::Index n_rows() const { return rows; }
  Eigen::Index n_columns() const { return columns; }
  Lanes *row(Eigen::Index i) { return values.data() + i * columns; }
  const Lanes *row(Eigen::Index i) const { return values.data() + i * columns; }
  double &operator()(Eigen::Index i, Eigen::Index k, int lane) { return row(i)[k].value[lane]; }
  double operator()(Eigen::Index i, Eigen::Index k, int lane) const { return row(i)[k].value[lane]; }

private:
  std::vector<Lanes> values;
  Eigen::Index rows = 0, columns = 0;
};

/// Systems (1 + T D) x = b on Lanes::n lines simultaneously, with several right-hand sides: D is the
/// compliance of a line's circles, T the banded tangent of the table law on the line. Rows of unused circles
/// are rows of the identity. Elimination without pivoting is as stable as for D with scaled rows, because D
/// is positive definite and T nearly diagonal with non-negative entries. Eight lines take 1/4 of the time of
/// Eigen's PartialPivLU with up to 30 circles, 1/2 with 60 (tests/benchmark/dense_benchmark.cc).
class LineBundle
{
public:
  /// Sets all entries to zero, for @p n_circles unknowns of a line, @p band diagonals of T on either side and
  /// @p n_columns right-hand sides.
  void reset(Eigen::Index n_circles, Eigen::Index band, Eigen::Index n_columns);

  /// Returns the entry T(i, k), |i - k| <= band.
  double &tangent(Eigen::Index i, Eigen::Index k, int lane) { return bands(i, k - i + n_band, lane); }
  /// Returns the factor of `radial` in D at column @p i, see solve().
  double &slide(Eigen::Index i, int lane) { return slides(i, 0, lane); }
  /// Returns the right-hand sides except the last one, before multiplication by T.
  double &shape(Eigen::Index i, Eigen::Index column, int lane) { return shapes(i, column, lane); }
  /// Returns the last right-hand side.
  double &unbalanced(Eigen::Index i, int lane) { return system(i, n_unknowns + n_rhs - 1, lane); }

  /// Returns the solutions, shape [n_circles, n_columns], with D = @p normal + @p radial diag(slide), shapes
  /// [n_circles, n_circles]; @p radial may be empty. May be called once after reset().
  LaneTable solve(const RowMatrix &normal, const RowMatrix &radial);

private:
  Eigen::Index n_unknowns = 0, n_band = 0, n_rhs = 0;
  LaneTable bands;  ///< T(i, i + k - band), shape [n_circles, 2 band + 1]
  LaneTable slides; ///< shape [n_circles, 1]
  LaneTable shapes; ///< shape [n_circles, n_columns - 1]
  LaneTable system; ///< matrix and right-hand sides, shape [n_circles, n_circles + n_columns]
  LaneTable local;  ///< D, shape [n_circles, n_circles]
};

/// Returns sum_i weights(i, a) values(i, c) lane by lane, shape [weights.n_columns(), values.n_columns()].
LaneTable products(const LaneTable &weights, const LaneTable &values);

} // namespace stemware::fem
