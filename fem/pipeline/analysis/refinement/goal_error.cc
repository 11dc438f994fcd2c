#include "fem/pipeline/analysis/refinement/goal_error.h"

#include "fem/pipeline/analysis/spin.h"
#include "ring_model/friction_law.h"

#include <cmath>
#include <utility>

namespace stemware::pipeline
{

namespace
{

/// Friction's tau_z at @p omega, @p with_lean the lean torque besides, linearised at @p state.
fem::ContactGoal torque_goal(const Study &study, const fem::ContactState &state, double omega, bool with_lean)
{
  fem::ContactGoal goal;
  goal.ring_radii = state.load.radii();
  goal.of_load =
    ring::friction_functionals(study.motion.orbit, goal.ring_radii, state.load.n_harmonics(), omega).torque;
  if (with_lean && study.tilts())
  {
    // The lean torque is -q1 M_Nx - q2 M_Ny.
    goal.of_moment = -state.solution.motion.tail<2>();
    goal.of_motion << 0, -state.load.moment();
  }
  return goal;
}

/// a_2 / a_0, a_0 being given by the weight.
fem::ContactGoal second_harmonic_goal(const fem::ContactState &state)
{
  fem::ContactGoal goal;
  goal.ring_radii = state.load.radii();
  const std::size_t n_rings = goal.ring_radii.size();
  goal.of_load = { std::vector<std::vector<double>>(n_rings, { 0, 0, 1 / state.load.a(0) }),
                   std::vector<std::vector<double>>(n_rings, { 0, 0, 0 }) };
  return goal;
}

/// d tau_z / d omega in balance [N m s].
double slope_at(const BalancedLoad &load, const ring::Motion &motion, double omega)
{
  const double step = load.spin_scale(motion) / 512;
  return (yaw_torque(load, motion, omega + step) - yaw_torque(load, motion, omega - step)) / (2 * step);
}

void scale(fem::MeshError &error, double factor)
{
  error.correction *= factor;
  for (std::vector<double> *cells : { &error.foot_cells, &error.disc_cells })
    for (double &share : *cells)
      share *= std::abs(factor);
}

} // namespace

std::optional<GoalError> goal_error(const Study &study, const ElasticFoot &foot, const BalancedLoad &load,
                                    double omega_terminal, Goal goal, bool with_cells)
{
  if (!load.contact(0) || foot.ring_radii().empty() || study.contact.degree >= 4 || study.has_waviness() ||
      foot.body().capabilities().period_of_glass > 0 || goal == Goal::none)
    return std::nullopt;
  const ring::Motion &motion = study.motion.orbit;
  const double omega = goal == Goal::terminal_spin ? omega_terminal
                       : goal == Goal::torque      ? omega_terminal / 2
                                                   : 0;
  const fem::ContactState state = *load.contact(omega);
  const fem::ContactGoal functional = goal == Goal::a2
                                        ? second_harmonic_goal(state)
                                        : torque_goal(study, state, omega, goal == Goal::terminal_spin);
  std::optional<fem::MeshError> error = foot.body().mesh_error(state, functional, with_cells);
  if (!error)
    return std::nullopt;
  GoalError result = { functional.of_load(state.load), std::move(*error) };
  if (goal == Goal::torque)
    result.value = wrench(load, motion, omega).torque;
  if (goal == Goal::terminal_spin)
  {
    result.value = omega_terminal;
    scale(result.error, -1 / slope_at(load, motion, omega));
  }
  return result;
}

} // namespace stemware::pipeline
