#include "ring_model/free_sliding.h"

#include "ring_model/bracketed_zero.h"
#include "ring_model/friction_kernels.h"
#include "ring_model/load/constants.h"
#include "ring_model/load/require.h"
#include "ring_model/no_balance.h"

#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>

#include <array>
#include <cmath>
#include <limits>

namespace stemware::ring
{
namespace
{
/// Integrated over sigma: angle between sliding and spinning, heading, yaw, x, y, time, friction's work,
/// length of the path.
using State = std::array<double, 8>;

/// The body's motion at the scale S = sqrt(v^2 + k^2 omega^2), k the gyration radius: v = S cos share, k
/// omega = S sin share.
struct SlidingFlow
{
  const SlidingFriction &friction_at;
  double mass;
  double gyration_radius;
  double initial_scale;
  bool spins_only; ///< v = 0 from the start: cos(pi / 2) is not quite 0, and friction may let v grow

  double cosine(double share) const { return spins_only ? 0. : std::cos(share); }

  double scale(double sigma) const { return initial_scale * std::exp(-sigma); }

  void operator()(const State &state, State &rate, double sigma) const
  {
    const double s = scale(sigma), c = cosine(state[0]), sine = std::sin(state[0]);
    // Friction depends on the ratio of the two speeds only.
    const Wrench friction = friction_at(std::max(c, 0.), sine / gyration_radius);
    const double push = friction.force_x / mass;
    const double twist = friction.torque / (mass * gyration_radius);
    const double loss = -(c * push + sine * twist); // -dS/dt > 0
    rate[0] = spins_only ? 0. : (c * twist - sine * push) / loss;
    rate[1] = c > 0. ? friction.force_y / (mass * c * loss) : 0.;
    const double clock = s / loss; // dt / dsigma
    const double omega = s * sine / gyration_radius;
    rate[2] = omega * clock;
    rate[3] = s * c * std::cos(state[1]) * clock;
    rate[4] = s * c * std::sin(state[1]) * clock;
    rate[5] = clock;
    rate[6] = -(friction.force_x * s * c + friction.torque * omega) * clock;
    rate[7] = s * c * clock;
  }

  SlidingState physical(const State &state, double s) const
  {
    return { state[5],
             state[3],
             state[4],
             state[2],
             s * cosine(state[0]),
             spins_only ? std::numeric_limits<double>::quiet_NaN() : state[1],
             s * std::sin(state[0]) / gyration_radius,
             state[6],
             state[7] };
  }
};

/// Rate at which eps = omega R / v grows, up to a positive factor, for eps of either sign: R (tau / I -
/// (omega / v) T_x / m).
double slip_ratio_growth(const SlidingInertia &inertia, const SlidingFriction &friction_at, double eps)
{
  const Wrench friction = friction_at(1., eps / inertia.outer_radius);
  return friction.torque * (inertia.outer_radius / inertia.yaw_inertia) -
         eps * friction.force_x / inertia.mass;
}

/// d heading / d sigma that is no rounding at the stop.
constexpr double least_turning = 1e-7;

/// Slip ratios by a parameter that is even in eps up to 1 and in 1/eps beyond, without 0 and infinity.
double slip_ratio_at(double t)
{
  return t <= 1. ? t : 1. / (2. - t);
}

} // namespace

void SlidingInertia::validate() const
{
  require_positive(mass, "the mass of the slider", "kg");
  require_positive(yaw_inertia, "the yaw inertia", "kg m^2");
  require_positive(outer_radius, "the outer radius", "m");
}

void FreeSlider::validate() const
{
  SlidingInertia{ mass, yaw_inertia, body.outer_radius() }.validate();
  require_positive(friction_coefficient, "the friction coefficient", "");
  require_positive(gravity, "gravity", "m/s^2");
  require(std::isfinite(centre_of_mass_height) && centre_of_mass_height >= 0., "the centre of mass is ",
          centre_of_mass_height, " m above the table, but must be at a finite height that is not negative");
}

Wrench sliding_friction(const FreeSlider &slider, double speed, double omega)
{
  // Averages over the weight of the kernels of n = 0, 1, times powers of r.
  double drag_0 = 0., drag_1 = 0., side_1 = 0., torque_0 = 0., torque_1 = 0.;
  for (const WeightedRing &one : slider.body.rings(omega == 0. ? HUGE_VAL : speed / std::abs(omega)))
  {
    const FrictionKernels kernels(omega * one.radius, speed, 1);
    drag_0 += one.weight * kernels.U(0);
    drag_1 += one.weight * one.radius * kernels.U(1);
    side_1 += one.weight * one.radius * kernels.P(1);
    torque_0 += one.weight * one.radius * kernels.K(0);
    torque_1 += one.weight * one.radius * one.radius * kernels.K(1);
  }
  // The tilt (alpha, beta) of the pressure: N <r^2>/2 alpha = -h T_x, N <r^2>/2 beta = -h T_y, as for one
  // ring.
  const double mu = slider.friction_coefficient / (2. * pi), force = slider.mass * slider.gravity;
  const double coupling = 2. * mu * slider.centre_of_mass_height / slider.body.mean_square_radius();
  const double alpha = coupling * drag_0 / (1. + coupling * coupling * drag_1 * side_1);
  const double beta = -coupling * alpha * side_1;
  return { mu * force * (torque_0 + beta * torque_1), -mu * force * (drag_0 + beta * drag_1),
           mu * force * alpha * side_1 };
}

SlidingPath slide_to_stop(const SlidingInertia &inertia, const SlidingFriction &friction, double speed,
                          double omega, double accuracy)
{
  inertia.validate();
  require(std::isfinite(speed) && speed >= 0. && std::isfinite(omega) && (speed > 0. || omega != 0.),
          "the body starts with ", speed, " m/s and ", omega,
          " rad/s, but both must be finite, the speed not negative and one of them not zero");
  require_positive(accuracy, "the requested accuracy", "");
  const double gyration_radius = std::sqrt(inertia.yaw_inertia / inertia.mass);
  const SlidingFlow flow{ friction, inertia.mass, gyration_radius, std::hypot(speed, gyration_radius * omega),
                          speed == 0. };

  namespace odeint = boost::numeric::odeint;
  auto stepper = odeint::make_controlled(accuracy * 1e-2, accuracy, odeint::runge_kutta_dopri5<State>());
  State state{ std::atan2(gyration_radius * omega, speed), 0., 0., 0., 0., 0., 0., 0. };
  SlidingPath path{ { flow.physical(state, flow.initial_scale) }, 0. };
  double sigma = 0., step = 1e-3;
  const double end = 44.; // S has fallen below the rounding of its initial value squared
  for (unsigned int n_trials = 0; sigma < end; ++n_trials)
  {
    if (n_trials > 100000)
      throw NoBalance(sentence("the slide did not come to rest: stuck at v = ", path.states.back().speed,
                               " m/s, omega = ", path.states.back().omega,
                               " rad/s; request a lower accuracy than ", accuracy));
    step = std::min(step, end - sigma);
    if (stepper.try_step(std::cref(flow), state, sigma, step) == odeint::success)
      path.states.push_back(flow.physical(state, flow.scale(sigma)));
  }
  State rate;
  flow(state, rate, end);
  if (std::abs(rate[1]) > least_turning)
    state[1] = std::numeric_limits<double>::quiet_NaN();
  path.states.push_back(flow.physical(state, 0.));
  path.final_slip_ratio = flow.spins_only
                            ? std::copysign(std::numeric_limits<double>::infinity(), omega)
                            : final_slip_ratio(inertia, friction, omega * inertia.outer_radius / speed);
  return path;
}

double final_slip_ratio(const SlidingInertia &inertia, const SlidingFriction &friction, double slip_ratio,
                        unsigned int n_intervals)
{
  require_finite(slip_ratio, "the initial slip ratio");
  require(n_intervals > 0, "the grid of slip ratios has no intervals; give at least one");
  const double start = std::abs(slip_ratio), sense = std::copysign(1., slip_ratio);
  const auto growth = [&](double t)
  { return sense * slip_ratio_growth(inertia, friction, sense * slip_ratio_at(t)); };
  double from = start <= 1. ? start : 2. - 1. / start, left = growth(from);
  if (start == 0. || left == 0.)
    return slip_ratio;
  // The ratio obeys an autonomous equation of its own: it moves one way up to the next root.
  const double way = left > 0. ? 1. : -1.;
  const auto next = [&](double t)
  {
    return (way > 0. ? std::floor(t * n_intervals * (1. + 1e-12))
                     : std::ceil(t * n_intervals * (1. - 1e-12))) +
           way;
  };
  for (double i = next(from); 0. < i && i < 2. * n_intervals; i += way)
  {
    const double to = i / n_intervals, right = growth(to);
    if (left * right <= 0.)
      return sense *
             slip_ratio_at(bracketed_zero(growth, from, to, left, right, "the slip ratio at the stop"));
    from = to;
    left = right;
  }
  return sense * (way > 0. ? std::numeric_limits<double>::infinity() : 0.);
}
} // namespace stemware::ring
