#include "fem/contact/contact_newton.h"

#include "fem/contact/rigid_foot.h"
#include "fem/geometry/require.h"

#include <Eigen/Eigenvalues>
#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace stemware::fem
{

namespace
{

/// Minimum number of loaded nodes side by side across the rim for a resolved pressure.
constexpr unsigned int min_nodes_across = 4;

/// Returns the step length of Newton's method: 1, or the stationary point of the energy if the energy
/// increases at the end of the step. @p may_go_beyond: up to 2, because steps towards a narrower contact are
/// too short. @p slope: energy slope at a step length; @p start, @p end: slopes at 0 and 1; @p noise:
/// rounding of slopes.
template <typename Slope>
double line_search_step(const Slope &slope, double start, double end, double noise, bool may_go_beyond)
{
  constexpr double longest = 2;
  // Slopes below their rounding noise contain no information, so the full step is taken.
  const double tolerance = (may_go_beyond ? 0.02 : 0.5) * std::abs(start) + noise;
  if (start >= 0 || (end <= tolerance && (end >= -tolerance || !may_go_beyond)))
    return 1;
  const auto close_enough = [](double a, double b) { return b - a < 0.02 * b; };
  const auto stationary = [&](double from, double to, double slope_from, double slope_to)
  {
    boost::uintmax_t max_evaluations = 60;
    const auto bracket =
      boost::math::tools::toms748_solve(slope, from, to, slope_from, slope_to, close_enough, max_evaluations);
    return (bracket.first + bracket.second) / 2;
  };
  if (end > 0)
    return stationary(0, 1, start, end);
  const double beyond = slope(longest);
  return beyond <= 0 ? longest : stationary(1, longest, end, beyond);
}

class ContactNewton
{
public:
  ContactNewton(ElasticBody &body, TableLaw &law, const LinearConditions &conditions, double radius,
                const ContactControl &control, const ContactStart &start)
      : body(body)
      , law(law)
      , control(control)
      , conditions(conditions)
      , radius(radius)
      , parts(body.contact_surface().parts)
      , modes(body.contact_surface().motion_modes())
      , motion(start.motion)
      , normal_displacement(start.normal_displacement)
      , n_steps(start.n_steps)
      , n_linear_iterations(start.n_linear_iterations)
  {
    evaluate();
  }

  void converge()
  {
    bool balanced_before = false;
    double residual_before = std::numeric_limits<double>::infinity();
    double least_residual = std::numeric_limits<double>::infinity();
    unsigned int n_idle = 0;
    visits.clear();
    for (;;)
    {
      const double present_residual = residual();
      n_idle = present_residual > 0.5 * least_residual ? n_idle + 1 : 0;
      least_residual = std::min(least_residual, present_residual);
      const bool balanced = is_balanced() || stagnates(present_residual, residual_before, n_idle);
      // After two successive balanced iterates, the iteration stops even if the active set has changed,
      // because it then changes only at nodes with zero force.
      if (balanced && n_steps > 0 && (n_changed == 0 || balanced_before || !control.requires_unchanged_set))
        return;
      if (control.requires_unchanged_set)
        require_new_set(present_residual);
      balanced_before = balanced;
      residual_before = present_residual;
      step();
      if (control.accepts_iterate && control.accepts_iterate(solution()))
        return;
    }
  }

  /// Augmented Lagrangian method: updates the multipliers until the violation is within the tolerance.
  void converge_outer_iteration()
  {
    for (;;)
    {
      converge();
      const double violation = law.augmented_lagrangian_update(normal_displacement);
      if (violation == 0)
        return;
      evaluate();
      // The violation is compared with the larger of the displacements of body and table, not with their sum,
      // which tends to zero together with the violation on a flat land.
      const double moved = parts.max(std::max(body.contact_displacement().lpNorm<Eigen::Infinity>(),
                                              (modes * motion).lpNorm<Eigen::Infinity>()));
      if (violation <= control.tolerance * moved)
        return;
    }
  }

  ContactSolution solution() const
  {
    ContactSolution result;
    result.forces = body.elastic_forces(contact.forces);
    result.force_mismatch = result.forces - contact.forces;
    result.normal_displacement = normal_displacement;
    result.motion = motion;
    result.n_iterations = n_steps;
    result.n_linear_iterations = n_linear_iterations;
    const Eigen::VectorXd pressure = law.nodal_pressure(result);
    const Eigen::Index n_owned_nodes = body.contact_surface().n_owned_nodes();
    result.n_loaded_nodes =
      parts.sum(static_cast<std::size_t>((pressure.head(n_owned_nodes).array() > 0).count()));
    result.n_nodes_across = body.contact_surface().n_nodes_across(pressure);
    if (control.requires_unchanged_set && result.n_nodes_across < min_nodes_across)
      result.outcome = ContactOutcome::narrow_contact;
    const Eigen::Vector3d residual = conditions.residual(result.forces, motion);
    result.force_residual = std::abs(residual(0)) / conditions.normal_force();
    result.moment_residual = residual.tail<2>().norm() / (conditions.normal_force() * radius);
    result.equilibrium_residual = equilibrium;
    result.stability_margin = stability_margin;
    return result;
  }

private:
  void evaluate()
  {
    law.evaluate(normal_displacement, contact);
    compute_residual();
  }

  void compute_residual()
  {
    condition_residual = conditions.residual(contact.forces, motion);
    equilibrium = body.equilibrium_residual(contact.forces);
  }

  double resultant_residual() const
  {
    return Eigen::Vector3d(condition_residual(0), condition_residual(1) / radius,
                           condition_residual(2) / radius)
             .norm() /
           conditions.normal_force();
  }

  double residual() const { return std::max(resultant_residual(), equilibrium); }

  bool is_balanced() const
  {
    return resultant_residual() <= control.tolerance && equilibrium <= control.equilibrium_tolerance;
  }

  /// Returns true if the residual passes the final check but stagnates: it was not halved by a full step
  /// without a change of the active set, or by the last @p n_idle steps (at least `patience`). Rounding
  /// errors under the stiff penalty of a rigid table can keep the residual above the tolerance.
  bool stagnates(double present_residual, double residual_before, unsigned int n_idle) const
  {
    constexpr unsigned int patience = 10;
    const bool at_rest = n_changed == 0 && last_step_length == 1 && present_residual > 0.5 * residual_before;
    return n_steps > 0 && (at_rest || n_idle >= patience) &&
           resultant_residual() <= control.resultant_tolerance &&
           equilibrium <= control.equilibrium_tolerance;
  }

  /// Throws if a full Newton step returns to a previous active set without a smaller residual (a cycle).
  /// Damped steps may return to a previous set: each reduces the energy, so they cannot cycle.
  void require_new_set(double present_residual)
  {
    if (makes_progress(present_residual) || last_step_length != 1)
      return;
    throw ContactFailure(ContactOutcome::repeated_set,
                         sentence("the active set cycles after ", n_steps, " Newton steps, with ", n_loaded(),
                                  " loaded points and a relative residual of ", present_residual,
                                  " (allowed ", control.equilibrium_tolerance,
                                  "); refine the mesh or increase the tolerance."));
  }

  /// Returns whether the active set is new or recurs with less than half the residual.
  bool makes_progress(double present_residual)
  {
    // Two active sets are equal only if they agree on every part (MPI rank) of the surface.
    std::vector<double> differs;
    for (const auto &[set, residual] : visits)
      differs.push_back(set != contact.active_set ? 1 : 0);
    parts.sum_in_place(differs);
    const auto same = std::find(differs.begin(), differs.end(), 0.);
    if (same == differs.end())
    {
      visits.emplace_back(contact.active_set, present_residual);
      return true;
    }
    const double before =
      std::exchange(visits[static_cast<std::size_t>(same - differs.begin())].second, present_residual);
    return present_residual < 0.5 * before;
  }

  void require_support() const
  {
    const Eigen::DiagonalMatrix<double, 3> scale(1, 1 / radius, 1 / radius);
    const Eigen::Matrix3d support =
      scale * parts.sum(motion_stiffness(contact.tangent, modes, modes)) * scale;
    const Eigen::Vector3d stiffness = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(support).eigenvalues();
    if (stiffness(2) > 0 && stiffness(0) > 1e-13 * stiffness(2))
      return;
    throw ContactFailure(
      ContactOutcome::singular_set,
      sentence("the ", n_loaded(),
               " loaded points of the contact zone do not support the foot against tilting, "
               "because the contact is too narrow for this mesh; refine the land."));
  }

  unsigned int n_loaded() const
  {
    return parts.sum(
      static_cast<std::size_t>(std::count(contact.active_set.begin(), contact.active_set.end(), true)));
  }

  void step()
  {
    constexpr unsigned int n_first_steps = 6;
    const bool is_hopeless = n_steps == n_first_steps && residual() > control.divergence_residual;
    if (n_steps >= control.max_steps || is_hopeless)
    {
      throw ContactFailure(ContactOutcome::too_many_steps,
                           sentence(n_steps, " Newton steps left a relative residual of ", residual(),
                                    " (allowed ", control.equilibrium_tolerance,
                                    "; refine the land or reduce the load's moment)."));
    }
    if (n_steps == 0 || n_changed > 0) // each new active set needs this check
      require_support();
    // The first step removes the mismatch of an inconsistent initial guess.
    Eigen::VectorXd mismatch = Eigen::VectorXd::Zero(normal_displacement.size());
    if (n_steps == 0)
      mismatch = normal_displacement - body.contact_displacement() - modes * motion;
    const NewtonIncrement increment =
      body.solve(contact.tangent, contact.forces + contact.tangent * mismatch, conditions, motion);
    const Eigen::VectorXd direction = increment.displacement + modes * increment.motion - mismatch;
    const bool is_whole = control.full_steps || start_is_apart(mismatch);
    const double step_length = conditions.are_resultants() && !is_whole
                                 ? step_to_least_energy(increment, direction)
                                 : step_to_less_residual(increment, direction, is_whole ? 1 : 1. / 64);
    normal_displacement += step_length * direction;
    report(increment, step_length, other_contact.active_set);
  }

  /// Takes the step that minimises the energy along the increment and returns its length. Afterwards
  /// `contact` has the new contact forces, `other_contact` the previous ones.
  double step_to_least_energy(const NewtonIncrement &increment, const Eigen::VectorXd &direction)
  {
    law.evaluate(normal_displacement + direction, other_contact);
    const double step_length = line_search(increment, direction, other_contact.forces);
    body.update(step_length);
    // The forces after a full step are already evaluated.
    if (step_length != 1)
      law.evaluate(normal_displacement + step_length * direction, other_contact);
    contact.swap(other_contact);
    motion += step_length * increment.motion;
    compute_residual();
    return step_length;
  }

  /// Takes the longest of the steps 1, 1/2, 1/4, ..., @p shortest that reduces the residual, or @p shortest
  /// if none does. Returns its length. Sets `contact` and `other_contact` like step_to_least_energy().
  double step_to_less_residual(const NewtonIncrement &increment, const Eigen::VectorXd &direction,
                               double shortest)
  {
    const double residual_before = residual();
    contact.swap(other_contact);
    double step_length = 1;
    body.update(step_length);
    motion += increment.motion;
    for (;;)
    {
      law.evaluate(normal_displacement + step_length * direction, contact);
      compute_residual();
      if (!std::isfinite(residual()))
        throw_overflow();
      if (residual() < residual_before || residual() <= control.tolerance || step_length <= shortest)
        return step_length;
      body.update(-step_length / 2);
      motion -= step_length / 2 * increment.motion;
      step_length /= 2;
    }
  }

  bool start_is_apart(const Eigen::VectorXd &mismatch) const
  {
    return parts.max(mismatch.lpNorm<Eigen::Infinity>()) >
           1e-12 * parts.max(normal_displacement.lpNorm<Eigen::Infinity>());
  }

  /// Returns the step length from line_search_step(). A length above 1 is allowed only if the stopping rule
  /// ignores the active set (laws integrated along lines). It is not allowed for a rigid foot, because a
  /// rigid foot has no elastic energy to limit the step, and a long step could end the contact.
  double line_search(const NewtonIncrement &increment, const Eigen::VectorXd &direction,
                     const Eigen::VectorXd &forces_at_end) const
  {
    const double outer = conditions.target().dot(increment.motion);
    const auto slope_under = [&](double step_length, const Eigen::VectorXd &forces)
    {
      return increment.energy_slope + step_length * increment.energy_curvature + outer -
             parts.sum(forces.dot(direction));
    };
    ContactForces between;
    const auto slope = [&](double step_length)
    {
      law.evaluate(normal_displacement + step_length * direction, between);
      return slope_under(step_length, between.forces);
    };
    const double start = slope_under(0, contact.forces);
    const double end = slope_under(1, forces_at_end);
    if (!std::isfinite(start) || !std::isfinite(end))
      throw_overflow();
    const double noise = 1e-10 * (std::abs(outer) + std::abs(increment.energy_slope));
    return line_search_step(slope, start, end, noise,
                            !control.requires_unchanged_set && increment.energy_curvature > 0);
  }

  [[noreturn]] static void throw_overflow()
  {
    throw ContactFailure(ContactOutcome::overflow,
                         "the contact's energy is not a finite number; bring loads, lengths and moduli to "
                         "usual orders of magnitude.");
  }

  void report(const NewtonIncrement &increment, double step_length, const ActiveSet &set_before)
  {
    ++n_steps;
    std::size_t n_different = 0;
    for (std::size_t i = 0; i < set_before.size(); ++i)
      n_different += set_before[i] != contact.active_set[i];
    n_changed = parts.sum(n_different);
    last_step_length = step_length;
    stability_margin = increment.stability_margin;
    n_linear_iterations += increment.linear_iterations;
    const unsigned int n_loaded_now = n_loaded(); // n_loaded() is collective: every rank must call it
    if (!control.progress)
      return;
    ContactIteration iteration;
    iteration.number = n_steps;
    iteration.n_loaded = n_loaded_now;
    iteration.n_changed = n_changed;
    iteration.residual = residual();
    iteration.step_length = step_length;
    iteration.linear_iterations = increment.linear_iterations;
    control.progress(iteration);
  }

  ElasticBody &body;
  TableLaw &law;
  const ContactControl &control;
  const LinearConditions &conditions;
  const double radius;
  const SurfaceParts &parts;
  const Eigen::MatrixX3d modes;

  Eigen::Vector3d motion;
  Eigen::VectorXd normal_displacement;
  ContactForces contact;
  ContactForces other_contact; ///< forces at the trial step during a step, otherwise at the previous step
  /// Active sets of this part since the start of converge(), with the residual of the last visit.
  std::vector<std::pair<ActiveSet, double>> visits;
  Eigen::Vector3d condition_residual; ///< residual of the conditions on the contact forces
  double equilibrium = 0;             ///< relative residual of the body
  unsigned int n_steps;
  unsigned int n_linear_iterations;
  unsigned int n_changed = 0;
  double last_step_length = 1;
  double stability_margin = 1;
};

void require_balance(const ContactSolution &solution, const ContactControl &control)
{
  if (solution.force_residual <= control.resultant_tolerance &&
      solution.moment_residual <= control.resultant_tolerance)
    return;
  throw ContactFailure(
    ContactOutcome::unbalanced,
    sentence("the normal forces miss the prescribed resultants by ", solution.force_residual, " of N and ",
             solution.moment_residual, " of N R; allowed is ", control.resultant_tolerance,
             "; refine the land, give elements of a higher degree, or reduce the load's moment."));
}

} // namespace

Eigen::Vector3d rigid_foot_motion(const ContactSurface &surface, TableLaw &law,
                                  const LinearConditions &conditions, double radius,
                                  const Eigen::Vector3d &first)
{
  RigidFoot foot(surface);
  ContactControl control;
  control.tolerance = 1e-6;
  control.requires_unchanged_set = false;
  ContactNewton newton(foot, law, conditions, radius, control, { first, surface.motion_modes() * first });
  newton.converge();
  Eigen::Vector3d motion = newton.solution().motion;
  // A tilt at rounding level would break the mirror symmetry that bodies and laws exploit.
  const double negligible = 1e-12 * motion.cwiseProduct(Eigen::Vector3d(1, radius, radius)).norm();
  for (const Eigen::Index tilt : { 1, 2 })
    if (std::abs(motion(tilt)) * radius < negligible)
      motion(tilt) = 0;
  return motion;
}

ContactSolution solve_contact(ElasticBody &body, TableLaw &law, const LinearConditions &conditions,
                              double radius, const ContactControl &control, const ContactStart *start)
{
  conditions.require_possible(radius, body.contact_surface().is_ring);
  ContactStart begin;
  if (start)
    begin = *start;
  else
  {
    body.reset();
    // After the table motion `pressed_in`, the whole contact zone is loaded.
    const ContactSurface &surface = body.contact_surface();
    const double greatest_gap = surface.parts.max_entry(surface.node_gap);
    const double rise = greatest_gap + surface.parts.max_entry(-surface.node_gap);
    const Eigen::Vector3d pressed_in(-(greatest_gap + rise + 1e-6 * radius), 0, 0);
    begin.motion = rigid_foot_motion(surface, law, conditions, radius, pressed_in);
    begin.normal_displacement = surface.motion_modes() * begin.motion;
  }
  ContactNewton newton(body, law, conditions, radius, control, begin);
  newton.converge_outer_iteration();
  const ContactSolution solution = newton.solution();
  require_balance(solution, control);
  return solution;
}

} // namespace stemware::fem
