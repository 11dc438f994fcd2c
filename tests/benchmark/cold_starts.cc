// Cold starts of the contact solver over a wide grid of feet, mats and loads: how many converge, and in how
// many steps. Build: cmake --preset release -DSTEMWARE_BENCHMARKS=ON, run: build/release/cold_starts

#include "fem/revolution/compliance_cache.h"
#include "fem/revolution/meshed_revolution_foot.h"

#include <deal.II/base/multithread_info.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace
{

using namespace stemware::fem;

constexpr double weight = 2.943; // N

/// What the grid has shown so far.
struct Tally
{
  unsigned int n_cases = 0;
  unsigned int n_failed = 0;
  unsigned int most_steps = 0;
  double smallest_contact_below_one =
    1; ///< share of the ring in contact at m <= 0.2, where only imperfections lift it
};

/// A foot on a mat, with an imperfect rim whose amplitude is @p roughness times the depth to which a perfect
/// rim sinks in.
RevolutionSetup setup_of(double crown_radius, double modulus, double roughness)
{
  RevolutionSetup setup;
  setup.profile.crown_radius = crown_radius;
  setup.table.interface = std::make_shared<WinklerInterface>(modulus);
  const double line_load = weight / (2 * M_PI * setup.profile.contact_radius);
  const double half_width = std::cbrt(1.5 * line_load * crown_radius / modulus);
  const double depth = half_width * half_width / (2 * crown_radius);
  if (roughness > 0)
    setup.imperfection.glass = { { 2, 0.3 * roughness * depth, 0 },
                                 { 3, 0.2 * roughness * depth, M_PI / 6 } };
  return setup;
}

void press_at_every_moment(const RevolutionSetup &setup, ComplianceCache &cache, Tally &tally)
{
  for (const double m : { 0., 0.05, 0.1, 0.2, 0.4, 0.6, 0.8, 1., 1.1, 1.2, 1.3, 1.5, 1.7, 1.8, 1.9, 1.95 })
  {
    ++tally.n_cases;
    MeshedRevolutionFoot foot(setup, cache);
    const double moment = m * weight * 0.015;
    try
    {
      const ContactState state = foot.solve({ weight, moment * std::sin(0.3), -moment * std::cos(0.3) });
      tally.most_steps = std::max(tally.most_steps, state.solution.n_iterations);
      if (m <= 0.2)
        tally.smallest_contact_below_one =
          std::min(tally.smallest_contact_below_one, state.load.contact_fraction);
    }
    catch (const ContactFailure &failure)
    {
      ++tally.n_failed;
      std::printf("m = %g: %s\n", m, failure.what());
    }
  }
}

} // namespace

int main()
{
  dealii::MultithreadInfo::set_thread_limit(1);
  Tally tally;
  ComplianceCache cache;
  for (const double crown_radius : { 3e-4, 1e-3, 3e-3, 1e-2, 3e-2 })
    for (const double modulus : { 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13 })
      for (const double roughness : { 0., 1., 5., 20. })
        press_at_every_moment(setup_of(crown_radius, modulus, roughness), cache, tally);
  std::printf(
    "%u cases, %u failed, at most %u Newton steps; least share of the ring in contact at m <= 0.2: %.2f\n",
    tally.n_cases, tally.n_failed, tally.most_steps, tally.smallest_contact_below_one);
  return tally.n_failed > 0 ? 1 : 0;
}
