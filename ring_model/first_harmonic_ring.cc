#include "ring_model/first_harmonic_ring.h"

#include "ring_model/friction_kernels.h"
#include "ring_model/load/constants.h"
#include "ring_model/load/require.h"

namespace stemware::ring
{
FirstHarmonicRing::FirstHarmonicRing(Closure closure, const Motion &motion, double radius)
    : motion(motion)
    , radius(radius)
    , coupling(0.)
    , a1_b1(Eigen::Vector2d::Zero())
{
  motion.validate();
  require(motion.has_constant_friction(), "the closed form of the first harmonic needs one coefficient of "
                                          "friction; use SelfConsistentRing for Stribeck's law");
  require_positive(radius, "the ring radius", "m");
  coupling = motion.friction_coefficient * friction_arm(closure, motion) / (pi * radius);
  const Eigen::Vector2d moment = required_moment(closure, motion, Eigen::Vector2d::Zero());
  a1_b1 = Eigen::Vector2d(-moment.y(), moment.x()) / (pi * radius);
}

RingStack FirstHarmonicRing::load(double omega) const
{
  const FrictionKernels kernels(omega * radius, motion.orbit_speed, 1);
  const double a0 = motion.normal_force() / (2. * pi), u1 = kernels.U(1), p1 = kernels.P(1);
  // pi R a_1 = (without friction) - h T_x, pi R b_1 = (without friction) - h T_y,
  // T_x = -mu (a_0 U_0 + b_1 U_1), T_y = mu a_1 P_1.
  const double a1 =
    (a1_b1.x() + coupling * (a0 * kernels.U(0) + a1_b1.y() * u1)) / (1. + coupling * coupling * u1 * p1);
  const double b1 = a1_b1.y() - coupling * a1 * p1;
  return { { a0, a1 }, { 0., b1 }, radius };
}

Wrench FirstHarmonicRing::wrench(double omega) const
{
  return coulomb_wrench(motion.friction_coefficient, load(omega), omega, motion.orbit_speed);
}

TerminalSpin FirstHarmonicRing::terminal_spin() const
{
  return ring::terminal_spin([this](double omega) { return torque(omega); }, motion.yaw_inertia,
                             motion.orbit_speed / radius);
}
} // namespace stemware::ring
