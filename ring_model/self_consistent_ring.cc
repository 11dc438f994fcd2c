#include "ring_model/self_consistent_ring.h"

#include "ring_model/first_harmonic_ring.h"
#include "ring_model/friction_kernels.h"
#include "ring_model/require.h"

#include <Eigen/LU>
#include <boost/math/constants/constants.hpp>

#include <cmath>
#include <utility>

namespace stemware::ring
{
struct SelfConsistentRing::Trial
{
  AngularLoad load;
  Wrench friction;
  Eigen::Vector2d residual;
};

std::string to_string(ContactState state)
{
  switch (state)
  {
  case ContactState::full_contact:
    return "full contact";
  case ContactState::lift_off:
    return "lift-off";
  case ContactState::tipping:
    return "tipping";
  }
  throw std::invalid_argument("the contact state is none of full contact, lift-off, tipping");
}

SelfConsistentRing::SelfConsistentRing(Closure closure, const Motion &motion,
                                       std::shared_ptr<const LoadModel> model)
    : closure(closure)
    , motion(motion)
    , model(std::move(model))
    , ring(motion.friction_coefficient)
{
  motion.validate();
  require(this->model != nullptr, "the ring has no load model");
}

double SelfConsistentRing::moment_ratio(const Eigen::Vector2d &moment) const
{
  return moment.norm() / (0.5 * motion.normal_force() * model->radius());
}

SelfConsistentRing::Trial SelfConsistentRing::attempt(double omega, const Eigen::Vector2d &moment) const
{
  AngularLoad load = model->load(motion.normal_force(), moment);
  const Wrench friction = ring.wrench(load, omega, motion.orbit_speed);
  const Eigen::Vector2d required = required_moment(closure, motion, { friction.force_x, friction.force_y });
  const Eigen::Vector2d carried = model->follows_moment() ? moment : load.moment();
  return { std::move(load), friction, required - carried };
}

Eigen::Vector2d SelfConsistentRing::within_limits(const Eigen::Vector2d &from,
                                                  const Eigen::Vector2d &moment) const
{
  // A step that leads outside goes nine tenths of the way to the limit.
  const double limit = model->moment_ratio_limit();
  if (moment_ratio(moment) < limit)
    return moment;
  double inside = 0., outside = 1.;
  for (unsigned int halving = 0; halving < 50; ++halving)
  {
    const double middle = 0.5 * (inside + outside);
    (moment_ratio(from + middle * (moment - from)) < limit ? inside : outside) = middle;
  }
  return from + 0.9 * inside * (moment - from);
}

Eigen::Matrix2d SelfConsistentRing::first_harmonic_jacobian(double omega) const
{
  // The residual G(M) - M of a first harmonic: G_x depends on M_y through T_y, G_y on M_x through T_x.
  const FrictionKernels kernels(omega * model->radius(), motion.orbit_speed, 1);
  const double coupling = motion.friction_coefficient * friction_arm(closure, motion) /
                          (boost::math::constants::pi<double>() * model->radius());
  Eigen::Matrix2d jacobian;
  jacobian << -1., coupling * kernels.P(1), -coupling * kernels.U(1), -1.;
  return jacobian;
}

void SelfConsistentRing::refuse(double omega, const Eigen::Vector2d &moment,
                                const Eigen::Vector2d &residual) const
{
  const double ratio = moment_ratio(moment), limit = model->moment_ratio_limit();
  if (ratio <= 0.99 * limit)
    throw std::runtime_error(sentence(
      "no equilibrium at omega = ", omega, " rad/s: the iteration stopped at m = ", ratio,
      " with moments that differ by ", residual.norm() / (motion.normal_force() * model->radius()), " N R"));
  const std::string demand =
    sentence("at omega = ", omega, " rad/s the closure ", to_string(closure), " demands the moment ratio ",
             moment_ratio(moment + residual), " where the ring carries ", ratio);
  if (limit < 2.)
    throw std::out_of_range(demand + ", the end of the response curve: add contact solutions beyond it");
  throw Tipping(demand + ": the glass tips; lower the hand's force, the friction or the speed");
}

RingEquilibrium SelfConsistentRing::at(double omega) const
{
  const double scale = motion.normal_force() * model->radius(), tolerance = 4e-15 * scale;
  Eigen::Vector2d moment = within_limits(
    Eigen::Vector2d::Zero(), FirstHarmonicRing(closure, motion, model->radius()).load(omega).moment());
  Trial trial = attempt(omega, moment);
  unsigned int n_evaluations = 1;
  bool converged = trial.residual.norm() <= tolerance || !model->follows_moment();
  Eigen::Matrix2d jacobian = converged ? Eigen::Matrix2d() : first_harmonic_jacobian(omega);
  while (!converged && n_evaluations < 60)
  {
    const Eigen::Vector2d next = within_limits(moment, moment - jacobian.inverse() * trial.residual);
    const Eigen::Vector2d step = next - moment;
    Trial attempted = attempt(omega, next);
    ++n_evaluations;
    converged = attempted.residual.norm() <= tolerance || step.norm() <= tolerance;
    if (step.squaredNorm() > 0.)
      jacobian +=
        (attempted.residual - trial.residual - jacobian * step) * step.transpose() / step.squaredNorm();
    moment = next;
    trial = std::move(attempted);
  }
  const double residual = trial.residual.norm() / scale;
  // A step too short to matter also ends the loop at the limit of what the model can carry.
  if (model->follows_moment() && (!converged || residual > 1e-12))
    refuse(omega, moment, trial.residual);

  const double ratio = moment_ratio(trial.load.moment());
  const ContactState contact = ratio >= 2.                       ? ContactState::tipping
                               : ratio > model->lift_off_ratio() ? ContactState::lift_off
                                                                 : ContactState::full_contact;
  const Eigen::Vector2d friction(trial.friction.force_x, trial.friction.force_y);
  return {
    std::move(trial.load), trial.friction, ring::hand_force(motion, friction), ratio, residual, contact,
    n_evaluations
  };
}

TerminalSpin SelfConsistentRing::terminal_spin() const
{
  return ring::terminal_spin([this](double omega) { return torque(omega); }, motion.yaw_inertia,
                             motion.orbit_speed / model->radius());
}

std::vector<TerminalSpin> SelfConsistentRing::terminal_spins(double lower, double upper,
                                                             unsigned int n_intervals) const
{
  return all_terminal_spins([this](double omega) { return torque(omega); }, motion.yaw_inertia, lower, upper,
                            n_intervals);
}
} // namespace stemware::ring
