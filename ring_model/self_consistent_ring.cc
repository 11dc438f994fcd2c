#include "ring_model/self_consistent_ring.h"

#include "ring_model/friction_functionals.h"
#include "ring_model/friction_kernels.h"
#include "ring_model/load/constants.h"
#include "ring_model/load/require.h"
#include "ring_model/no_balance.h"

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

SelfConsistentRing::SelfConsistentRing(Closure closure, const Motion &motion,
                                       std::shared_ptr<const LoadModel> model, unsigned int n_max)
    : closure(closure)
    , motion(motion)
    , model(std::move(model))
    , n_max(n_max)
{
  motion.validate();
  require(this->model != nullptr, "the ring has no load model");
  require(n_max >= 1, "a load truncated after ", n_max, " harmonics has no moment; keep at least the first");
}

SelfConsistentRing::SelfConsistentRing(Closure closure, const Motion &motion, double radius)
    : SelfConsistentRing(closure, motion, std::make_shared<FirstHarmonicModel>(radius))
{
}

double SelfConsistentRing::moment_scale() const
{
  return motion.normal_force() * model->radius();
}

double SelfConsistentRing::moment_ratio(const Eigen::Vector2d &moment) const
{
  return moment.norm() / (0.5 * moment_scale());
}

SelfConsistentRing::Trial SelfConsistentRing::attempt(double omega, const Eigen::Vector2d &moment) const
{
  RingStack load = model->rings(motion.normal_force(), moment);
  return residual_of(load.n_harmonics() > n_max ? load.truncated(n_max) : std::move(load), omega, moment);
}

SelfConsistentRing::Trial SelfConsistentRing::residual_of(RingStack load, double omega,
                                                          const Eigen::Vector2d &moment) const
{
  const Wrench friction = ring::wrench(motion, load, omega);
  const Eigen::Vector2d required = required_moment(closure, motion, { friction.force_x, friction.force_y });
  return { std::move(load), friction, required - moment };
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

Eigen::Matrix2d SelfConsistentRing::jacobian_of_first_harmonic(double omega) const
{
  // The residual G(M) - M of a first harmonic: G_x depends on M_y through T_y, G_y on M_x through T_x.
  const FrictionKernels kernels(omega * model->radius(), motion.orbit_speed, 1);
  const double coupling = motion.friction_at_rest() * friction_arm(closure, motion) / (pi * model->radius());
  Eigen::Matrix2d jacobian;
  jacobian << -1., coupling * kernels.P(1), -coupling * kernels.U(1), -1.;
  return jacobian;
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

RingEquilibrium SelfConsistentRing::at(double omega) const
{
  const double tolerance = 4e-15 * moment_scale();
  const double allowed = 1e-12 * moment_scale();
  // Shorter steps say more about rounding than about the slope.
  const double shortest_informative = 1e3 * tolerance;
  Eigen::Matrix2d jacobian = jacobian_of_first_harmonic(omega);
  // The first harmonic in balance, from that of rest: its balance is linear for one coefficient of friction.
  const Eigen::Vector2d at_rest = required_moment_at_rest(closure, motion);
  const Eigen::Vector2d change =
    residual_of(RingStack::first_harmonic(motion.normal_force(), at_rest, model->radius()), omega, at_rest)
      .residual;
  Eigen::Vector2d moment = within_limits(Eigen::Vector2d::Zero(), at_rest - jacobian.inverse() * change);
  Trial trial = attempt(omega, moment);
  unsigned int n_evaluations = 1;
  bool ended = trial.residual.norm() <= tolerance;
  while (!ended && n_evaluations < 60)
  {
    const Eigen::Vector2d next = within_limits(moment, moment - jacobian.inverse() * trial.residual);
    const Eigen::Vector2d step = next - moment;
    Trial attempted = attempt(omega, next);
    ++n_evaluations;
    const double residual = attempted.residual.norm();
    const bool stagnates =
      residual <= allowed && residual > 0.5 * trial.residual.norm(); // at the model's noise
    ended = residual <= tolerance || step.norm() <= tolerance || stagnates;
    if (step.norm() > shortest_informative)
      jacobian +=
        (attempted.residual - trial.residual - jacobian * step) * step.transpose() / step.squaredNorm();
    moment = next;
    trial = std::move(attempted);
  }
  // A step too short to matter also ends the loop at the limit of what the model can carry.
  if (!ended || trial.residual.norm() > allowed)
    refuse(omega, moment, trial.residual);

  const double ratio = moment_ratio(trial.load.moment());
  return { std::move(trial.load), trial.friction, ratio, trial.residual.norm() / moment_scale(),
           n_evaluations };
}
} // namespace stemware::ring
