// What the ring model costs. Build: cmake --preset release -DSTEMWARE_BENCHMARKS=ON, run:
// build/release/ring_benchmark

#include "ring_model/friction_kernels.h"
#include "ring_model/self_consistent_ring.h"
#include "ring_model/unilateral_foundation.h"
#include "ring_model/yaw_motion.h"

#include <benchmark/benchmark.h>
#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

namespace
{
using namespace stemware::ring;

/// Slip ratios from 1e-4 to 1e4, denser towards |eps| = 1, on both sides.
std::vector<double> slip_ratios()
{
  std::vector<double> ratios{ 1. };
  for (int i = 1; i <= 40; ++i)
    ratios.insert(ratios.end(),
                  { i / 41., 41. / i, 1. - std::pow(10., -0.3 * i), 1. + std::pow(10., -0.3 * i),
                    std::pow(10., -0.1 * i), std::pow(10., 0.1 * i) });
  return ratios;
}

/// A load of a crowned rim close to lift-off: all 32 harmonics are there.
RingStack load_of_32_harmonics()
{
  return UnilateralFoundation(0.03, 1.5, 32).rings(2.943, { -0.040, -0.025 });
}

/// All kernels n <= 32 at one slip ratio: the median and the worst over eps are the counters that matter.
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

void torque_of_32_harmonics_by_kernels(benchmark::State &state)
{
  const RingStack load = load_of_32_harmonics();
  const double omega = 0.999 * 0.35 / load.radius();
  for (auto _ : state)
    benchmark::DoNotOptimize(coulomb_wrench(0.3, load, omega, 0.35).torque);
}
BENCHMARK(torque_of_32_harmonics_by_kernels);

/// The same number by adaptive Gauss-Kronrod on the integral itself, with the loosest tolerance that reaches
/// 1e-15 mu N R.
void torque_of_32_harmonics_by_gauss_kronrod(benchmark::State &state)
{
  const RingStack load = load_of_32_harmonics();
  const double mu = 0.3, R = load.radius(), speed = 0.35, omega = 0.999 * speed / R;
  const double exact = coulomb_wrench(mu, load, omega, speed).torque;
  const auto integrand = [&](double theta)
  {
    const double x = speed - omega * R * std::sin(theta), y = omega * R * std::cos(theta);
    return mu * R * load(theta) * (speed * std::sin(theta) - omega * R) / std::hypot(x, y);
  };
  using Rule = boost::math::quadrature::gauss_kronrod<double, 31>;
  const double pi = boost::math::constants::pi<double>(), scale = mu * load.normal_force() * R;
  const auto torque = [&](double tolerance)
  { return Rule::integrate(integrand, -1.5 * pi, 0.5 * pi, 30, tolerance); };
  double tolerance = 0.1;
  while (tolerance > 1e-15 && std::abs(torque(tolerance) - exact) > 1e-15 * scale)
    tolerance /= 10.;
  for (auto _ : state)
    benchmark::DoNotOptimize(torque(tolerance));
  state.counters["tolerance"] = tolerance;
  state.counters["error_over_mu_N_R"] = std::abs(torque(tolerance) - exact) / scale;
}
BENCHMARK(torque_of_32_harmonics_by_gauss_kronrod)->Unit(benchmark::kMicrosecond);

void torque_full_first_harmonic(benchmark::State &state)
{
  const SelfConsistentRing ring(Closure::full, Motion(), 0.03);
  for (auto _ : state)
    benchmark::DoNotOptimize(ring.torque(-3.));
}
BENCHMARK(torque_full_first_harmonic)->Unit(benchmark::kMicrosecond);

/// Any load model: linear mat, with lift-off at 0.12 m.
void torque_full_unilateral(benchmark::State &state)
{
  Motion motion;
  motion.centre_of_mass_height = 0.01 * static_cast<double>(state.range(0));
  const SelfConsistentRing ring(
    Closure::full, motion,
    std::make_shared<UnilateralFoundation>(0.03, 0.1 * static_cast<double>(state.range(1))));
  for (auto _ : state)
    benchmark::DoNotOptimize(ring.torque(-3.));
}
BENCHMARK(torque_full_unilateral)
  ->ArgNames({ "z_CM_cm", "10p" })
  ->Args({ 8, 10 })
  ->Args({ 12, 10 })
  ->Args({ 8, 15 })
  ->Unit(benchmark::kMicrosecond);

/// Two seconds of spin-up to 1e-10 with 201 output times.
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
