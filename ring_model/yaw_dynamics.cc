#include "ring_model/yaw_dynamics.h"

#include "ring_model/load/require.h"
#include "ring_model/sampled_trajectory.h"

#include <cmath>

namespace stemware::ring
{
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
} // namespace stemware::ring
