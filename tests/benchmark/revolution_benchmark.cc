// What the body of revolution costs on one core. Build: cmake --preset release -DSTEMWARE_BENCHMARKS=ON, run:
// OPENBLAS_NUM_THREADS=1 build/release/revolution_benchmark

#include "fem/revolution/compliance_cache.h"
#include "fem/revolution/meshed_revolution_foot.h"
#include "ring_model/moment_balance.h"
#include "ring_model/self_consistent_ring.h"
#include "ring_model/yaw_motion.h"

#include <deal.II/base/multithread_info.h>
#include <deal.II/grid/tria.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

namespace
{

using namespace stemware::fem;
namespace ring = stemware::ring;

constexpr double weight = 2.943; // N

Resultants load_at(double m)
{
  return { weight, 0, -m * weight * 0.015 };
}

double seconds_of(const std::function<void()> &work)
{
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

double median(std::vector<double> values)
{
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

/// Seventeen compliances of the default foot, mesh included.
void compliances(benchmark::State &state)
{
  for (auto _ : state)
  {
    dealii::Triangulation<2> triangulation;
    make_meridian_mesh(GlassProfile(), MeridianResolution(), triangulation);
    benchmark::DoNotOptimize(compute_compliance(triangulation, ElasticMaterial()));
  }
}
BENCHMARK(compliances)->Unit(benchmark::kMillisecond);

/// A load from the solution 0.01 in m before it, harmonics included; median over m = 0.1 ... 1.8.
void neighbouring_load(benchmark::State &state)
{
  MeshedRevolutionFoot foot{ RevolutionSetup() };
  for (auto _ : state)
  {
    std::vector<double> times;
    ContactState before = foot.solve(load_at(0.1));
    for (double m = 0.11; m < 1.8; m += 0.01)
      times.push_back(seconds_of([&] { before = foot.solve(load_at(m), {}, { &before }); }));
    state.SetIterationTime(median(times));
  }
}
BENCHMARK(neighbouring_load)->UseManualTime()->Iterations(10)->Unit(benchmark::kMillisecond);

/// The same from nothing.
void cold_load(benchmark::State &state)
{
  ComplianceCache cache;
  for (auto _ : state)
  {
    std::vector<double> times;
    for (double m = 0.1; m < 1.8; m += 0.05)
    {
      MeshedRevolutionFoot foot(RevolutionSetup(), cache);
      times.push_back(seconds_of([&] { foot.solve(load_at(m)); }));
    }
    state.SetIterationTime(median(times));
  }
}
BENCHMARK(cold_load)->UseManualTime()->Iterations(10)->Unit(benchmark::kMillisecond);

/// The elastic foot as a load of the ring.
class ElasticLoad : public ring::LoadModel
{
public:
  ring::RingStack rings(double normal_force, const Eigen::Vector2d &moment) const override
  {
    ++n_loads;
    return foot.solve({ normal_force, moment(0), moment(1) }).load;
  }
  double radius() const override { return 0.03; }

  mutable MeshedRevolutionFoot foot{ RevolutionSetup() };
  mutable unsigned int n_loads = 0;
};

/// Two seconds of spin-up from rest, closure `full`, a contact solution at every evaluation of the torque.
void coupled_spin_up(benchmark::State &state)
{
  for (auto _ : state)
  {
    const auto load = std::make_shared<ElasticLoad>();
    const ring::Motion motion;
    const ring::SelfConsistentRing glass(ring::Closure::full, motion, load);
    std::vector<double> times;
    for (unsigned int i = 0; i <= 200; ++i)
      times.push_back(0.01 * i);
    const auto samples =
      ring::yaw_motion([&](double, double, double omega) { return glass.torque(omega); }, motion.yaw_inertia,
                       0, times, 1e-8, motion.orbit_speed / load->radius());
    state.counters["final spin, rad/s"] = samples.back().omega;
    state.counters["contact solutions"] = load->n_loads;
  }
}
BENCHMARK(coupled_spin_up)->Unit(benchmark::kMillisecond)->Iterations(3);

} // namespace

int main(int argc, char **argv)
{
  dealii::MultithreadInfo::set_thread_limit(1);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
