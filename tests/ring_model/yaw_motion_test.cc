#include "ring_model/load/constants.h"
#include "ring_model/yaw_motion.h"

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace stemware::ring
{
namespace
{
constexpr double inertia = 3e-4; // [kg m^2]

/// Damped ring with the torque tau = -damping (1 + roughness sin phi) (omega - drive) + bump cos phi, where
/// phi = yaw angle - orbit t is the angle of a mark on the ring.
struct MarkedRing
{
  double damping = 1.2e-3; ///< [N m s]
  double drive = -3.6;     ///< [rad/s]
  double bump = 4e-4;      ///< [N m]
  double orbit = 2.3;      ///< [rad/s]
  double roughness = 0.;   ///< relative amplitude of the damping's variation with phi
  double inertia = ring::inertia;

  double operator()(double time, double yaw_angle, double omega) const
  {
    const double phase = yaw_angle - orbit * time;
    return -damping * (1. + roughness * std::sin(phase)) * (omega - drive) + bump * std::cos(phase);
  }
};

/// Returns mean and ripple of the spin [rad/s] after @p n_turns revolutions of the mark. Integrates d omega /
/// d phi = tau / (I (omega - orbit)) and d t / d phi = 1 / (omega - orbit).
std::array<double, 2> spin_by_angle(const MarkedRing &ring, unsigned int n_turns, unsigned int n_steps)
{
  const double step = -2. * pi / n_steps; // the ring turns slower than the orbit, so phi decreases
  const auto rates = [&](double angle, double omega)
  {
    return std::array{ ring(0., angle, omega) / (ring.inertia * (omega - ring.orbit)),
                       1. / (omega - ring.orbit) };
  };
  double omega = ring.drive, period = 0., most = 0., least = 0.;
  for (unsigned int turn = 0; turn < n_turns; ++turn)
  {
    period = 0.;
    most = least = omega;
    for (unsigned int i = 0; i < n_steps; ++i)
    {
      const double angle = i * step;
      const auto first = rates(angle, omega);
      const auto second = rates(angle + step / 2., omega + step / 2. * first[0]);
      const auto third = rates(angle + step / 2., omega + step / 2. * second[0]);
      const auto fourth = rates(angle + step, omega + step * third[0]);
      omega += step / 6. * (first[0] + 2. * second[0] + 2. * third[0] + fourth[0]);
      period += step / 6. * (first[1] + 2. * second[1] + 2. * third[1] + fourth[1]);
      most = std::max(most, omega);
      least = std::min(least, omega);
    }
  }
  return { ring.orbit - 2. * pi / period, (most - least) / 2. };
}
} // namespace

TEST(YawMotion, AgreesWithTheClosedFormOfAPendulum)
{
  // Pendulum I psi'' = -A sin psi from psi = 0 at omega_0: omega = omega_0 dn(omega_0 t / 2, k), psi = 2
  // asin(sn(omega_0 t / 2, k)) with the modulus k = 2 sqrt(A / I) / omega_0.
  const double spin = 7., stiffness = 3e-3, modulus = 2. * std::sqrt(stiffness / inertia) / spin;
  const auto torque = [=](double, double angle, double) { return -stiffness * std::sin(angle); };
  const std::vector<double> times = { 0., 0.05, 0.3, 0.41 };
  const auto samples = yaw_motion(torque, inertia, spin, times, 1e-11, spin);
  for (const YawSample &sample : samples)
  {
    double cn = 0., dn = 0.;
    const double sn = boost::math::jacobi_elliptic(modulus, spin * sample.time / 2., &cn, &dn);
    EXPECT_NEAR(sample.omega, spin * dn, 1e-9) << sample.time;
    EXPECT_NEAR(sample.yaw_angle, 2. * std::asin(sn), 1e-9) << sample.time;
  }

  const TerminalSpin turning = long_time_spin(torque, inertia, spin, 20., 1e-9, spin);
  EXPECT_NEAR(turning.omega, pi * spin / (2. * boost::math::ellint_1(modulus)), 1e-7);
  EXPECT_NEAR(turning.ripple, spin * (1. - std::sqrt(1. - modulus * modulus)) / 2., 1e-4);
}

TEST(YawMotion, AgreesWithTheClosedFormOfAForcedRing)
{
  // Closed form of I omega' = -c (omega - omega_0) + A cos(nu t) from rest. Time constants: 0.25 s, and 1e-5
  // to 1e-12 s.
  const double damping = 1.2e-3, drive = -3.6, force = 4e-4, nu = 4.6;
  unsigned int n_torques = 0;
  const auto torque = [&](double time, double, double omega)
  {
    ++n_torques;
    return -damping * (omega - drive) + force * std::cos(nu * time);
  };
  for (const auto &[own_inertia, accuracy] : { std::pair(inertia, 1e-11), std::pair(1e-8, 1e-10),
                                               std::pair(1e-11, 1e-10), std::pair(1e-15, 1e-10) })
  {
    n_torques = 0;
    const double rate = damping / own_inertia, amplitude = force / own_inertia / (rate * rate + nu * nu);
    for (const YawSample &sample :
         yaw_motion(torque, own_inertia, 0., { 2e-6, 2e-5, 0.1, 0.7, 2. }, accuracy, 10.))
    {
      const double time = sample.time, decay = std::exp(-rate * time), cosine = std::cos(nu * time),
                   sine = std::sin(nu * time);
      const double omega = drive * (1. - decay) + amplitude * (rate * cosine + nu * sine - rate * decay);
      const double angle =
        drive * (time - (1. - decay) / rate) + amplitude * (rate / nu * sine + 1. - cosine - (1. - decay));
      EXPECT_NEAR(sample.omega, omega, 1e-9) << own_inertia << " at " << time;
      EXPECT_NEAR(sample.yaw_angle, angle, 1e-9) << own_inertia << " at " << time;
    }
    EXPECT_LT(n_torques, 20000u) << own_inertia;
  }
  const TerminalSpin spin = long_time_spin(torque, inertia, 0., 25., 1e-9, 10.);
  EXPECT_NEAR(spin.omega, drive, 1e-8);
  EXPECT_NEAR(spin.ripple, force / std::hypot(damping, inertia * nu), 1e-7);
}

TEST(YawMotion, AgreesWithTheClosedFormOfAStiffOverdampedSpring)
{
  // Overdamped ring I psi'' = -c (psi' - omega_0) - k psi with roots near -c / I and -k / c. The time steps
  // exceed c / k = 6e-3 s, so Newton's method needs the derivative of the torque with respect to the angle.
  const double inertia = 1e-11, damping = 1.2e-3, drive = -3.6, spring = 0.2;
  unsigned int n_torques = 0;
  const auto torque = [&](double, double angle, double omega)
  {
    ++n_torques;
    return -damping * (omega - drive) - spring * angle;
  };
  const double rate = damping / inertia, root = std::sqrt(rate * rate - 4. * spring / inertia),
               fast = -(rate + root) / 2., slow = spring / inertia / fast, end = damping * drive / spring;
  for (const YawSample &sample : yaw_motion(torque, inertia, 0., { 0.01, 1., 5., 20. }, 1e-10, 10.))
  {
    const double angle =
      end *
      (1. + (slow * std::exp(fast * sample.time) - fast * std::exp(slow * sample.time)) / (fast - slow));
    const double omega =
      end * fast * slow * (std::exp(fast * sample.time) - std::exp(slow * sample.time)) / (fast - slow);
    EXPECT_NEAR(sample.yaw_angle, angle, 1e-9) << sample.time;
    EXPECT_NEAR(sample.omega, omega, 1e-9) << sample.time;
  }
  EXPECT_LT(n_torques, 10000u);
}

TEST(YawMotion, AgreesWithAManufacturedSolutionUnderStiffNonlinearDamping)
{
  // Manufactured solution: tau = I s'(t) - c (omega + omega^3 - s - s^3) with the spin s(t) = 2 + cos(nu t).
  // The damping varies by a factor of seven within a period.
  const double inertia = 1e-9, damping = 1.2e-3, nu = 4.6;
  unsigned int n_torques = 0;
  const auto torque = [&](double time, double, double omega)
  {
    ++n_torques;
    const double s = 2. + std::cos(nu * time);
    return -inertia * nu * std::sin(nu * time) -
           damping * (omega - s) * (1. + omega * omega + omega * s + s * s);
  };
  for (const YawSample &sample : yaw_motion(torque, inertia, 3., { 0.1, 0.7, 2. }, 1e-10, 10.))
  {
    EXPECT_NEAR(sample.omega, 2. + std::cos(nu * sample.time), 1e-9) << sample.time;
    EXPECT_NEAR(sample.yaw_angle, 2. * sample.time + std::sin(nu * sample.time) / nu, 1e-9) << sample.time;
  }
  EXPECT_LT(n_torques, 30000u);
}

TEST(YawMotion, AGripHoldsAndReleasesTheGlassAsInTheClosedForm)
{
  // I omega' = A cos(nu t) - c omega - grip sgn(omega) has a closed form while the glass spins. The glass
  // stops at a root of the closed form and starts again when A |cos(nu t)| exceeds the grip.
  constexpr double damping = 1.2e-3, force = 4e-3, nu = 4.6, grip = 2.5e-3;
  for (const double inertia : { 3e-4, 1e-9 })
  {
    const double rate = damping / inertia, scale = force / inertia / (rate * rate + nu * nu);
    double began = 0.;
    int turns = 1;
    const auto turning = [&](double time) // solution with omega(began) = 0
    {
      const auto forced = [&](double t)
      { return scale * (rate * std::cos(nu * t) + nu * std::sin(nu * t)) - turns * grip / damping; };
      return forced(time) - forced(began) * std::exp(-rate * (time - began));
    };
    std::vector<double> times, expected;
    for (unsigned int half = 0; half < 6; ++half, turns = -turns)
    {
      double turned = began + 1e-3, stopped = began + pi / nu;
      while (stopped - turned > 1e-15 * stopped && turned < (turned + stopped) / 2. &&
             (turned + stopped) / 2. < stopped)
        (turns * turning((turned + stopped) / 2.) > 0. ? turned : stopped) = (turned + stopped) / 2.;
      for (const double share : { 0.01, 0.3, 0.6, 0.99 })
      {
        times.push_back(began + share * (stopped - began));
        expected.push_back(turning(times.back()));
      }
      began = ((half + 1) * pi - std::acos(grip / force)) / nu;
      ASSERT_GT(began, stopped);
      for (const double share : { 0.01, 0.5, 0.99 })
      {
        times.push_back(stopped + share * (began - stopped));
        expected.push_back(0.);
      }
    }
    unsigned int n_torques = 0;
    const auto torque = [&](double time, double, double omega)
    {
      ++n_torques;
      return force * std::cos(nu * time) - damping * omega;
    };
    const auto samples = yaw_motion(torque, inertia, 0., times, 1e-11, 3., grip);
    for (unsigned int i = 0; i < times.size(); ++i)
      if (expected[i] == 0.)
        EXPECT_EQ(samples[i].omega, 0.) << inertia << " at " << times[i];
      else
        EXPECT_NEAR(samples[i].omega, expected[i], 1e-8) << inertia << " at " << times[i];
    EXPECT_LT(n_torques, 40000u);
  }
}

TEST(YawMotion, AHeldGlassStopsAndStaysAtRest)
{
  const auto torque = [](double time, double, double omega)
  { return 1e-3 * std::sin(9. * time) - 1e-3 * omega; };
  for (const YawSample &sample : yaw_motion(torque, inertia, 0., { 0., 0.3, 2. }, 1e-9, 10., 1.0001e-3))
    EXPECT_EQ(sample.omega, 0.);
  EXPECT_EQ(long_time_spin(torque, inertia, 0.1, 3., 1e-9, 10., 1.0001e-3).omega, 0.);
  for (const YawSample &sample : yaw_motion_euler(torque, inertia, 0.1, 1e-2, 300, 1.0001e-3))
  {
    if (sample.time > 1.)
    {
      EXPECT_EQ(sample.omega, 0.) << sample.time;
    }
  }
}

TEST(YawMotion, IsAccurateIfTheCornersOfTheTorqueAreGivenAsBreaks)
{
  // The time derivative of the torque jumps thirty times.
  const double rate = 4.;
  const auto drive = [](double t)
  { return std::abs(std::remainder(t, 0.2)); }; // corners at multiples of 0.1 s
  const auto torque = [&](double time, double, double omega)
  { return inertia * rate * (drive(time) - omega); };
  std::vector<double> breaks, times;
  for (int i = 0; i <= 30; ++i)
  {
    breaks.push_back(0.1 * i);
    times.push_back(0.1 * i + 0.03);
  }
  const auto samples = yaw_motion(torque, inertia, 0., times, 1e-6, 1., 0., breaks);
  double omega = 0.; // spin at the previous break
  for (int i = 0; i <= 30; ++i)
  {
    const double slope = i % 2 == 0 ? 1. : -1., low = drive(0.1 * i);
    const auto at = [&](double t)
    { return low + slope * (t - 1. / rate) + (omega - low + slope / rate) * std::exp(-rate * t); };
    EXPECT_NEAR(samples[static_cast<std::size_t>(i)].omega, at(0.03), 1e-6) << i;
    omega = at(0.1);
  }
}

TEST(YawMotion, EulerConvergesAtFirstOrderAndRefusesZeroSteps)
{
  const MarkedRing ring;
  const YawSample exact = yaw_motion(ring, inertia, 0., { 0.8 }, 1e-11, 10.)[0];
  double previous = 0.;
  for (const unsigned int n_steps : { 800u, 1600u, 3200u })
  {
    const auto samples = yaw_motion_euler(ring, inertia, 0., 0.8 / n_steps, n_steps);
    ASSERT_EQ(samples.size(), n_steps + 1);
    const double error =
      std::hypot(samples.back().omega - exact.omega, samples.back().yaw_angle - exact.yaw_angle);
    if (previous > 0.)
    {
      EXPECT_NEAR(std::log2(previous / error), 1., 0.02);
    }
    previous = error;
  }
  EXPECT_THROW(yaw_motion_euler(ring, inertia, 0., 0., 10), std::invalid_argument);
}

TEST(LongTimeSpin, AgreesWithIntegrationOverTheAngleOfTheMark)
{
  const MarkedRing ring;
  const TerminalSpin spin = long_time_spin(ring, inertia, 0., 25., 1e-9, 10.);
  const auto [mean, ripple] = spin_by_angle(ring, 40, 2000);
  EXPECT_NEAR(spin.omega, mean, 1e-8);
  EXPECT_NEAR(spin.ripple, ripple, 1e-5);
  EXPECT_LT(spin.uncertainty, 1e-8);
  EXPECT_GT(std::abs(spin.omega - ring.drive), 1e-3);
}

TEST(LongTimeSpin, IsAccurateAtNegligibleInertiaWithoutResolvingTheTimeConstant)
{
  // Without inertia, phi = yaw angle - orbit t satisfies phi' = drive - orbit + bump / damping cos phi, and
  // the mean of phi' has a closed form. The time constant of the ring is 8e-6 s, the averaging window 25 s.
  const MarkedRing ring;
  unsigned int n_torques = 0;
  const auto counted = [&](double time, double yaw_angle, double omega)
  {
    ++n_torques;
    return ring(time, yaw_angle, omega);
  };
  const TerminalSpin spin = long_time_spin(counted, 1e-8, 0., 25., 1e-9, 10.);
  const double lag = ring.orbit - ring.drive, swing = ring.bump / ring.damping;
  EXPECT_NEAR(spin.omega, ring.orbit - std::sqrt(lag * lag - swing * swing), 1e-8);
  EXPECT_NEAR(spin.ripple, swing, 1e-5);
  EXPECT_LT(n_torques, 1500000u);
}

TEST(LongTimeSpin, MeanIsAccurateIfInertiaShiftsTheMeanUnderVaryingDamping)
{
  MarkedRing ring;
  ring.roughness = 0.5;
  ring.inertia = 2e-8;
  const TerminalSpin spin = long_time_spin(ring, ring.inertia, 0., 25., 1e-10, 10.);
  const double mean = spin_by_angle(ring, 2, 200000)[0];
  ring.inertia /= 2.;
  EXPECT_GT(std::abs(spin_by_angle(ring, 2, 200000)[0] - mean), 1e-6);
  EXPECT_NEAR(spin.omega, mean, 5e-9);
}

TEST(LongTimeSpin, IsAccurateWithExplicitAndImplicitSteps)
{
  // The averaging windows of 25 s are 2e4 to 6e5 time constants long. The steps are explicit up to 4e4 time
  // constants, and implicit in longer windows.
  MarkedRing ring;
  for (const double stiff_inertia : { 1.5e-6, 6e-7, 5e-8 })
  {
    ring.inertia = stiff_inertia;
    const TerminalSpin spin = long_time_spin(ring, ring.inertia, 0., 25., 1e-9, 10.);
    const auto [mean, ripple] = spin_by_angle(ring, 2, 100000);
    EXPECT_NEAR(spin.omega, mean, 1e-8) << stiff_inertia;
    EXPECT_NEAR(spin.ripple, ripple, 1e-5) << stiff_inertia;
  }
}

TEST(LongTimeSpin, RippleIsMeasuredInTheLastWindow)
{
  // The spin decreases slowly through both averaging windows of 1 s, so the means of the two windows agree
  // within the tolerance, 1e-6 of the spin scale 10 rad/s.
  const double drive = -3.6, start = 1e-5, rate = 0.1;
  const auto torque = [=](double, double, double omega) { return -inertia * rate * (omega - drive); };
  const TerminalSpin spin = long_time_spin(torque, inertia, drive + start, 1., 1e-6, 10.);
  EXPECT_NEAR(spin.ripple, start * (std::exp(-rate) - std::exp(-2. * rate)) / 2., 1e-9);
}

TEST(LongTimeSpin, LocksToTheOrbitIfTheBumpExceedsTheDampingTorque)
{
  MarkedRing ring;
  ring.bump = 1.1 * ring.damping * std::abs(ring.orbit - ring.drive);
  const TerminalSpin spin = long_time_spin(ring, inertia, ring.orbit, 25., 1e-9, 10.);
  EXPECT_NEAR(spin.omega, ring.orbit, 1e-7);
  EXPECT_NEAR(spin.ripple, 0., 1e-7);
}

TEST(LongTimeSpin, RefusesASpinThatDoesNotSettle)
{
  const auto accelerating = [](double, double, double) { return 1e-4; };
  EXPECT_THROW(long_time_spin(accelerating, inertia, 0., 1., 1e-9, 10.), std::runtime_error);
}

TEST(YawMotion, AnObserverIsCalledAtEveryTorqueEvaluationAndCanStopTheMotion)
{
  MarkedRing slow, stiff;
  stiff.inertia = 1e-12;
  for (const MarkedRing &ring : { slow, stiff })
  {
    std::size_t n_torques = 0, n_heard = 0;
    double latest = 0.;
    const PhasedTorqueFunction counted = [&](double time, double angle, double omega)
    {
      ++n_torques;
      return ring(time, angle, omega);
    };
    const auto hear = [&](double time)
    {
      ++n_heard;
      latest = std::max(latest, time);
    };
    yaw_motion(observed(counted, hear), ring.inertia, 0., { 0.5, 1. }, 1e-8, 10.);
    EXPECT_GT(n_heard, 10u);
    EXPECT_EQ(n_heard, n_torques);
    EXPECT_DOUBLE_EQ(latest, 1.);
    n_heard = 0;
    long_time_spin(observed(counted, hear), ring.inertia, 0., 20., 1e-7, 10.);
    EXPECT_GT(n_heard, 2048u);
    EXPECT_GE(latest, 40.); // at least two averaging windows of 20 s
  }
  const auto stop = [](double time)
  {
    if (time > 0.2)
      throw std::domain_error("enough");
  };
  EXPECT_THROW(yaw_motion(observed(slow, stop), slow.inertia, 0., { 1. }, 1e-8, 10.), std::domain_error);
}

TEST(YawMotion, RefusesInvalidArguments)
{
  const MarkedRing ring;
  EXPECT_THROW(yaw_motion(ring, -1., 0., { 1. }, 1e-9, 10.), std::invalid_argument);
  EXPECT_THROW(yaw_motion(ring, inertia, 0., { 1. }, 1e-9, 10., -1e-3), std::invalid_argument);
  EXPECT_THROW(yaw_motion(ring, inertia, 0., { 1. }, 1e-9, 10., 0., { 1., 0.5 }), std::invalid_argument);
  EXPECT_THROW(yaw_motion(ring, inertia, 0., { 1., 0.5 }, 1e-9, 10.), std::invalid_argument);
  EXPECT_THROW(yaw_motion(ring, inertia, 0., { 1. }, 0., 10.), std::invalid_argument);
  EXPECT_THROW(yaw_motion(ring, inertia, NAN, { 1. }, 1e-9, 10.), std::invalid_argument);
  EXPECT_THROW(long_time_spin(ring, inertia, 0., 0., 1e-9, 10.), std::invalid_argument);
  EXPECT_THROW(long_time_spin(ring, inertia, 0., 1., 1e-9, -1.), std::invalid_argument);
}
} // namespace stemware::ring
