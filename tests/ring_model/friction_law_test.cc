#include "ring_model/friction_functionals.h"
#include "ring_model/terminal_spin.h"
#include "tests/ring_model/adaptive_friction.h"
#include "tests/ring_model/reference.h"
#include "tests/taylor_remainder.h"

#include <boost/math/constants/constants.hpp>

#include <limits>
#include <stdexcept>

namespace stemware::ring
{
namespace
{
using test::adaptive_wrench;
using test::EstimatedWrench;
using test::expect_relative;

RingStack some_load()
{
  return { { 0.5, 0.12, -0.07, 0.03, 0.02 }, { 0., -0.15, 0.05, -0.04, 0.01 }, 0.03 };
}

/// Constant, but not known to be: takes the quadrature.
class DisguisedCoulombLaw : public FrictionLaw
{
public:
  double coefficient(double /*slip_speed*/) const override { return 0.3; }
};

TEST(FrictionLaw, QuadratureAgreesWithTheKernelsAtEverySlipRatio)
{
  const RingStack load = some_load();
  for (const double eps :
       { 0., 1e-6, -0.27, 0.5, 0.9, 0.999, 1. - 1e-9, 1., 1. + 1e-12, -1.001, 1.3, 5., 1e4 })
  {
    const double speed = 0.35, omega = eps * speed / load.radius();
    const Wrench exact = coulomb_wrench(0.3, load, omega, speed);
    const EstimatedWrench found = adaptive_wrench(DisguisedCoulombLaw(), load, omega, speed);
    const auto expect_within_estimate = [&](double value, double expected, double error, double scale)
    {
      EXPECT_NEAR(value, expected, 1e-12 * scale) << eps;
      EXPECT_LE(std::abs(value - expected), error + 4e-15 * scale) << eps;
      EXPECT_LE(error, 1e-11 * scale) << eps;
    };
    expect_within_estimate(found.value.torque, exact.torque, found.error.torque, 0.03);
    expect_within_estimate(found.value.force_x, exact.force_x, found.error.force_x, 1.);
    expect_within_estimate(found.value.force_y, exact.force_y, found.error.force_y, 1.);
  }
}

TEST(FrictionLaw, FunctionalsOfADisguisedConstantAreThoseOfTheKernels)
{
  const std::vector<double> radii = { 0.027, 0.03, 0.033 };
  const unsigned int n_max = 40;
  for (const double eps : { 0., 1e-6, -0.27, 0.5, 0.8, -0.95, 1. - 1e-9, 1., 1.3, -5., 1e3 })
  {
    const double speed = 0.35, omega = eps * speed / 0.03;
    const FrictionFunctionals exact = friction_functionals(CoulombLaw(0.3), radii, n_max, omega, speed);
    const FrictionFunctionals found = friction_functionals(DisguisedCoulombLaw(), radii, n_max, omega, speed);
    const auto expect_equal = [&](const LoadFunctional &one, const LoadFunctional &other, double scale)
    {
      EXPECT_LE((one.a - other.a).abs().maxCoeff(), 2e-12 * scale) << "eps " << eps;
      EXPECT_LE((one.b - other.b).abs().maxCoeff(), 2e-12 * scale) << "eps " << eps;
    };
    expect_equal(found.torque, exact.torque, 0.03);
    expect_equal(found.drag, exact.drag, 1.);
    expect_equal(found.side, exact.side, 1.);
  }
}

TEST(FrictionLaw, FunctionalsOfAStackAgreeWithTheAdaptiveQuadratureRingByRing)
{
  // Each ring by itself through the other quadrature; T, tau of the stack are their sums.
  Motion motion;
  motion.friction_law = FrictionLawKind::stribeck;
  motion.friction_coefficient = 0.2;
  motion.static_coefficient = 0.5;
  motion.viscous_friction = 0.1;
  const RingStack inner({ 0.2, 0.05, -0.03, 0.01 }, { 0., -0.06, 0.02, 0.01 }, 0.028), outer = some_load();
  std::vector<RingStack::Ring> rings = { inner.rings().front(), outer.rings().front() };
  rings[0].a.push_back(0.);
  rings[0].b.push_back(0.);
  for (const double decay : { 0.02, 0.1, 1. })
    for (const double omega : { 0., 2., -5., 11., 12.5, -13., 60. })
    {
      motion.friction_decay_speed = decay;
      const StribeckLaw law({ 0.5, 0.2, decay, 0.1, 2. });
      const Wrench one = adaptive_wrench(law, inner, omega, motion.orbit_speed).value,
                   other = adaptive_wrench(law, outer, omega, motion.orbit_speed).value;
      const Wrench both = wrench(motion, RingStack(rings), omega);
      EXPECT_NEAR(both.torque, one.torque + other.torque, 1e-12 * 0.05) << decay << " " << omega;
      EXPECT_NEAR(both.force_x, one.force_x + other.force_x, 1e-11) << decay << " " << omega;
      EXPECT_NEAR(both.force_y, one.force_y + other.force_y, 1e-11) << decay << " " << omega;
    }
}

TEST(FrictionLaw, TheTruncationBoundHoldsUnderStribecksLaw)
{
  Motion motion;
  motion.friction_law = FrictionLawKind::stribeck;
  const RingStack load = some_load();
  for (const double omega : { -3., 4., 11. })
    for (const unsigned int n : { 1u, 2u, 3u })
    {
      const double change =
        wrench(motion, load, omega).torque - wrench(motion, load.truncated(n), omega).torque;
      EXPECT_LE(std::abs(change), truncation_bound(motion, load, n, omega) * (1. + 1e-12));
      EXPECT_GT(truncation_bound(motion, load, n, omega), 0.);
    }
}

TEST(FrictionLaw, ConstantLawsUseTheKernels)
{
  const RingStack load = some_load();
  const Wrench exact = coulomb_wrench(0.3, load, 7., 0.35);
  const Wrench found = friction_functionals(StribeckLaw({ 0.3, 0.3, 0.1, 0., 2. }), load.radii(),
                                            load.n_harmonics(), 7., 0.35)(load);
  EXPECT_EQ(found.torque, exact.torque);
}

TEST(FrictionLaw, ViscousPartIsLinear)
{
  // mu = c |v_rel|: force = -c int lambda v_rel, a polynomial in the coefficients of the load.
  const RingStack load = some_load();
  const double c = 0.4, omega = 9., speed = 0.35, R = load.radius(),
               pi = boost::math::constants::pi<double>();
  const Wrench found = friction_functionals(StribeckLaw({ 0., 0., 0.1, c, 2. }), load.radii(),
                                            load.n_harmonics(), omega, speed)(load);
  expect_relative(found.force_x, -c * pi * (2. * load.a(0) * speed - omega * R * load.b(1)), 1e-12, "T_x");
  expect_relative(found.force_y, -c * pi * omega * R * load.a(1), 1e-12, "T_y");
  expect_relative(found.torque, c * R * pi * (speed * load.b(1) - 2. * load.a(0) * omega * R), 1e-12, "tau");
}

TEST(FrictionLaw, StribeckCurveHasItsLimits)
{
  const StribeckLaw law({ 0.5, 0.3, 0.05, 0.1, 1. });
  EXPECT_DOUBLE_EQ(law.coefficient(0.), 0.5);
  EXPECT_NEAR(law.coefficient(0.05), 0.3 + 0.2 * std::exp(-1.) + 0.005, 1e-15);
  EXPECT_NEAR(law.coefficient(10.), 1.3, 1e-12);
  EXPECT_FALSE(law.is_constant());
}

TEST(FrictionLaw, StribeckAgreesWithATrapezoidalSum)
{
  const RingStack load = some_load();
  const double speed = 0.35, R = load.radius(), pi = boost::math::constants::pi<double>();
  const StribeckLaw law({ 0.5, 0.3, 0.1, 0.05, 2. });
  for (const double omega : { -20., -3., 0.5, 6., 60. })
  {
    const unsigned int n_points = 4000;
    Wrench sum{ 0., 0., 0. };
    for (unsigned int i = 0; i < n_points; ++i)
    {
      const double theta = 2. * pi * (i + 0.5) / n_points;
      const double x = speed - omega * R * std::sin(theta), y = omega * R * std::cos(theta);
      const double force =
        law.coefficient(std::hypot(x, y)) * load(theta) / std::hypot(x, y) * 2. * pi / n_points;
      sum.force_x -= force * x;
      sum.force_y -= force * y;
      sum.torque -= force * R * (std::cos(theta) * y - std::sin(theta) * x);
    }
    const Wrench found = friction_functionals(law, load.radii(), load.n_harmonics(), omega, speed)(load);
    EXPECT_NEAR(found.torque, sum.torque, 1e-14) << omega;
    EXPECT_NEAR(found.force_x, sum.force_x, 5e-13) << omega;
    EXPECT_NEAR(found.force_y, sum.force_y, 5e-13) << omega;
  }
}

/// int_0^s mu ds' of a law whose exponent is 1 or 2, in closed form [m/s].
double potential_of(const StribeckLaw::Parameters &law, double slip_speed)
{
  const double x = slip_speed / law.decay_speed, pi = boost::math::constants::pi<double>();
  const double decayed = law.decay_exponent == 1. ? 1. - std::exp(-x) : std::sqrt(pi) / 2. * std::erf(x);
  return law.kinetic_coefficient * slip_speed +
         (law.static_coefficient - law.kinetic_coefficient) * law.decay_speed * decayed +
         law.viscous * slip_speed * slip_speed / 2.;
}

// Reference: closed form of the dissipation potential at a point, summed over the ring by the trapezoidal
// rule. Friction is minus its gradient by the velocity of the ring, under every law.
TEST(FrictionLaw, FrictionIsMinusTheDerivativeOfAPotential)
{
  const RingStack load = some_load();
  const double R = load.radius(), pi = boost::math::constants::pi<double>();
  const StribeckLaw::Parameters laws[] = {
    { 0.3, 0.3, 0.1, 0., 2. }, { 0.5, 0.3, 0.1, 0., 2. }, { 0.5, 0.2, 0.3, 0.4, 1. }, { 0., 0., 0.1, 0.4, 2. }
  };
  test::Numbers numbers(48);
  for (const StribeckLaw::Parameters &law : laws)
    for (const double eps : { 0., 0.3, -0.8, 1.6, -4. })
    {
      const double speed = 0.35, omega = eps * speed / R;
      const Wrench friction =
        friction_functionals(StribeckLaw(law), load.radii(), load.n_harmonics(), omega, speed)(load);
      // Steps in the two components of the velocity and in the rim speed.
      const double along = numbers.between(-1., 1.), across = numbers.between(-1., 1.),
                   turning = numbers.between(-1., 1.) / R;
      const auto potential = [&](double h)
      {
        const unsigned int n_points = 2000;
        double sum = 0.;
        for (unsigned int i = 0; i < n_points; ++i)
        {
          const double theta = 2. * pi * i / n_points, spin = omega + h * turning;
          sum += load(theta) * 2. * pi / n_points *
                 potential_of(law, std::hypot(speed + h * along - spin * R * std::sin(theta),
                                              h * across + spin * R * std::cos(theta)));
        }
        return sum;
      };
      const double derivative =
        -(friction.force_x * along + friction.force_y * across + friction.torque * turning);
      EXPECT_TRUE(taylor::is_derivative(potential, derivative, 0.02, 1e-14))
        << law.static_coefficient << ", exponent " << law.decay_exponent << ", eps " << eps;
    }
}

TEST(FrictionLaw, StribeckShiftsTheTerminalSpin)
{
  // A coefficient that falls with the slip speed works most where the slip is slow, on the driving side: the
  // ring spins faster than the paper's 3.12 rad/s; one that grows makes it slower.
  const RingStack load = RingStack::first_harmonic(2.943, { 0.01225, 0. }, 0.03);
  const auto terminal = [&](const FrictionLaw &law)
  {
    return terminal_spin([&](double omega)
                         { return friction_functionals(law, load.radii(), 1, omega, 0.35).torque(load); },
                         3e-4, { 0.35 / 0.03 })
      .omega;
  };
  const double coulomb = terminal(StribeckLaw({ 0.3, 0.3, 0.3 }));
  expect_relative(coulomb, 3.12055870152586, 1e-12, "constant coefficient");
  EXPECT_GT(terminal(StribeckLaw({ 0.5, 0.2, 0.3, 0., 2. })), 1.1 * coulomb);
  EXPECT_LT(terminal(StribeckLaw({ 0.3, 0.3, 0.3, 0.5, 2. })), 0.95 * coulomb);
}

TEST(FrictionLaw, RefusesBadInput)
{
  EXPECT_THROW(StribeckLaw({ -0.5, 0.3, 0.1, 0., 2. }), std::invalid_argument);
  EXPECT_THROW(StribeckLaw({ 0.5, 0.3, 0., 0., 2. }), std::invalid_argument);
  EXPECT_THROW(StribeckLaw({ 0.5, 0.3, 0.1, 0., 0. }), std::invalid_argument);
  const StribeckLaw law({ 0.5, 0.3, 0.1, 0., 2. });
  const auto ask = [&](double omega, double speed) { friction_functionals(law, { 0.03 }, 4, omega, speed); };
  EXPECT_THROW(ask(0., 0.), std::invalid_argument);
  EXPECT_THROW(ask(1., -1.), std::invalid_argument);
  EXPECT_THROW(ask(std::numeric_limits<double>::quiet_NaN(), 1.), std::invalid_argument);
}
} // namespace
} // namespace stemware::ring
