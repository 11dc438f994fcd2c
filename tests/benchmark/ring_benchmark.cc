// Computing time of the ring model.
// Build: cmake --preset release -DSTEMWARE_BENCHMARKS=ON && cmake --build --preset release
// Run: build/release/ring_benchmark

#include "ring_model/friction_kernels.h"
#include "ring_model/self_consistent_ring.h"
#include "ring_model/yaw_motion.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

namespace
{
using namespace stemware::ring;

std::vector<double> slip_ratios()
{
  std::vector<double> ratios{ 1. };
  for (int i = 1; i <= 40; ++i)
    ratios.insert(ratios.end(),
                  { i / 41., 41. / i, 1. - std::pow(10., -0.3 * i), 1. + std::pow(10., -0.3 * i),
                    std::pow(10., -0.1 * i), std::pow(10., 0.1 * i) });
  return ratios;
}

/// Times the kernels n <= 32. Counters: median and maximum over the slip ratios [us].
void kernels_to_32(benchmark::State &state)
{
  const std::vector<double> ratios = slip_ratios();
  std::vector<double> fastest(ratios.size(), HUGE_VAL);
  for (auto _ : state)
    for (std::size_t i = 0; i < ratios.size(); ++i)
    {
      const unsigned int n_calls = 100;
      const auto start = std::chrono::steady_clock::now();
      for (unsigned int k = 0; k < n_calls; ++k)
      {
        const auto kernels = FrictionKernels(ratios[i], 1., 32);
        benchmark::DoNotOptimize(kernels.K(32));
      }
      const std::chrono::duration<double, std::micro> time = std::chrono::steady_clock::now() - start;
      fastest[i] = std::min(fastest[i], time.count() / n_calls);
    }
  std::sort(fastest.begin(), fastest.end());
  state.counters["median_us"] = fastest[fastest.size() / 2];
  state.counters["worst_us"] = fastest.back();
}
BENCHMARK(kernels_to_32)->Unit(benchmark::kMillisecond);

/// Times the integration of two seconds of spin-up with tolerance 1e-10 and 201 output times.
void trajectory(benchmark::State &state, Closure closure)
{
  const Motion motion;
  const SelfConsistentRing ring(closure, motion, 0.03);
  std::vector<double> times;
  for (int i = 0; i <= 200; ++i)
    times.push_back(0.01 * i);
  for (auto _ : state)
    benchmark::DoNotOptimize(yaw_motion([&](double, double, double omega) { return ring.torque(omega); },
                                        motion.yaw_inertia, 0., times, 1e-10, 1.));
}
BENCHMARK_CAPTURE(trajectory, paper, Closure::paper)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(trajectory, full, Closure::full)->Unit(benchmark::kMicrosecond);
} // namespace

BENCHMARK_MAIN();
