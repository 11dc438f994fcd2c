#include "ring_model/yaw_dynamics.h"

#include "ring_model/require.h"

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/numeric/odeint/integrate/max_step_checker.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>

#include <algorithm>
#include <cmath>

namespace stemware::ring
{
std::vector<SpinSample> spin_up_euler(const TorqueFunction &torque, double yaw_inertia, double initial_spin,
                                      double time_step, unsigned int n_steps)
{
  require_positive(yaw_inertia, "the yaw inertia", "kg m^2");
  require_positive(time_step, "the time step", "s");
  require_finite(initial_spin, "the initial spin [rad/s]");
  std::vector<SpinSample> samples{ { 0., initial_spin } };
  samples.reserve(n_steps + 1);
  for (unsigned int i = 1; i <= n_steps; ++i)
  {
    const double omega = samples.back().omega;
    samples.push_back({ i * time_step, omega + torque(omega) / yaw_inertia * time_step });
  }
  return samples;
}

std::vector<SpinSample> spin_up(const TimedTorqueFunction &torque, double yaw_inertia, double initial_spin,
                                const std::vector<double> &times, double accuracy, double spin_scale)
{
  require_positive(yaw_inertia, "the yaw inertia", "kg m^2");
  require_positive(accuracy, "the requested accuracy", "");
  require_positive(spin_scale, "the spin scale v / R", "rad/s");
  require_finite(initial_spin, "the initial spin [rad/s]");
  require(std::is_sorted(times.begin(), times.end()) &&
            (times.empty() || (times.front() >= 0. && std::isfinite(times.back()))),
          "the ", times.size(), " output times must be finite, increasing and not negative");

  // The error of one step is held a decade below the request: errors of all steps add up, and the
  // interpolation between steps is one order lower than the steps themselves.
  namespace odeint = boost::numeric::odeint;
  auto stepper = odeint::make_dense_output(accuracy * spin_scale / 10., accuracy / 10.,
                                           odeint::runge_kutta_dopri5<double>());
  const double end = times.empty() ? 0. : times.back();
  const auto derivative = [&](const double &omega, double &rate, double time)
  { rate = torque(std::min(time, end), omega) / yaw_inertia; };
  const double push = std::abs(torque(0., initial_spin)) / yaw_inertia;
  stepper.initialize(initial_spin, 0., push > 0. ? 1e-3 * spin_scale / push : 1e-3);

  std::vector<SpinSample> samples;
  samples.reserve(times.size());
  for (const double time : times)
  {
    unsigned int n_steps = 0;
    while (stepper.current_time() < time * (1. - 1e-15))
    {
      // The last step ends at the last output: a torque given by a table may be unknown beyond.
      if (stepper.current_time() + stepper.current_time_step() > end)
        stepper.initialize(double(stepper.current_state()), stepper.current_time(),
                           end - stepper.current_time());
      stepper.do_step(derivative);
      if (++n_steps > 100000 || !std::isfinite(stepper.current_state()))
        throw std::runtime_error(sentence("the spin-up did not reach t = ", time, " s: stuck at t = ",
                                          stepper.current_time(), " s with omega = ", stepper.current_state(),
                                          " rad/s; ask for less than an accuracy of ", accuracy));
    }
    double omega = initial_spin;
    if (time > 0.)
      stepper.calc_state(time, omega);
    samples.push_back({ time, omega });
  }
  return samples;
}

double settling_time(const TorqueFunction &torque, double yaw_inertia, double initial_spin,
                     double terminal_omega, double fraction)
{
  require_positive(yaw_inertia, "the yaw inertia", "kg m^2");
  require(fraction > 0. && fraction < 1., "the settling fraction is ", fraction,
          ", but must lie between 0 and 1");
  const double change = terminal_omega - initial_spin;
  if (change == 0.)
    return 0.;
  // With omega = terminal - change e^{-s} the integrand stays bounded however small the fraction is.
  const auto time_per_e_fold = [&](double s)
  {
    const double remaining = change * std::exp(-s);
    const double push = torque(terminal_omega - remaining) / remaining;
    if (!(push > 0.))
      throw std::runtime_error(sentence("the torque at ", terminal_omega - remaining,
                                        " rad/s does not push the ring from ", initial_spin, " to ",
                                        terminal_omega, " rad/s: the spin never settles there"));
    return yaw_inertia / push;
  };
  return boost::math::quadrature::gauss_kronrod<double, 31>::integrate(time_per_e_fold, 0.,
                                                                       -std::log(fraction), 12, 1e-13);
}
} // namespace stemware::ring
