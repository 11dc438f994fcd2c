#include "fem/pipeline/analysis/goal_mesh.h"

#include "fem/pipeline/base/failures.h"
#include "fem/pipeline/coupling/study_load.h"
#include "ring_model/friction_functionals.h"
#include "ring_model/spin/answer.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace stemware::pipeline
{

namespace
{

/// Returns the friction torque tau_z at @p omega as a goal, linearised at @p state. Adds the lean torque if
/// @p with_lean is true.
fem::ContactGoal torque_goal(const ring::Motion &motion, const fem::ContactState &state, double omega,
                             bool with_lean)
{
  fem::ContactGoal goal;
  goal.ring_radii = state.load.radii();
  goal.of_load = ring::friction_functionals(motion, goal.ring_radii, state.load.n_harmonics(), omega).torque;
  if (with_lean)
  {
    // The lean torque is -q1 M_Nx - q2 M_Ny.
    goal.of_moment = -state.solution.motion.tail<2>();
    goal.of_motion << 0, -state.load.moment();
  }
  return goal;
}

/// Returns a_2 / a_0 as a goal. The weight of the glass determines a_0, so a_0 is constant.
fem::ContactGoal second_harmonic_goal(const fem::ContactState &state)
{
  fem::ContactGoal goal;
  goal.ring_radii = state.load.radii();
  const auto n_rings = static_cast<Eigen::Index>(goal.ring_radii.size());
  goal.of_load = { Eigen::ArrayXXd::Zero(3, n_rings), Eigen::ArrayXXd::Zero(3, n_rings) };
  goal.of_load.a.row(2) = 1 / state.load.a(0);
  return goal;
}

/// Fraction of the total error that the halved cells contribute. Cells with the largest errors are halved
/// first.
constexpr double marked_share = 0.8;

GoalError error_of(const FootSpecification &specification, const Executor &executor)
{
  const auto foot = foot_of({ specification }, nullptr, executor);
  ensure(foot->body().capabilities().glass_period == 0,
         "Contact/Goal needs a foot whose load does not depend on the direction of the moment, but this "
         "Contact/Mesh file is not axisymmetric; set Contact/Goal = none.");
  const BalancedLoad load = find_load(specification.study, foot);
  const MotionSection &motion = specification.study.motion;
  const ring::Question question = { motion.orbit, motion.grip_torque };
  const double omega = ring::answer(load, question).value().omega_terminal().value();
  const auto found = goal_error(*foot, load, omega, specification.study.contact.goal, true);
  if (!found)
    throw std::runtime_error(
      "The error of Contact/Goal cannot be estimated in this study: the contact with the hard table is "
      "narrower than two of its cells; set Contact/Goal = none or Contact/Body = revolution.");
  return *found;
}

/// Throws if the next mesh for a goal exceeds the memory limit. @p before: error on the mesh before the last
/// halvings of @p meshed. Halving replaces a cell by 8 cells; linear elements have 4.5 unknowns per cell.
void require_memory(const ContactSection &contact, const Discretisation &meshed, const GoalError &before)
{
  constexpr double per_unknown = 10e3; // measured [bytes]; most of the memory is used by the error estimate
  const double n_cells =
    static_cast<double>(before.error.cells.size() + 7 * meshed.halved_cells.back().size());
  const double memory = per_unknown * 4.5 * n_cells * std::pow(contact.degree, 3);
  if (memory > contact.memory_limit)
    throw std::runtime_error(
      fmt::format(FMT_STRING("The error of the goal is {:.1e} of its value, but the next mesh would have "
                             "{:.2g} cells and need about {:.2g} GB of memory; increase Contact/Goal "
                             "tolerance, or set Contact/Memory limit = {:.0f} GB."),
                  std::abs(before.error.correction / before.value), n_cells, memory / 1e9,
                  std::ceil(1.1 * memory / 1e9)));
}

} // namespace

std::optional<GoalError> goal_error(const ElasticFoot &foot, const BalancedLoad &load, double omega_terminal,
                                    Goal goal, bool with_cells)
{
  const auto &[study, discretisation, model] = foot.specification();
  if (study.contact.is_of_revolution() || !load.contact(0) || foot.ring_radii().empty() ||
      foot.body().capabilities().glass_period > 0 || goal == Goal::none)
    return std::nullopt;
  const ring::Motion &motion = study.motion.orbit;
  const double omega = goal == Goal::terminal_spin ? omega_terminal
                       : goal == Goal::torque      ? omega_terminal / 2
                                                   : 0;
  const fem::ContactState state = *load.contact(omega);
  const fem::ContactGoal functional =
    goal == Goal::a2 ? second_harmonic_goal(state)
                     : torque_goal(motion, state, omega, goal == Goal::terminal_spin && study.tilts());
  std::optional<fem::MeshError> error = foot.body().mesh_error(state, functional, with_cells);
  if (!error)
    return std::nullopt;
  GoalError result = { functional.of_load(state.load), std::move(*error) };
  if (goal == Goal::torque)
    result.value = ring::wrench(motion, load.at(omega), omega).torque;
  if (goal == Goal::terminal_spin)
  {
    result.value = omega_terminal;
    // With the slope d tau_z / d omega [N m s] of the load in balance at each spin.
    const double step = load.spin_scale(motion) / 512;
    const double per_torque =
      -2 * step / (yaw_torque(load, motion, omega + step) - yaw_torque(load, motion, omega - step));
    result.error.correction *= per_torque;
    for (double &share : result.error.cells)
      share *= std::abs(per_torque);
  }
  return result;
}

GoalOutcome mesh_for_goal(const Study &study, const Executor &executor)
{
  if (study.contact.goal == Goal::none || !study.load.is_from_contact())
    return {};
  constexpr unsigned int max_meshes = 20;
  constexpr double allowed_cancelling = 5;
  Discretisation meshed;
  for (unsigned int n_meshes = 1;; ++n_meshes)
  {
    const GoalError found = error_of({ study, meshed }, executor);
    const double allowed = study.contact.goal_tolerance * std::abs(found.value);
    executor.progress.pieces_done("meshes for the goal", n_meshes, 0);
    const double sum_of_shares = std::accumulate(found.error.cells.begin(), found.error.cells.end(), 0.);
    if (std::abs(found.error.correction) <= allowed && sum_of_shares <= allowed_cancelling * allowed)
    {
      const std::size_t n_cells = found.error.cells.size();
      executor.progress.note("Mesh",
                             fmt::format(FMT_STRING("{} cells, mesh {} for the goal; estimated error of the "
                                                    "goal {:.1e} of its value"),
                                         n_cells, n_meshes, std::abs(found.error.correction / found.value)));
      return { std::move(meshed), found.value, found.error.correction, n_meshes, n_cells };
    }
    if (n_meshes == max_meshes)
      throw std::runtime_error(fmt::format(
        FMT_STRING("The goal's error is still {:.1e} of its value after {} meshes, more than "
                   "Contact/Goal tolerance = {:g}; give a larger tolerance."),
        std::abs(found.error.correction / found.value), max_meshes, study.contact.goal_tolerance));
    meshed.halved_cells.push_back(found.error.mark(marked_share));
    require_memory(study.contact, meshed, found);
  }
}

} // namespace stemware::pipeline
