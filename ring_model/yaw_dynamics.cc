#include "ring_model/yaw_dynamics.h"

#include "ring_model/no_balance.h"
#include "ring_model/require.h"
#include "ring_model/sampled_trajectory.h"

#include <boost/math/quadrature/gauss_kronrod.hpp>

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
  require_output_times(times);
  const auto derivative = [&](const double &omega, double &rate, double time)
  { rate = torque(time, omega) / yaw_inertia; };
  const double push = std::abs(torque(0., initial_spin)) / yaw_inertia;
  const double first_step = push > 0. ? 1e-3 * spin_scale / push : 1e-3;
  const std::vector<double> spins =
    sampled_trajectory(derivative, initial_spin, first_step, times, accuracy, spin_scale);
  std::vector<SpinSample> samples;
  samples.reserve(times.size());
  for (std::size_t i = 0; i < times.size(); ++i)
    samples.push_back({ times[i], spins[i] });
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
      throw NoBalance(sentence("the torque at ", terminal_omega - remaining,
                               " rad/s does not push the ring from ", initial_spin, " to ", terminal_omega,
                               " rad/s: the spin never settles there"));
    return yaw_inertia / push;
  };
  return boost::math::quadrature::gauss_kronrod<double, 31>::integrate(time_per_e_fold, 0.,
                                                                       -std::log(fraction), 12, 1e-13);
}
} // namespace stemware::ring
