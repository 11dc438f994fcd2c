// Table of the torque as a function of phase and spin. Reference: plain quadrature over the rim.
#include "ring_model/load/constants.h"
#include "ring_model/spin/curves.h"
#include "ring_model/spin/phase_loads.h"
#include "tests/ring_model/quadrature.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace
{

using namespace stemware::ring;

/// Returns a load of three harmonics. The second harmonic rotates with the table, the third with the glass.
RingStack wavy_load(const Orientation &phase)
{
  return RingStack({ 1., 0.2, 0.1 * std::cos(2. * phase.table), 0.05 * std::cos(3. * phase.glass) },
                   { 0., 0.3, 0.1 * std::sin(2. * phase.table), 0.05 * std::sin(3. * phase.glass) }, 0.03);
}

Load load_by_phase()
{
  const LoadAtPhase exact = [](double, const Orientation &phase) -> Sample { return wavy_load(phase); };
  const PhasePeriods periods = { 2. * pi / 3., pi };
  return Load(std::make_shared<PhaseSampledLoad>(exact, periods, sample_phases(exact, periods, { 256 })));
}

/// Returns the torque [N m] at a time, yaw angle and spin, computed by the trapezoidal rule.
double plain_torque(const Motion &motion, double time, double yaw_angle, double omega)
{
  const RingStack load = wavy_load(orientation_of_marks(motion, time, yaw_angle));
  return test::wrench_by_quadrature(motion.friction_coefficient, load,
                                    omega * load.radius() / motion.orbit_speed, load.radius(), 4096)
    .torque;
}

} // namespace

TEST(TabulatedTorque, InterpolatesBetweenPhasesAndSpins)
{
  const Load load = load_by_phase();
  const Motion motion;
  const double scale = load.spin_scale(motion), size = motion.friction_coefficient * 2. * pi * 0.03;
  const PhasedTorqueFunction torque = tabulated_torque(load, motion, 0.4 * scale, 0.05 * scale, 1e-9 * size);
  for (int i = 0; i < 20; ++i)
  {
    const double time = 0.37 * i, yaw_angle = 1.3 * i, omega = scale * (0.35 + 0.1 * i / 19.);
    EXPECT_NEAR(torque(time, yaw_angle, omega), plain_torque(motion, time, yaw_angle, omega), 2e-9 * size)
      << omega;
  }
}

TEST(TabulatedTorque, UsesTheLoadItselfOutsideItsTable)
{
  const Load load = load_by_phase();
  const Motion motion;
  const double scale = load.spin_scale(motion), size = motion.friction_coefficient * 2. * pi * 0.03;
  const PhasedTorqueFunction torque = tabulated_torque(load, motion, 0.4 * scale, 0.01 * scale, 1e-9 * size);
  for (const double share : { -0.7, 0., 0.2, 0.6 })
    EXPECT_NEAR(torque(0.3, 0.7, share * scale), plain_torque(motion, 0.3, 0.7, share * scale), 1e-9 * size)
      << share;
}

TEST(TabulatedTorque, IsExactAcrossTheKinkAtSlipRatioOne)
{
  const Load load = load_by_phase();
  const Motion motion;
  const double scale = load.spin_scale(motion), size = motion.friction_coefficient * 2. * pi * 0.03;
  const PhasedTorqueFunction torque = tabulated_torque(load, motion, scale, 0.05 * scale, 1e-9 * size);
  for (const double share : { 0.97, 0.999, 1.01 }) // the quadrature error next to the kink is 1e-5
    EXPECT_NEAR(torque(0.3, 0.7, share * scale), plain_torque(motion, 0.3, 0.7, share * scale), 1e-5 * size)
      << share;
}
