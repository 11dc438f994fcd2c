#include "fem/revolution/path_of_moments.h"
#include "fem/revolution/revolution_foot.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace stemware::fem
{

namespace
{

/// Factors by which a cold start stiffens the interface at once: most contacts stand the first.
constexpr double large_stiffening = 1000, small_stiffening = 10;
/// Factor by which the interface is softened for a start from a contact that is not near enough.
constexpr double softening_of_start = 30;

ContactControl contact_control()
{
  ContactControl control;
  control.tolerance = 1e-10;
  control.equilibrium_tolerance = 1e-8; // the rounding of a stiff spring; most contacts end far below
  control.set_matters = false;
  return control;
}

} // namespace

std::array<double, 4> RevolutionFoot::Solved::numbers_of(const ContactDemand &demand)
{
  return { demand.normal_force, demand.moment_x, demand.moment_y, demand.tilt_moment };
}

void RevolutionFoot::remember(const ContactDemand &demand, const Slip &slip)
{
  constexpr std::size_t most = 24, newest = 8;
  const Solved now = { Solved::numbers_of(demand), slip.spin_per_speed, *before };
  recent.erase(std::remove_if(recent.begin(), recent.end(),
                              [&](const Solved &one)
                              { return one.demand == now.demand && one.spin == now.spin; }),
               recent.end());
  recent.push_back(now);
  if (recent.size() <= most)
    return;
  // Of the older ones, that goes which has the nearest neighbour: the others go on to cover the spins.
  const auto room = [&](const Solved &one)
  {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Solved &other : recent)
      if (&other != &one)
        nearest = std::min(nearest, std::abs(other.spin - one.spin));
    return nearest;
  };
  recent.erase(std::min_element(recent.begin(), recent.end() - newest,
                                [&](const Solved &one, const Solved &other)
                                { return room(one) < room(other); }));
}

std::optional<ContactStart> RevolutionFoot::between(std::vector<const Solved *> points, double spin,
                                                    std::size_t n_least)
{
  constexpr std::size_t most_points = 4;
  constexpr double largest_sum = 8; // of the weights: beyond, it is no neighbour
  std::sort(points.begin(), points.end(),
            [&](const Solved *one, const Solved *other)
            { return std::abs(one->spin - spin) < std::abs(other->spin - spin); });
  for (std::size_t n = std::min(points.size(), most_points); n >= n_least; --n)
  {
    Eigen::VectorXd spins(n);
    for (std::size_t i = 0; i < n; ++i)
      spins(static_cast<Eigen::Index>(i)) = points[i]->spin;
    const Eigen::VectorXd weights = lagrange_values(spins, spin);
    if (!(weights.lpNorm<1>() <= largest_sum))
      continue;
    ContactStart start = { Eigen::Vector3d::Zero(),
                           Eigen::VectorXd::Zero(points.front()->start.normal_displacement.size()) };
    for (std::size_t i = 0; i < n; ++i)
    {
      start.motion += weights(static_cast<Eigen::Index>(i)) * points[i]->start.motion;
      start.normal_displacement +=
        weights(static_cast<Eigen::Index>(i)) * points[i]->start.normal_displacement;
    }
    return start;
  }
  return std::nullopt;
}

std::optional<ContactStart> RevolutionFoot::predict(const ContactDemand &demand, const Slip &slip) const
{
  const std::array<double, 4> asked = Solved::numbers_of(demand);
  const double spin = slip.spin_per_speed;
  std::vector<const Solved *> same_demand, similar;
  for (const Solved &one : recent)
    if (one.demand == asked)
      same_demand.push_back(&one);
  if (const auto start = between(same_demand, spin, 2))
    return start;
  for (const Solved &one : of_similar)
    similar.push_back(&one);
  const std::optional<ContactStart> start = between(similar, spin, 1);
  if (start || recent.empty())
    return start;
  const double radius = setup.profile.contact_radius;
  const auto distance = [&](const Solved &one)
  {
    double sum = radius * std::abs(one.spin - spin);
    for (std::size_t i = 0; i < asked.size(); ++i)
      sum += std::abs(one.demand[i] - asked[i]) / (asked[0] * (i == 0 ? 1 : radius));
    return sum;
  };
  // Of equally near ones the newest.
  return std::min_element(recent.rbegin(), recent.rend(),
                          [&](const Solved &one, const Solved &other)
                          { return distance(one) < distance(other); })
    ->start;
}

ContactStart RevolutionFoot::on_own_nodes(const ContactStart &one, const RevolutionFoot &other) const
{
  const Eigen::VectorXd &from = other.elastic_body().contact_compliance().radii;
  const Eigen::VectorXd &to = elastic_body().contact_compliance().radii;
  const Eigen::Index n_from = other.setup.n_lines, n_to = setup.n_lines;
  Eigen::MatrixXd in_r(to.size(), from.size());
  for (Eigen::Index i = 0; i < to.size(); ++i)
    in_r.row(i) =
      other.elastic_body().contact_compliance().shape_at(std::clamp(to(i), from(0), from(from.size() - 1)));
  // A penetration counts by the pressure that it makes, which the interface of the one has at another depth.
  const double pressure = setup.line_load(setup.normal_force) / setup.profile.land_width;
  const double softer = other.interface->stiffness_at(pressure) / interface->stiffness_at(pressure);
  const auto scaled = [&](double separation) { return separation < 0 ? softer * separation : separation; };
  const Eigen::VectorXd separation =
    (other.elastic_body().contact_surface().node_gap + one.normal_displacement).unaryExpr(scaled);
  const Eigen::MatrixXd on_lines = in_r * separation.reshaped(from.size(), n_from);
  Eigen::MatrixXd result(to.size(), n_to);
  for (Eigen::Index j = 0; j < n_to; ++j)
  {
    const double place = static_cast<double>(j) / static_cast<double>(n_to) * static_cast<double>(n_from);
    const auto line = static_cast<Eigen::Index>(place);
    const double share = place - static_cast<double>(line);
    result.col(j) = (1 - share) * on_lines.col(line) + share * on_lines.col((line + 1) % n_from);
  }
  return { one.motion, result.reshaped() - elastic_body().contact_surface().node_gap };
}

void RevolutionFoot::start_like(const Foot &similar)
{
  const auto *other = dynamic_cast<const RevolutionFoot *>(&similar);
  of_similar.clear();
  if (!other || !setup.imperfection.empty() || !other->setup.imperfection.empty())
    return;
  // Contacts of other widths lead nowhere.
  if (setup.table.interface->is_hard() != other->setup.table.interface->is_hard() ||
      setup.plane_strain_compliance() != other->setup.plane_strain_compliance())
    return;
  constexpr double apart = 1e-5; // of the largest spin: two solutions at one spin have no polynomial
  double largest = 0;
  for (const Solved &one : other->recent)
    largest = std::max(largest, std::abs(one.spin));
  for (auto one = other->recent.rbegin(); one != other->recent.rend(); ++one)
    if (std::none_of(of_similar.begin(), of_similar.end(),
                     [&](const Solved &known) { return std::abs(known.spin - one->spin) < apart * largest; }))
      of_similar.push_back({ one->demand, one->spin, on_own_nodes(one->start, *other) });
}

ContactSolution RevolutionFoot::press(const ContactDemand &demand, const Slip &slip)
{
  const auto press_zone = [&]
  {
    if (setup.friction_coefficient > 0)
      zones.back()->body.set_sliding(
        SlidingTraction{ setup.friction_coefficient, slip.spin_per_speed, axis(), setup.friction_by_slip });
    return solve_from_before(demand, slip);
  };
  const ContactSolution solution = press_zone();
  if (!has_left_zone())
    return solution;
  add_zone(0);
  return press_zone();
}

ContactSolution RevolutionFoot::solve_cold(const LinearConditions &conditions, double largest_step)
{
  const double radius = setup.profile.contact_radius;
  BodyOfRevolution &body = zones.back()->body;
  const ContactSurface &surface = body.contact_surface();

  // So soft that a rigid rim is pressed in on a band that the mesh resolves well.
  const bool is_narrow = setup.table.interface->is_hard() && setup.profile.crown_radius > 0;
  const double half_width = is_narrow ? 4 * setup.contact_half_width : setup.profile.land_width / 4;
  // Beyond the waviness, so that the rim carries all round.
  const double depth =
    (setup.profile.crown_radius > 0 ? half_width * half_width / (2 * setup.profile.crown_radius)
                                    : 1e-3 * half_width) +
    2 * setup.imperfection.largest_amplitude();
  const double pressure = setup.line_load(setup.normal_force) / (2 * half_width);
  double softness = std::max(1., interface->stiffness_at(pressure) * depth / pressure);
  std::shared_ptr<const InterfaceLaw> soft = interface->softened(softness);
  std::unique_ptr<TableLaw> soft_law = soft->make(surface, 0);
  const Eigen::Vector3d pressed_in(-surface.node_gap.minCoeff() - soft->penetration_at(4 * pressure), 0, 0);
  ContactStart at;
  at.motion = rigid_foot_motion(surface, *soft_law, conditions, radius, pressed_in);
  at.normal_displacement = surface.motion_modes() * at.motion;

  // The displacement under a rigid foot's forces is for the most part a motion, which the table follows.
  ContactForces rigid;
  soft_law->evaluate(at.normal_displacement, rigid);
  body.set_forces(rigid.forces);
  Eigen::Index most_loaded = 0;
  body.forces().rowwise().sum().maxCoeff(&most_loaded);
  at.motion -= body.motion_of_circle(most_loaded);
  return stiffen(conditions, softness, at, largest_step);
}

ContactSolution RevolutionFoot::stiffen(const LinearConditions &conditions, double softness, ContactStart at,
                                        double largest_step, double hopeless_residual)
{
  const double radius = setup.profile.contact_radius;
  BodyOfRevolution &body = zones.back()->body;
  const ContactSurface &surface = body.contact_surface();
  std::unique_ptr<TableLaw> soft_law = interface->softened(softness)->make(surface, 0);
  ContactControl control = contact_control();
  control.tolerance = control.equilibrium_tolerance = 1e-3;
  control.max_steps = 30;
  control.hopeless_residual = hopeless_residual;
  while (softness > 1)
  {
    const ContactSolution solution = solve_contact(body, *soft_law, conditions, radius, control, &at);
    const double n_steps = std::ceil(std::log(softness) / std::log(largest_step));
    const double next = n_steps > 1 ? std::pow(softness, 1 - 1 / n_steps) : 1;
    // Penetrations that shrink with the law's softness leave the pressure what it is.
    at.motion = solution.motion;
    at.normal_displacement =
      -surface.node_gap + next / softness * (surface.node_gap + solution.normal_displacement);
    softness = next;
    soft_law = interface->softened(softness)->make(surface, 0);
    control.whole_steps = true;
  }
  const bool whole_steps = control.whole_steps;
  control = contact_control();
  control.whole_steps = whole_steps;
  return solve_contact(body, *zones.back()->law, conditions, radius, control, &at);
}

ContactSolution RevolutionFoot::solve_near(const LinearConditions &conditions, const ContactStart &start)
{
  ContactControl control = contact_control();
  control.whole_steps = true;
  control.max_steps = setup.imperfection.empty() ? 15 : 20;
  if (!setup.imperfection.empty())
    control.hopeless_residual = 0.3;
  Zone &zone = *zones.back();
  return solve_contact(zone.body, *zone.law, conditions, setup.profile.contact_radius, control, &start);
}

ContactSolution RevolutionFoot::solve_softened(const LinearConditions &conditions, const ContactStart &start)
{
  const Eigen::VectorXd &gap = zones.back()->body.contact_surface().node_gap;
  return stiffen(conditions, softening_of_start,
                 { start.motion, -gap + softening_of_start * (gap + start.normal_displacement) },
                 softening_of_start, 10);
}

bool RevolutionFoot::is_stable(const LinearConditions &conditions, const ContactSolution &solution)
{
  // A rim that carries all round resists every motion as it does an upright glass.
  constexpr double moment_ratio_of_lift_off = 1;
  const Zone &zone = *zones.back();
  const ContactSurface &surface = zone.body.contact_surface();
  const Eigen::Vector2d moment = surface.node_position.transpose() * solution.forces;
  if (conditions.motion_weights().isZero() ||
      2 * moment.norm() < moment_ratio_of_lift_off * conditions.normal_force() * setup.profile.contact_radius)
    return true;
  ContactForces contact;
  zone.law->evaluate(solution.normal_displacement, contact);
  const LinearConditions without_weight(surface, conditions.weights(), conditions.target());
  try
  {
    return zone.body.motions_for_residuals(contact.tangent, conditions).determinant() *
             zone.body.motions_for_residuals(contact.tangent, without_weight).determinant() >
           0;
  }
  catch (const ContactFailure &) // singular: where the two balances meet
  {
    return false;
  }
}

ContactSolution RevolutionFoot::solve_from_before(const ContactDemand &demand, const Slip &slip)
{
  Zone &zone = *zones.back();
  const LinearConditions conditions =
    conditions_of(zone.body.contact_surface(), axis() == 0 ? demand : demand.in_axes_turned_by(axis()));
  const std::optional<ContactStart> predicted = predict(demand, slip);
  std::vector<ContactStart> starts;
  if (before)
    starts.push_back(*before);
  if (before && turned)
    starts.insert(goes_with_crests ? starts.begin() : starts.end(), *turned);
  const Eigen::VectorXd forces_before = zone.body.forces().reshaped();
  before.reset();

  std::vector<std::function<ContactSolution()>> ways;
  if (predicted)
    ways.push_back([&] { return solve_near(conditions, *predicted); });
  // On hard crests a second start that is no nearer than the first fails like that one.
  const bool on_hard_crests = setup.table.interface->is_hard() && !setup.imperfection.empty();
  const bool may_be_near = !(on_hard_crests && (crests_have_moved || predicted));
  for (const bool softened : { false, true })
    for (std::size_t i = 0; i < starts.size(); ++i)
      if (softened || may_be_near)
        ways.push_back(
          [&, softened, i]
          {
            const ContactSolution solution =
              softened ? solve_softened(conditions, starts[i]) : solve_near(conditions, starts[i]);
            goes_with_crests = goes_with_crests != (i > 0);
            return solution;
          });
  for (const double largest_step : { large_stiffening, small_stiffening })
    ways.push_back([&, largest_step] { return solve_cold(conditions, largest_step); });
  for (const auto &way : ways)
    try
    {
      const ContactSolution solution = way();
      if (is_stable(conditions, solution))
        return solution;
      zone.body.set_forces(forces_before);
    }
    catch (const ContactFailure &failure)
    {
      if (failure.outcome == ContactOutcome::tipping)
        throw;
      zone.body.set_forces(forces_before);
    }
  const LinearConditions even = conditions.with_share_of_moment(zone.body.contact_surface(), 0);
  return solve_along_moment(zone.body, *zone.law, conditions, setup.profile.contact_radius, contact_control(),
                            solve_cold(even, small_stiffening));
}

} // namespace stemware::fem
