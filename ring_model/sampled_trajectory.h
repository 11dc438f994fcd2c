#pragma once

#include "ring_model/load/require.h"
#include "ring_model/no_balance.h"

#include <boost/numeric/odeint/algebra/array_algebra.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace stemware::ring
{
inline bool is_finite(double value)
{
  return std::isfinite(value);
}

template <std::size_t n>
bool is_finite(const std::array<double, n> &values)
{
  return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

/// Throws std::invalid_argument unless @p times are finite, increasing and not negative.
inline void require_output_times(const std::vector<double> &times)
{
  require(std::is_sorted(times.begin(), times.end()) &&
            (times.empty() || (times.front() >= 0. && std::isfinite(times.back()))),
          "the ", times.size(), " output times must be finite, increasing and not negative");
}

/**
 * States at @p times of a motion that begins with @p start at t = 0, by the Dormand-Prince pair with step
 * control and dense output (Boost.Odeint). @p State is double or an array of doubles.
 *
 * @param derivative (state, rate, time): writes d state/dt; never asked for times beyond the last of @p
 * times.
 * @param accuracy Requested of a component, relative to the largest of its size and @p scale.
 * @throws std::runtime_error if the step control gives up.
 */
template <typename State, typename Derivative>
std::vector<State> sampled_trajectory(const Derivative &derivative, const State &start, double first_step,
                                      const std::vector<double> &times, double accuracy, double scale)
{
  // The error of one step is held a decade below the request: errors of all steps add up, and the
  // interpolation between steps is one order lower than the steps themselves.
  namespace odeint = boost::numeric::odeint;
  auto stepper =
    odeint::make_dense_output(accuracy * scale / 10., accuracy / 10., odeint::runge_kutta_dopri5<State>());
  const double end = times.empty() ? 0. : times.back();
  const auto rate_of = [&](const State &state, State &rate, double time)
  { derivative(state, rate, std::min(time, end)); };
  stepper.initialize(start, 0., first_step);

  std::vector<State> samples;
  samples.reserve(times.size());
  for (const double time : times)
  {
    unsigned int n_steps = 0;
    while (stepper.current_time() < time * (1. - 1e-15))
    {
      // The last step ends at the last output: a torque given by a table may be unknown beyond.
      if (stepper.current_time() + stepper.current_time_step() > end)
        stepper.initialize(State(stepper.current_state()), stepper.current_time(),
                           end - stepper.current_time());
      stepper.do_step(rate_of);
      if (++n_steps > 100000 || !is_finite(stepper.current_state()))
        throw NoBalance(sentence("the spin-up did not reach t = ", time, " s: stuck at t = ",
                                 stepper.current_time(), " s; ask for less than an accuracy of ", accuracy));
    }
    State state = start;
    if (time > 0.)
      stepper.calc_state(time, state);
    samples.push_back(state);
  }
  return samples;
}
} // namespace stemware::ring
