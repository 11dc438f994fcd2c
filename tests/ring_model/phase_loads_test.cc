#include "ring_model/load/constants.h"
#include "ring_model/spin/curves.h"
#include "ring_model/spin/phase_loads.h"
#include "tests/ring_model/quadrature.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

namespace
{

using namespace stemware::ring;

/// Returns a load whose second harmonic rotates with the table and whose third harmonic rotates with the
/// glass.
RingStack wavy_load(const Orientation &phase)
{
  return RingStack({ 1., 0.2, 0.1 * std::cos(2. * phase.table), 0.05 * std::cos(3. * phase.glass) },
                   { 0., 0.3, 0.1 * std::sin(2. * phase.table), 0.05 * std::sin(3. * phase.glass) }, 0.03);
}

Load load_by_phase()
{
  const LoadAtPhase exact = [](double, const Orientation &phase) -> Sample { return wavy_load(phase); };
  const PhasePeriods periods = { 2. * pi / 3., pi };
  return Load(std::make_shared<PhaseSampledLoad>(exact, periods, sample_phases(exact, periods, 256)));
}

/// Expects the torque tabulated within @p reach of the spin @p middle to agree with the trapezoidal rule at
/// @p spins. Spins are in units of v / R, @p tolerance in units of mu N R.
void expect_torques(double middle, double reach, const std::vector<double> &spins, double tolerance)
{
  const Load load = load_by_phase();
  const Motion motion;
  const double scale = load.spin_scale(motion), size = motion.friction_coefficient * 2. * pi * 0.03;
  const PhasedTorqueFunction torque =
    tabulated_torque(load, motion, middle * scale, reach * scale, 1e-9 * size);
  double time = 0., yaw_angle = 0.;
  for (const double spin : spins)
  {
    const RingStack exact = wavy_load(orientation_of_marks(motion, time, yaw_angle));
    const Wrench expected =
      test::wrench_by_quadrature(motion.friction_coefficient, exact,
                                 spin * scale * exact.radius() / motion.orbit_speed, exact.radius(), 4096);
    EXPECT_NEAR(torque(time, yaw_angle, spin * scale), expected.torque, tolerance * size) << spin;
    time += 0.37;
    yaw_angle += 1.3;
  }
}

} // namespace

TEST(TabulatedTorque, AgreesWithQuadratureInsideItsTable)
{
  std::vector<double> spins;
  for (int i = 0; i < 20; ++i)
    spins.push_back(0.35 + 0.1 * i / 19.);
  expect_torques(0.4, 0.05, spins, 2e-9);
}

TEST(TabulatedTorque, AgreesWithQuadratureOutsideItsTable)
{
  expect_torques(0.4, 0.01, { -0.7, 0., 0.2, 0.6 }, 1e-9);
}

TEST(TabulatedTorque, IsAccurateAcrossTheKinkAtSlipRatioOne)
{
  expect_torques(1., 0.05, { 0.97, 0.999, 1.01 }, 1e-5); // the quadrature error at the kink is 1e-5 of mu N R
}
