#include "ring_model/self_consistent_ring.h"

#include "ring_model/constants.h"
#include "ring_model/first_harmonic_ring.h"
#include "ring_model/friction_kernels.h"
#include "ring_model/friction_law.h"
#include "ring_model/no_balance.h"
#include "ring_model/require.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <utility>

namespace stemware::ring
{
struct SelfConsistentRing::Trial
{
  RingStack load;
  Wrench friction;
  Eigen::Vector2d residual;
};

struct SelfConsistentRing::Search
{
  Trial trial;          ///< the last one
  BalanceStart balance; ///< its moment, and the Jacobian learnt on the way
  unsigned int n_evaluations;
  bool converged;
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
{
  motion.validate();
  require(this->model != nullptr, "the ring has no load model");
}

double SelfConsistentRing::moment_scale() const
{
  return motion.normal_force() * model->radius();
}

double SelfConsistentRing::moment_ratio(const Eigen::Vector2d &moment) const
{
  return moment.norm() / (0.5 * moment_scale());
}

SelfConsistentRing::Trial SelfConsistentRing::attempt(double omega, const Orientation &orientation,
                                                      const Eigen::Vector2d &moment) const
{
  RingStack load = model->rings(motion.normal_force(), moment, { omega / motion.orbit_speed, orientation });
  const Wrench friction = ring::wrench(motion, load, omega);
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

BalanceStart SelfConsistentRing::first_harmonic_start(double omega) const
{
  // The residual G(M) - M of a first harmonic: G_x depends on M_y through T_y, G_y on M_x through T_x.
  const FrictionKernels kernels(omega * model->radius(), motion.orbit_speed, 1);
  const double coupling = motion.friction_at_rest() * friction_arm(closure, motion) / (pi * model->radius());
  BalanceStart start;
  Motion constant = motion;
  constant.friction_coefficient = motion.friction_at_rest();
  constant.friction_law = FrictionLawKind::coulomb;
  start.moment = FirstHarmonicRing(closure, constant, model->radius()).load(omega).moment();
  start.jacobian << -1., coupling * kernels.P(1), -coupling * kernels.U(1), -1.;
  return start;
}

void SelfConsistentRing::refuse(double omega, const Eigen::Vector2d &moment,
                                const Eigen::Vector2d &residual) const
{
  const double ratio = moment_ratio(moment);
  if (ratio <= 0.99 * model->moment_ratio_limit())
    throw NoBalance(sentence("no equilibrium at omega = ", omega,
                             " rad/s: the iteration stopped at m = ", ratio, " with moments that differ by ",
                             residual.norm() / moment_scale(), " N R"));
  throw Tipping(sentence("at omega = ", omega, " rad/s the closure ", to_string(closure),
                         " demands the moment ratio ", moment_ratio(moment + residual),
                         " where the ring carries ", ratio,
                         ": the glass tips; lower the hand's force, the friction or the speed"));
}

SelfConsistentRing::Search SelfConsistentRing::search(double omega, const Orientation &orientation,
                                                      const BalanceStart &start) const
{
  const double tolerance = std::max(4e-15, model->accuracy()) * moment_scale();
  const double allowed = std::max(1e-12, 10. * model->accuracy()) * moment_scale();
  // Shorter steps say more about rounding than about the slope.
  const double shortest_informative = 1e3 * tolerance;
  BalanceStart point = { within_limits(Eigen::Vector2d::Zero(), start.moment), start.jacobian };
  Trial trial = attempt(omega, orientation, point.moment);
  unsigned int n_evaluations = 1;
  bool ended = trial.residual.norm() <= tolerance || !model->follows_moment();
  while (!ended && n_evaluations < 60)
  {
    const Eigen::Vector2d next =
      within_limits(point.moment, point.moment - point.jacobian.inverse() * trial.residual);
    const Eigen::Vector2d step = next - point.moment;
    Trial attempted = attempt(omega, orientation, next);
    ++n_evaluations;
    const double residual = attempted.residual.norm();
    const bool stagnates =
      residual <= allowed && residual > 0.5 * trial.residual.norm(); // at the model's noise
    ended = residual <= tolerance || step.norm() <= tolerance || stagnates;
    if (step.norm() > shortest_informative)
      point.jacobian +=
        (attempted.residual - trial.residual - point.jacobian * step) * step.transpose() / step.squaredNorm();
    point.moment = next;
    trial = std::move(attempted);
  }
  // A step too short to matter also ends the loop at the limit of what the model can carry.
  const bool converged = ended && (trial.residual.norm() <= allowed || !model->follows_moment());
  return { std::move(trial), point, n_evaluations, converged };
}

RingEquilibrium SelfConsistentRing::at(double omega, const BalanceStart *start,
                                       const Orientation &orientation) const
{
  Search found = search(omega, orientation, start ? *start : first_harmonic_start(omega));
  if (start && !found.converged)
    found = search(omega, orientation, first_harmonic_start(omega));
  Trial &trial = found.trial;
  if (!found.converged)
    refuse(omega, found.balance.moment, trial.residual);

  const double ratio = moment_ratio(trial.load.moment());
  const ContactState contact = ratio >= 2.                       ? ContactState::tipping
                               : ratio > model->lift_off_ratio() ? ContactState::lift_off
                                                                 : ContactState::full_contact;
  const Eigen::Vector2d friction(trial.friction.force_x, trial.friction.force_y);
  return { std::move(trial.load),
           trial.friction,
           ring::hand_force(motion, friction),
           ratio,
           trial.residual.norm() / moment_scale(),
           contact,
           found.n_evaluations,
           found.balance };
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
