#include "ring_model/free_sliding.h"

#include "ring_model/constants.h"
#include "ring_model/friction_kernels.h"
#include "ring_model/require.h"

#include <boost/math/tools/toms748_solve.hpp>
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
/// Integrated over sigma: angle between sliding and spinning, heading, yaw, x, y, time.
using State = std::array<double, 6>;

/// The body's motion at the scale S = sqrt(v^2 + k^2 omega^2), k the gyration radius: v = S cos share, k
/// omega = S sin share.
struct SlidingFlow
{
  const FreeSlider &slider;
  double gyration_radius;
  double initial_scale;

  double scale(double sigma) const { return initial_scale * std::exp(-sigma); }

  void operator()(const State &state, State &rate, double sigma) const
  {
    const double s = scale(sigma), c = std::cos(state[0]), sine = std::sin(state[0]);
    // Friction depends on the ratio of the two speeds only.
    const Wrench friction = sliding_friction(slider, std::max(c, 0.), sine / gyration_radius);
    const double push = friction.force_x / slider.mass;
    const double twist = friction.torque / (slider.mass * gyration_radius);
    const double loss = -(c * push + sine * twist); // -dS/dt > 0
    rate[0] = (c * twist - sine * push) / loss;
    rate[1] = c > 0. ? friction.force_y / (slider.mass * c * loss) : 0.;
    const double clock = s / loss; // dt / dsigma
    rate[2] = s * sine / gyration_radius * clock;
    rate[3] = s * c * std::cos(state[1]) * clock;
    rate[4] = s * c * std::sin(state[1]) * clock;
    rate[5] = clock;
  }

  SlidingState physical(const State &state, double s) const
  {
    return { state[5],
             state[3],
             state[4],
             state[2],
             s * std::cos(state[0]),
             state[1],
             s * std::sin(state[0]) / gyration_radius };
  }
};
/// Rate at which eps = omega R / v grows, up to a positive factor, for eps >= 0: R (tau / I - (omega / v) T_x
/// / m).
double slip_ratio_growth(const FreeSlider &slider, double eps)
{
  const double outer = slider.body.outer_radius();
  const Wrench friction = sliding_friction(slider, 1., eps / outer);
  return friction.torque * (outer / slider.yaw_inertia) - eps * friction.force_x / slider.mass;
}
} // namespace

void FreeSlider::validate() const
{
  require_positive(mass, "the mass of the slider", "kg");
  require_positive(yaw_inertia, "the yaw inertia", "kg m^2");
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

SlidingPath slide_to_stop(const FreeSlider &slider, double speed, double omega, double accuracy)
{
  slider.validate();
  require_positive(speed, "the initial speed", "m/s");
  require_finite(omega, "the initial spin [rad/s]");
  require_positive(accuracy, "the requested accuracy", "");
  const double gyration_radius = std::sqrt(slider.yaw_inertia / slider.mass);
  const SlidingFlow flow{ slider, gyration_radius, std::hypot(speed, gyration_radius * omega) };

  namespace odeint = boost::numeric::odeint;
  auto stepper = odeint::make_controlled(accuracy * 1e-2, accuracy, odeint::runge_kutta_dopri5<State>());
  State state{ std::atan2(gyration_radius * omega, speed), 0., 0., 0., 0., 0. };
  SlidingPath path{ { flow.physical(state, flow.initial_scale) },
                    ring::final_slip_ratio(slider, omega * slider.body.outer_radius() / speed) };
  double sigma = 0., step = 1e-3;
  const double end = 44.; // S has fallen below the rounding of its initial value squared
  for (unsigned int n_trials = 0; sigma < end; ++n_trials)
  {
    if (n_trials > 100000)
      throw std::runtime_error(sentence(
        "the slide did not come to rest: stuck at v = ", path.states.back().speed,
        " m/s, omega = ", path.states.back().omega, " rad/s; ask for less than an accuracy of ", accuracy));
    step = std::min(step, end - sigma);
    if (stepper.try_step(std::cref(flow), state, sigma, step) == odeint::success)
      path.states.push_back(flow.physical(state, flow.scale(sigma)));
  }
  path.states.push_back(flow.physical(state, 0.));
  return path;
}

std::vector<double> self_similar_slip_ratios(const FreeSlider &slider)
{
  slider.validate();
  // Slip ratios on a grid that is even in eps up to 1 and in 1/eps beyond, without 0 and infinity.
  const unsigned int n_intervals = 200;
  const auto slip_ratio = [](double t) { return t <= 1. ? t : 1. / (2. - t); };
  const auto grid = [](unsigned int i) { return static_cast<double>(i) / n_intervals; };
  const auto growth = [&](double t) { return slip_ratio_growth(slider, slip_ratio(t)); };

  std::vector<double> ratios;
  double left = growth(grid(1));
  for (unsigned int i = 1; i + 2 < 2 * n_intervals; ++i)
  {
    const double right = growth(grid(i + 1));
    std::uintmax_t n_iterations = 200;
    if (left == 0.)
      ratios.push_back(slip_ratio(grid(i)));
    else if (left * right < 0.)
    {
      const auto bracket =
        boost::math::tools::toms748_solve(growth, grid(i), grid(i + 1), left, right,
                                          boost::math::tools::eps_tolerance<double>(52), n_iterations);
      const bool first_is_better = std::abs(growth(bracket.first)) <= std::abs(growth(bracket.second));
      ratios.push_back(slip_ratio(first_is_better ? bracket.first : bracket.second));
    }
    left = right;
  }
  return ratios;
}

double final_slip_ratio(const FreeSlider &slider, double slip_ratio)
{
  require_finite(slip_ratio, "the initial slip ratio");
  const double start = std::abs(slip_ratio), growth = slip_ratio_growth(slider, start);
  if (start == 0. || growth == 0.)
    return slip_ratio;
  // The ratio obeys an autonomous equation of its own: it moves one way up to the next root.
  double final_ratio = growth > 0. ? std::numeric_limits<double>::infinity() : 0.;
  for (const double root : self_similar_slip_ratios(slider))
    if (growth > 0. ? root > start && root < final_ratio : root < start)
      final_ratio = root;
  return std::copysign(final_ratio, slip_ratio);
}
} // namespace stemware::ring
