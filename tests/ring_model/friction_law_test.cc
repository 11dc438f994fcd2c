#include "ring_model/friction_functionals.h"
#include "ring_model/load/constants.h"
#include "tests/ring_model/quadrature.h"
#include "tests/ring_model/reference.h"
#include "tests/taylor_remainder.h"
#include "tests/ulps.h"

#include <limits>
#include <stdexcept>

namespace stemware::ring
{
namespace
{

RingStack some_load()
{
  return { { 0.5, 0.12, -0.07, 0.03, 0.02 }, { 0., -0.15, 0.05, -0.04, 0.01 }, 0.03 };
}

/// Constant law of a user-defined class, so that FrictionLaw uses quadrature and not the kernels.
class DisguisedCoulombLaw : public FrictionLaw
{
public:
  double coefficient(double /*slip_speed*/) const override { return 0.3; }
};

TEST(FrictionLaw, QuadratureOfAConstantLawAgreesWithTheKernels)
{
  const std::vector<double> radii = { 0.027, 0.03, 0.033 };
  const unsigned int n_max = 40;
  for (const double eps : { 0., 1e-6, -0.27, 0.5, 0.8, -0.95, 1. - 1e-9, 1., 1.3, -5., 1e3 })
  {
    const double speed = 0.35, omega = eps * speed / 0.03;
    const FrictionFunctionals exact = friction_functionals(coulomb_law(0.3), radii, n_max, omega, speed);
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

TEST(FrictionLaw, TruncationErrorStaysBelowTheBoundUnderStribecksLaw)
{
  Motion motion;
  motion.friction_law = FrictionLawKind::stribeck;
  const RingStack load = some_load();
  for (const double omega : { -3., 4., 11. })
    for (const unsigned int n : { 1u, 2u, 3u })
    {
      const double change =
        wrench(motion, load, omega).torque - wrench(motion, load.truncated(n), omega).torque;
      EXPECT_LE(std::abs(change), TorqueByHarmonics(motion, load, omega).bound(n) * (1. + 1e-12));
      EXPECT_GT(TorqueByHarmonics(motion, load, omega).bound(n), 0.);
    }
}

TEST(FrictionLaw, ConstantStribeckLawGivesExactlyTheCoulombTorque)
{
  const RingStack load = some_load();
  const Wrench exact = coulomb_wrench(0.3, load, 7., 0.35);
  const Wrench found = friction_functionals(StribeckLaw(0.3, 0.3, 0.1, 0., 2.), load.radii(),
                                            load.n_harmonics(), 7., 0.35)(load);
  EXPECT_EQ(found.torque, exact.torque);
}

TEST(FrictionLaw, ViscousFrictionAgreesWithItsClosedForm)
{
  // Closed form: for mu = c |v_rel|, the friction -c int lambda v_rel dtheta depends only on the harmonics 0
  // and 1 of the load.
  const RingStack load = some_load();
  const double c = 0.4, omega = 9., speed = 0.35, R = load.radius();
  const Wrench found = friction_functionals(StribeckLaw(0., 0., 0.1, c, 2.), load.radii(), load.n_harmonics(),
                                            omega, speed)(load);
  expect_relative(found.force_x, -c * pi * (2. * load.a(0) * speed - omega * R * load.b(1)), 1e-12, "T_x");
  expect_relative(found.force_y, -c * pi * omega * R * load.a(1), 1e-12, "T_y");
  expect_relative(found.torque, c * R * pi * (speed * load.b(1) - 2. * load.a(0) * omega * R), 1e-12, "tau");
}

TEST(FrictionLaw, StribeckCoefficientAgreesWithItsFormula)
{
  const StribeckLaw law(0.5, 0.3, 0.05, 0.1, 1.);
  EXPECT_DOUBLE_EQ(law.coefficient(0.), 0.5);
  EXPECT_NEAR(law.coefficient(0.05), 0.3 + 0.2 * std::exp(-1.) + 0.005, ulps(12, 0.38));
  EXPECT_NEAR(law.coefficient(10.), 1.3, 1e-12);
  EXPECT_FALSE(law.is_constant());
}

// Cases: narrow and wide decay, slip ratios on both sides of 1, and two rings.
TEST(FrictionLaw, StribeckFrictionAgreesWithATrapezoidalSum)
{
  const RingStack load({ { 0.028, { 0.2, 0.05, -0.03, 0.01, 0. }, { 0., -0.06, 0.02, 0.01, 0. } },
                         some_load().rings().front() });
  const double speed = 0.35;
  for (const double decay : { 0.02, 0.1, 1. })
  {
    const StribeckLaw law(0.5, 0.3, decay, 0.05, 2.);
    for (const double omega : { -20., -13., -3., 0., 0.5, 6., 11., 12.2, 60. })
    {
      const Wrench sum = test::wrench_by_quadrature([&](double slip) { return law.coefficient(slip); }, load,
                                                    omega, speed, 4000),
                   found = friction_functionals(law, load.radii(), load.n_harmonics(), omega, speed)(load);
      EXPECT_NEAR(found.torque, sum.torque, 2e-14) << decay << ", " << omega;
      EXPECT_NEAR(found.force_x, sum.force_x, 1e-12) << decay << ", " << omega;
      EXPECT_NEAR(found.force_y, sum.force_y, 1e-12) << decay << ", " << omega;
    }
  }
}

/// Arguments of StribeckLaw.
struct Coefficients
{
  double static_coefficient, kinetic_coefficient, decay_speed, viscous, decay_exponent;
};

/// Returns int_0^s mu ds' [m/s] in closed form for s = @p slip_speed and the exponent 1 or 2 of @p law.
double potential_of(const Coefficients &law, double slip_speed)
{
  const double x = slip_speed / law.decay_speed;
  const double decayed = law.decay_exponent == 1. ? 1. - std::exp(-x) : std::sqrt(pi) / 2. * std::erf(x);
  return law.kinetic_coefficient * slip_speed +
         (law.static_coefficient - law.kinetic_coefficient) * law.decay_speed * decayed +
         law.viscous * slip_speed * slip_speed / 2.;
}

// Friction is the negative gradient of the dissipation potential with respect to the velocity of the ring.
// Reference: closed form of the potential at a point, summed over the ring by the trapezoidal rule.
TEST(FrictionLaw, FrictionIsMinusTheDerivativeOfAPotential)
{
  const RingStack load = some_load();
  const double R = load.radius();
  const Coefficients laws[] = {
    { 0.3, 0.3, 0.1, 0., 2. }, { 0.5, 0.3, 0.1, 0., 2. }, { 0.5, 0.2, 0.3, 0.4, 1. }, { 0., 0., 0.1, 0.4, 2. }
  };
  test::Numbers numbers(48);
  for (const Coefficients &law : laws)
    for (const double eps : { 0., 0.3, -0.8, 1.6, -4. })
    {
      const double speed = 0.35, omega = eps * speed / R;
      const StribeckLaw stribeck(law.static_coefficient, law.kinetic_coefficient, law.decay_speed,
                                 law.viscous, law.decay_exponent);
      const Wrench friction =
        friction_functionals(stribeck, load.radii(), load.n_harmonics(), omega, speed)(load);
      // The vector (along, across, turning) is a random direction of (v_x, v_y, omega).
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

TEST(FrictionLaw, RefusesInvalidParametersAndVelocities)
{
  EXPECT_THROW(StribeckLaw(-0.5, 0.3, 0.1, 0., 2.), std::invalid_argument);
  EXPECT_THROW(StribeckLaw(0.5, 0.3, 0., 0., 2.), std::invalid_argument);
  EXPECT_THROW(StribeckLaw(0.5, 0.3, 0.1, 0., 0.), std::invalid_argument);
  const StribeckLaw law(0.5, 0.3, 0.1, 0., 2.);
  const auto ask = [&](double omega, double speed) { friction_functionals(law, { 0.03 }, 4, omega, speed); };
  EXPECT_THROW(ask(0., 0.), std::invalid_argument);
  EXPECT_THROW(ask(1., -1.), std::invalid_argument);
  EXPECT_THROW(ask(std::numeric_limits<double>::quiet_NaN(), 1.), std::invalid_argument);
}
} // namespace
} // namespace stemware::ring
