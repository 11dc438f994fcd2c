// The table of the torque over phases and spins against plain quadrature over the rim.
#include "ring_model/spin/curves.h"
#include "ring_model/spin/phase_loads.h"
#include "tests/ring_model/quadrature.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace
{

using namespace stemware::ring;

/// A load of three harmonics whose second and third turn with the glass or the table.
RingStack wavy_load(const Orientation &phase)
{
  return RingStack({ 1., 0.2, 0.1 * std::cos(2. * phase.table), 0.05 * std::cos(3. * phase.glass) },
                   { 0., 0.3, 0.1 * std::sin(2. * phase.table), 0.05 * std::sin(3. * phase.glass) }, 0.03);
}

Load load_by_phase()
{
  const LoadAtPhase exact = [](double, const Orientation &phase) -> Sample { return wavy_load(phase); };
  const PhasePeriods periods = { 2. * M_PI / 3., M_PI };
  return Load(std::make_shared<PhaseSampledLoad>(exact, periods, sample_phases(exact, periods, { 256 })));
}

/// Torque [N m] at a time, yaw angle and spin by the trapezoidal rule.
double plain_torque(const Motion &motion, double time, double yaw_angle, double omega)
{
  const RingStack load = wavy_load(orientation_of_marks(motion, time, yaw_angle));
  return test::wrench_by_quadrature(motion.friction_coefficient, load,
                                    omega * load.radius() / motion.orbit_speed, load.radius(), 4096)
    .torque;
}

} // namespace

TEST(TabulatedTorque, IsThatOfTheLoadBetweenPhasesAndSpins)
{
  const Load load = load_by_phase();
  const Motion motion;
  const double scale = load.spin_scale(motion), size = motion.friction_coefficient * 2. * M_PI * 0.03;
  const PhasedTorqueFunction torque = tabulated_torque(load, motion, 0.4 * scale, 0.05 * scale, 1e-9 * size);
  for (int i = 0; i < 20; ++i)
  {
    const double time = 0.37 * i, yaw_angle = 1.3 * i, omega = scale * (0.35 + 0.1 * i / 19.);
    EXPECT_NEAR(torque(time, yaw_angle, omega), plain_torque(motion, time, yaw_angle, omega), 2e-9 * size)
      << omega;
  }
}

TEST(TabulatedTorque, BeyondItsTableIsThatOfTheLoadItself)
{
  const Load load = load_by_phase();
  const Motion motion;
  const double scale = load.spin_scale(motion), size = motion.friction_coefficient * 2. * M_PI * 0.03;
  const PhasedTorqueFunction torque = tabulated_torque(load, motion, 0.4 * scale, 0.01 * scale, 1e-9 * size);
  for (const double share : { -0.7, 0., 0.2, 0.6 })
    EXPECT_NEAR(torque(0.3, 0.7, share * scale), plain_torque(motion, 0.3, 0.7, share * scale), 1e-9 * size)
      << share;
}

TEST(TabulatedTorque, TheMotionInTheLongRunIsObserved)
{
  const Load load = load_by_phase();
  Question question = { Motion() };
  double latest = 0.;
  question.observer = [&](double time) { latest = std::max(latest, time); };
  answer(load, question).value();
  // Two windows of a dozen orbits at least.
  EXPECT_GT(latest, 24. * M_PI / std::abs(question.motion.orbit_rate()));
}

TEST(PhaseSampledLoad, AnErrorBelongsToTheIntervalOfItsSpins)
{
  // A kink between 0 and 1 rad/s; linear in the spin between 1 and 2 rad/s.
  const LoadAtPhase kinked = [](double omega, const Orientation &phase) -> Sample
  {
    const double wave = 0.05 * std::cos(2. * phase.glass);
    return RingStack({ 1., 0.2, wave }, { 0., 0.3 + 0.1 * std::abs(omega - 0.37), 0. }, 0.03);
  };
  const PhasePeriods periods = { M_PI, 0. };
  SpinSampling spins;
  spins.unit = 1.;
  const PhaseSampledLoad loads(kinked, periods, sample_phases(kinked, periods, { 256 }), spins);
  loads.mean(0.5);
  loads.mean(1.5);
  EXPECT_GT(loads.error().mean, 1e-4);
  EXPECT_LT(loads.error(1.2, 1.8).mean, 1e-9);
  EXPECT_EQ(loads.error(0.9, 1.8).mean, loads.error().mean);
  const Motion motion;
  for (const double omega : { 1.3, 1.8 })
    EXPECT_NEAR(yaw_torque(Load([&](double spin) { return loads.mean(spin); }), motion, omega),
                yaw_torque(Load(
                             [&](double spin) {
                               return kinked(spin, { M_PI / 4., 0. });
                             }),
                           motion, omega),
                1e-9 * motion.friction_coefficient * 2. * M_PI * 0.03);
}

TEST(TabulatedTorque, IsThatOfTheLoadAcrossTheKinkAtTheSpeedOfTheRim)
{
  const Load load = load_by_phase();
  const Motion motion;
  const double scale = load.spin_scale(motion), size = motion.friction_coefficient * 2. * M_PI * 0.03;
  const PhasedTorqueFunction torque = tabulated_torque(load, motion, scale, 0.05 * scale, 1e-9 * size);
  for (const double share : { 0.97, 0.999, 1.01 }) // the quadrature is good to 1e-5 beside the kink
    EXPECT_NEAR(torque(0.3, 0.7, share * scale), plain_torque(motion, 0.3, 0.7, share * scale), 1e-5 * size)
      << share;
}
