// Time of the dense systems of a Newton step on azimuth lines: fem/revolution against Eigen's PartialPivLU.
// Build: cmake --preset bench && cmake --build --preset bench --target dense_algebra_benchmark
// Run: build/bench/dense_algebra_benchmark

#include "fem/revolution/dense_algebra.h"
#include "fem/revolution/line_bundle.h"

#include <Eigen/LU>
#include <benchmark/benchmark.h>

#include <algorithm>

namespace
{

using namespace stemware::fem;

/// Returns a system of @p n amplitudes with the four right-hand sides of a Newton step.
RowMatrix system_of(Eigen::Index n)
{
  RowMatrix system = RowMatrix::Random(n, n + 4);
  system.diagonal().array() += 4;
  return system;
}

void amplitudes(benchmark::State &state)
{
  const RowMatrix system = system_of(state.range(0));
  for (auto _ : state)
  {
    RowMatrix solved = system;
    solve_dense(solved, 4);
    benchmark::DoNotOptimize(solved.data());
  }
}
BENCHMARK(amplitudes)->Arg(33)->Arg(66)->Arg(132)->Arg(330)->Unit(benchmark::kMicrosecond);

void amplitudes_by_eigen(benchmark::State &state)
{
  const RowMatrix system = system_of(state.range(0));
  const Eigen::Index n = system.rows();
  for (auto _ : state)
  {
    RowMatrix solved = system;
    solved.rightCols(4) = Eigen::PartialPivLU<Eigen::MatrixXd>(system.leftCols(n)).solve(system.rightCols(4));
    benchmark::DoNotOptimize(solved.data());
  }
}
BENCHMARK(amplitudes_by_eigen)->Arg(33)->Arg(66)->Arg(132)->Arg(330)->Unit(benchmark::kMicrosecond);

constexpr Eigen::Index n_columns = 8, band = 2; ///< four functions, quadratic elements

/// Returns a positive definite compliance of @p n circles.
RowMatrix compliance_of(Eigen::Index n)
{
  const RowMatrix random = RowMatrix::Random(n, n);
  return RowMatrix(random * random.transpose()) + RowMatrix::Identity(n, n);
}

void fill(LineBundle &lines, Eigen::Index n)
{
  lines.reset(n, band, n_columns);
  for (int lane = 0; lane < Lanes::n; ++lane)
    for (Eigen::Index i = 0; i < n; ++i)
    {
      for (Eigen::Index k = std::max<Eigen::Index>(0, i - band); k <= std::min(n - 1, i + band); ++k)
        lines.tangent(i, k, lane) = k == i ? 2 : 0.1;
      for (Eigen::Index c = 0; c + 1 < n_columns; ++c)
        lines.shape(i, c, lane) = 1. / static_cast<double>(i + c + 1);
      lines.unbalanced(i, lane) = 1;
    }
}

void eight_lines(benchmark::State &state)
{
  const Eigen::Index n = state.range(0);
  const RowMatrix normal = compliance_of(n);
  LineBundle lines;
  for (auto _ : state)
  {
    fill(lines, n);
    benchmark::DoNotOptimize(lines.solve(normal, {})(0, 0, 0));
  }
}
BENCHMARK(eight_lines)->Arg(9)->Arg(17)->Arg(33)->Arg(65)->Unit(benchmark::kMicrosecond);

void eight_lines_by_eigen(benchmark::State &state)
{
  const Eigen::Index n = state.range(0);
  const Eigen::MatrixXd normal = compliance_of(n);
  Eigen::MatrixXd tangent(n, n), right(n, n_columns);
  for (auto _ : state)
    for (int lane = 0; lane < Lanes::n; ++lane)
    {
      tangent.setZero();
      right.setOnes();
      for (Eigen::Index i = 0; i < n; ++i)
      {
        for (Eigen::Index k = std::max<Eigen::Index>(0, i - band); k <= std::min(n - 1, i + band); ++k)
          tangent(i, k) = k == i ? 2 : 0.1;
        for (Eigen::Index c = 0; c + 1 < n_columns; ++c)
          right(i, c) = 1. / static_cast<double>(i + c + 1);
      }
      Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(n, n), applied = right;
      for (Eigen::Index i = 0; i < n; ++i)
      {
        const Eigen::Index first = std::max<Eigen::Index>(0, i - band),
                           size = std::min(n - 1, i + band) + 1 - first;
        matrix.row(i) += tangent.row(i).segment(first, size) * normal.middleRows(first, size);
        applied.row(i) = tangent.row(i).segment(first, size) * right.middleRows(first, size);
      }
      applied = Eigen::PartialPivLU<Eigen::MatrixXd>(matrix).solve(applied);
      benchmark::DoNotOptimize(applied.data());
    }
}
BENCHMARK(eight_lines_by_eigen)->Arg(9)->Arg(17)->Arg(33)->Arg(65)->Unit(benchmark::kMicrosecond);

} // namespace

BENCHMARK_MAIN();
