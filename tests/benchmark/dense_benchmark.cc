// Computing time of the dense linear solvers for a foot of revolution, compared with Eigen's PartialPivLU.
// Build: cmake --preset bench && cmake --build --preset bench --target dense_benchmark
// Run: build/bench/dense_benchmark

#include "fem/revolution/dense_algebra.h"

#include <Eigen/LU>
#include <benchmark/benchmark.h>

namespace
{
using namespace stemware::fem;

/// Returns a full, symmetric, positive definite matrix, similar to the compliance of @p n circles under line
/// loads.
RowMatrix compliance(Eigen::Index n)
{
  return RowMatrix::NullaryExpr(n, n,
                                [](Eigen::Index i, Eigen::Index k)
                                { return 1. / (1 + std::abs(double(i - k))) + (i == k ? 2 : 0); });
}

constexpr Eigen::Index n_columns = 4; // right-hand sides of a Newton step

void dense_stemware(benchmark::State &state)
{
  RowMatrix system(state.range(0), state.range(0) + n_columns);
  for (auto _ : state)
  {
    system << compliance(state.range(0)), RowMatrix::Ones(state.range(0), n_columns);
    solve_dense(system, n_columns);
    benchmark::DoNotOptimize(system.data());
  }
}

void dense_eigen(benchmark::State &state)
{
  RowMatrix solution;
  for (auto _ : state)
  {
    solution = Eigen::PartialPivLU<RowMatrix>(compliance(state.range(0)))
                 .solve(RowMatrix::Ones(state.range(0), n_columns));
    benchmark::DoNotOptimize(solution.data());
  }
}

/// Times the solution of Newton's linear systems. Each SIMD lane has one contact line with range(0) circles
/// and the identity as tangent.
void lines_stemware(benchmark::State &state)
{
  const Eigen::Index n = state.range(0);
  const RowMatrix normal = compliance(n);
  LineBundle bundle;
  for (auto _ : state)
  {
    bundle.reset(n, 1, n_columns);
    for (Eigen::Index i = 0; i < n; ++i)
      for (int lane = 0; lane < Lanes::n; ++lane)
      {
        bundle.tangent(i, i, lane) = bundle.unbalanced(i, lane) = 1;
        for (Eigen::Index column = 0; column + 1 < n_columns; ++column)
          bundle.shape(i, column, lane) = 1;
      }
    benchmark::DoNotOptimize(bundle.solve(normal, RowMatrix()));
  }
}

void lines_eigen(benchmark::State &state)
{
  const RowMatrix system = RowMatrix::Identity(state.range(0), state.range(0)) + compliance(state.range(0));
  RowMatrix solution;
  for (auto _ : state)
    for (int lane = 0; lane < Lanes::n; ++lane)
    {
      solution = Eigen::PartialPivLU<RowMatrix>(system).solve(RowMatrix::Ones(state.range(0), n_columns));
      benchmark::DoNotOptimize(solution.data());
    }
}

BENCHMARK(dense_stemware)->Arg(30)->Arg(60)->Arg(120)->Arg(300)->Unit(benchmark::kMicrosecond);
BENCHMARK(dense_eigen)->Arg(30)->Arg(60)->Arg(120)->Arg(300)->Unit(benchmark::kMicrosecond);
BENCHMARK(lines_stemware)->Arg(15)->Arg(30)->Arg(60)->Unit(benchmark::kMicrosecond);
BENCHMARK(lines_eigen)->Arg(15)->Arg(30)->Arg(60)->Unit(benchmark::kMicrosecond);
} // namespace

BENCHMARK_MAIN();
