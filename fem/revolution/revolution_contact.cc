#include "fem/revolution/revolution_contact.h"

#include "fem/contact/contact_newton.h"
#include "fem/contact/interface_law.h"
#include "fem/geometry/require.h"
#include "fem/revolution/body_of_revolution.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace stemware::fem
{

namespace
{

/// The last two contact solutions of the continuation in the moment.
struct Path
{
  ContactSolution last;
  ContactSolution before;
  double share = 0; ///< fraction of the full moment in `last`
  double step = 0;  ///< increase of `share` from `before` to `last`; 0 at the beginning

  /// Returns the linear extrapolation to the share @p next.
  ContactStart start(double next) const
  {
    const double ahead = step > 0 ? (next - share) / step : 0;
    return { last.motion + ahead * (last.motion - before.motion),
             last.normal_displacement + ahead * (last.normal_displacement - before.normal_displacement) };
  }

  void append(double next, ContactSolution solution)
  {
    before = std::exchange(last, std::move(solution));
    step = next - share;
    share = next;
  }

  /// Returns true if the tilt of the foot per moment was more than three times as large in the last step as
  /// on average.
  bool is_steep() const
  {
    constexpr double much_steeper = 3;
    return step > 0 && (last.motion - before.motion).tail<2>().norm() / step >
                         much_steeper * last.motion.tail<2>().norm() / share;
  }
};

/// Solves a contact for which Newton's method does not converge directly: the moment grows in steps from
/// zero (solution @p even), and a failed step is halved. Throws ContactFailure if the shortest step fails;
/// its outcome is `tipping` if the tilt diverges and the required moment depends on the tilt or friction.
ContactSolution continue_in_moment(BodyOfRevolution &body, TableLaw &law, const LinearConditions &conditions,
                                   double radius, const ContactControl &usual, const ContactSolution &even)
{
  constexpr double shortest_step = 1. / 512;
  const ContactSurface &surface = body.contact_surface();
  ContactControl control = usual;
  control.full_steps = true;
  control.max_steps = 20;

  Path path = { even, even };
  double step = 1. / 8;
  while (path.share < 1)
    try
    {
      const double next = std::min(1., path.share + step);
      const ContactStart start = path.start(next);
      body.set_forces(path.last.forces);
      path.append(next, solve_contact(body, law, conditions.with_scaled_moment(surface, next), radius,
                                      control, &start));
      step *= 1.5;
    }
    catch (const ContactFailure &)
    {
      step /= 2;
      if (step >= shortest_step)
        continue;
      if (conditions.are_resultants() || !path.is_steep())
        throw;
      throw ContactFailure(
        ContactOutcome::tipping,
        sentence("the required moment grows faster with the tilt than the moment of the contact; the balance "
                 "ends at ",
                 std::round(1000 * path.share) / 10,
                 " % of the moment. Lower the centre of mass or the hand, or reduce the speed."));
    }
  return path.last;
}

/// Stiffening factors of the interface in one step of a cold start. Most cold starts converge with the larger
/// factor.
constexpr double large_stiffening = 1000, small_stiffening = 10;
/// Softening factor of the interface if the initial guess is a distant contact solution.
constexpr double softening_of_start = 30;

class ContactSearch
{
public:
  ContactSearch(const RevolutionSetup &setup, const InterfaceLaw &interface, BodyOfRevolution &body,
                TableLaw &law, const LinearConditions &conditions)
      : setup(setup)
      , interface(interface)
      , body(body)
      , law(law)
      , conditions(conditions)
  {
  }

  ContactSolution solve(const RevolutionGuesses &starts)
  {
    Attempts attempts;
    if (starts.predicted)
      attempts.emplace_back([&] { return solve_near(*starts.predicted); });
    // On a hard table with waviness, softened starts are omitted, because they converge to contact at other
    // crests. Unsoftened starts fail if the waviness has rotated or after the predicted start has failed.
    const bool on_hard_crests = setup.table.interface->is_hard() && !setup.imperfection.empty();
    const bool may_start_unsoftened = !(on_hard_crests && (starts.waviness_has_rotated || starts.predicted));
    const auto is_predicted = [&](const ContactStart &start)
    { return starts.predicted && starts.predicted->motion == start.motion; };
    for (const bool softened : { false, true })
      for (std::size_t i = 0; i < starts.previous.size(); ++i)
        if (softened ? !on_hard_crests : may_start_unsoftened && !is_predicted(starts.previous[i]))
          attempts.emplace_back(
            [&, softened, i]
            {
              const ContactSolution solution =
                softened ? solve_softened(starts.previous[i]) : solve_from(starts.previous[i]);
              used = i;
              return solution;
            });
    if (starts.nearer_to_rest)
      attempts.emplace_back([&] { return solve_near(*starts.nearer_to_rest); });
    if (std::optional<ContactSolution> solution = first_stable(attempts))
      return *solution;
    if (std::optional<ContactSolution> solution = solve_cold())
      return *solution;
    const LinearConditions even = conditions.with_scaled_moment(body.contact_surface(), 0);
    ContactSolution solution =
      continue_in_moment(body, law, conditions, setup.profile.contact_radius, contact_control(),
                         stiffen(even, cold_start(even), small_stiffening));
    if (!is_stable(solution))
      throw ContactFailure(ContactOutcome::tipping,
                           "the only balance found is unstable: the glass tips. Lower "
                           "the centre of mass or the hand, or reduce the speed.");
    return solution;
  }

  std::optional<std::size_t> used;     ///< RevolutionContact::start_used
  std::vector<ContactIteration> steps; ///< RevolutionContact::history

private:
  using Attempts = std::vector<std::function<ContactSolution()>>;

  /// Start on a softened interface.
  struct SoftStart
  {
    ContactStart at;
    double softness = 1;         ///< factor >= 1
    Eigen::VectorXd forces = {}; ///< of the body [N]
  };

  /// Returns false if @p attempt fails. Throws ContactFailure if it finds that the glass tips.
  static bool succeeds(const std::function<void()> &attempt)
  {
    try
    {
      attempt();
      return true;
    }
    catch (const ContactFailure &failure)
    {
      if (failure.outcome == ContactOutcome::tipping)
        throw;
      return false;
    }
  }

  /// Returns the first stable solution of @p attempts, if any. A failed attempt leaves the body as it was.
  /// Throws like succeeds().
  std::optional<ContactSolution> first_stable(const Attempts &attempts)
  {
    const Eigen::VectorXd forces_before = body.forces().reshaped();
    for (const auto &attempt : attempts)
    {
      used.reset();
      ContactSolution solution;
      bool stable = false;
      if (succeeds([&] { stable = is_stable(solution = attempt()); }) && stable)
        return solution;
      body.set_forces(forces_before);
    }
    return std::nullopt;
  }

  /// Returns the stable solution from a cold start, if any. Throws like succeeds().
  std::optional<ContactSolution> solve_cold()
  {
    SoftStart cold;
    if (!succeeds([&] { cold = cold_start(conditions); }))
      return std::nullopt;
    Attempts attempts;
    for (const double largest_step : { large_stiffening, small_stiffening })
      attempts.emplace_back(
        [&, largest_step]
        {
          body.set_forces(cold.forces);
          return stiffen(conditions, cold, largest_step);
        });
    return first_stable(attempts);
  }

  /// Returns the stopping rule; steps are recorded in the history.
  ContactControl contact_control()
  {
    steps.clear();
    ContactControl control;
    control.tolerance = 1e-10;
    // With a stiff interface, rounding errors limit the residual to about this value.
    control.equilibrium_tolerance = 1e-8;
    control.requires_unchanged_set = false;
    control.progress = [this](const ContactIteration &step)
    {
      if (step.number <= 1) // first step of a new solve
        steps.clear();
      steps.push_back(step);
    };
    return control;
  }

  /// Calls solve_contact() from @p start, with an early stop if the residual stays large.
  ContactSolution solve_from(const ContactStart &start)
  {
    ContactControl control = contact_control();
    control.full_steps = true;
    control.max_steps = setup.imperfection.empty() ? 15 : 20;
    if (!setup.imperfection.empty())
      control.divergence_residual = 0.3;
    return solve_contact(body, law, conditions, setup.profile.contact_radius, control, &start);
  }

  /// Returns the solution from @p start and its forces, which belong to the same contact.
  ContactSolution solve_near(const ContactStart &start)
  {
    if (start.forces.size() > 0)
      body.set_forces(start.forces);
    return solve_from(start);
  }

  /// Returns the solution from @p start on a softened interface.
  ContactSolution solve_softened(const ContactStart &start)
  {
    const Eigen::VectorXd &gap = body.contact_surface().node_gap;
    const ContactStart softened = { start.motion,
                                    -gap + softening_of_start * (gap + start.normal_displacement) };
    return stiffen(conditions, { softened, softening_of_start }, softening_of_start, 10);
  }

  /// Presses the rigid foot under @p under on an interface that is soft enough for a wide band of contact,
  /// and then the elastic foot with the forces found. Throws ContactFailure.
  SoftStart cold_start(const LinearConditions &under)
  {
    const ContactSurface &surface = body.contact_surface();

    // The initial softness makes a rigid rim touch the table over a width that the mesh resolves well.
    const bool is_narrow = setup.table.interface->is_hard() && setup.profile.crown_radius > 0;
    const double half_width = is_narrow ? 4 * setup.contact_half_width : setup.profile.land_width / 4;
    // The depth exceeds the waviness, so the whole rim is in contact.
    const double depth =
      (setup.profile.crown_radius > 0 ? half_width * half_width / (2 * setup.profile.crown_radius)
                                      : 1e-3 * half_width) +
      2 * setup.imperfection.max_amplitude();
    const double pressure = setup.line_load(setup.normal_force) / (2 * half_width);
    double softness = std::max(1., interface.stiffness_at(pressure) * depth / pressure);
    std::shared_ptr<const InterfaceLaw> soft = interface.softened(softness);
    std::unique_ptr<TableLaw> soft_law = soft->make(surface, 0);
    const Eigen::Vector3d pressed_in(-surface.node_gap.minCoeff() - soft->penetration_at(4 * pressure), 0, 0);
    ContactStart at;
    at.motion = rigid_foot_motion(surface, *soft_law, under, setup.profile.contact_radius, pressed_in);
    at.normal_displacement = surface.motion_modes() * at.motion;

    // Under the table's forces on the rigid foot, the elastic foot moves mostly as a rigid body. This motion
    // is subtracted from the table motion, because at.normal_displacement is the sum of both.
    ContactForces rigid;
    soft_law->evaluate(at.normal_displacement, rigid);
    body.set_forces(rigid.forces);
    Eigen::Index most_loaded = 0;
    body.forces().rowwise().sum().maxCoeff(&most_loaded);
    at.motion -= body.motion_of_circle(most_loaded);
    return { at, softness, rigid.forces };
  }

  /// Returns the solution under @p under from @p start, whose interface is stiffened in few steps by factors
  /// of at most @p largest_step; @p divergence_residual as in ContactControl.
  ContactSolution stiffen(const LinearConditions &under, const SoftStart &start, double largest_step,
                          double divergence_residual = std::numeric_limits<double>::infinity())
  {
    ContactStart at = start.at;
    double softness = start.softness;
    const double radius = setup.profile.contact_radius;
    const ContactSurface &surface = body.contact_surface();
    std::unique_ptr<TableLaw> soft_law = interface.softened(softness)->make(surface, 0);
    ContactControl control = contact_control();
    control.tolerance = control.equilibrium_tolerance = 1e-3;
    control.max_steps = 30;
    control.divergence_residual = divergence_residual;
    while (softness > 1)
    {
      const ContactSolution solution = solve_contact(body, *soft_law, under, radius, control, &at);
      const double n_steps = std::ceil(std::log(softness) / std::log(largest_step));
      const double next = n_steps > 1 ? std::pow(softness, 1 - 1 / n_steps) : 1;
      // The penetrations are scaled with the softness to keep the pressure.
      at.motion = solution.motion;
      at.normal_displacement =
        -surface.node_gap + next / softness * (surface.node_gap + solution.normal_displacement);
      softness = next;
      soft_law = interface.softened(softness)->make(surface, 0);
      control.full_steps = true;
    }
    const bool full_steps = control.full_steps;
    control = contact_control();
    control.full_steps = full_steps;
    return solve_contact(body, law, under, radius, control, &at);
  }

  /// Returns whether @p solution is stable: a leaning glass may have a second, unstable balance, of negative
  /// stability margin. Completes the stability margin of a solution without steps.
  bool is_stable(ContactSolution &solution) const
  {
    // Below this value of 2 moment / (normal force * radius), the whole rim stays in contact.
    constexpr double moment_ratio_of_lift_off = 1;
    const ContactSurface &surface = body.contact_surface();
    const Eigen::Vector2d moment = surface.node_position.transpose() * solution.forces;
    if (conditions.motion_weights().isZero() || 2 * moment.norm() < moment_ratio_of_lift_off *
                                                                      conditions.normal_force() *
                                                                      setup.profile.contact_radius)
      return true;
    // An initial guess that converges without a step has no stability margin yet.
    if (solution.n_iterations == 0)
    {
      ContactForces contact;
      law.evaluate(solution.normal_displacement, contact);
      solution.stability_margin =
        body.solve(contact.tangent, contact.forces, conditions, solution.motion).stability_margin;
    }
    return solution.stability_margin > 0;
  }

  const RevolutionSetup &setup;
  const InterfaceLaw &interface;
  BodyOfRevolution &body;
  TableLaw &law;
  const LinearConditions &conditions;
};

} // namespace

RevolutionContact solve_revolution_contact(const RevolutionSetup &setup, const InterfaceLaw &interface,
                                           BodyOfRevolution &body, TableLaw &law,
                                           const LinearConditions &conditions,
                                           const RevolutionGuesses &starts)
{
  ContactSearch search(setup, interface, body, law, conditions);
  ContactSolution solution = search.solve(starts);
  return { std::move(solution), std::move(search.steps), search.used };
}

} // namespace stemware::fem
