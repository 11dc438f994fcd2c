#include "fem/revolution/revolution_foot.h"

#include "ring_model/load/constants.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace stemware::fem
{

namespace
{

/// Returns the table motions @p motion in axes that are rotated counter-clockwise by @p angle [rad].
Eigen::Vector3d motion_in_axes(const Eigen::Vector3d &motion, double angle)
{
  const Eigen::Vector2d tilts = Eigen::Rotation2Dd(-angle) * motion.tail<2>();
  return { motion(0), tilts(0), tilts(1) };
}

} // namespace

RevolutionFoot::Zone::Zone(const RevolutionFoot &foot, ContactCompliance compliance)
    : body(std::move(compliance), foot.gap_at({}), foot.setup.n_lines)
    , law(foot.interface->make(body.contact_surface(), 0))
{
}

std::pair<Eigen::Index, Eigen::Index> RevolutionFoot::Zone::loaded_circles() const
{
  const Eigen::VectorXd forces = body.forces().cwiseAbs().rowwise().maxCoeff();
  const double threshold = 1e-9 * forces.maxCoeff();
  Eigen::Index first = 0, last = forces.size() - 1;
  while (first < last && forces(first) <= threshold)
    ++first;
  while (first < last && forces(last) <= threshold)
    --last;
  return { first, last };
}

RevolutionFoot::RevolutionFoot(const RevolutionSetup &setup,
                               std::shared_ptr<const ContactCompliance> compliance)
    : setup(setup)
    , compliance(std::move(compliance))
    , interface(setup.interface())
{
  setup.imperfection.validate();
  const MeridianOptions narrow = this->setup.meridian_of_zone();
  const auto [first, size] = nodes_between(this->compliance->radii, this->compliance->degree,
                                           narrow.inner_radius, narrow.outer_radius);
  zones.front() = std::make_unique<Zone>(*this, this->compliance->part(first, size));
}

RevolutionFoot::RevolutionFoot(const RevolutionFoot &other)
    : setup(other.setup)
    , compliance(other.compliance)
    , interface(other.interface)
{
  const Zone &zone = *other.zones.front();
  // With waviness the gap depends on the orientation, so the clone needs its own body.
  zones.front() = setup.imperfection.empty() ? std::make_unique<Zone>(zone)
                                             : std::make_unique<Zone>(*this, zone.body.contact_compliance());
}

std::shared_ptr<const Foot> RevolutionFoot::clone() const
{
  return std::make_shared<RevolutionFoot>(*this);
}

std::shared_ptr<const ContactCompliance> RevolutionFoot::whole_land_compliance() const
{
  if (compliance->n_inside > 0 || compliance->n_outside > 0)
    throw std::out_of_range("The contact leaves the part of the land whose compliances are known.");
  return compliance;
}

RevolutionFoot::Zone &RevolutionFoot::zone_at(unsigned int index, const ring::Orientation &marks) const
{
  if (!zones[index])
    zones[index] = std::make_unique<Zone>(*this, *whole_land_compliance());
  Zone &zone = *zones[index];
  const bool has_turned = marks.glass != zone.marks.glass || marks.table != zone.marks.table;
  if (has_turned && !setup.imperfection.empty())
  {
    zone.body.set_gap(gap_at(marks));
    zone.marks = marks;
  }
  return zone;
}

RevolutionFoot::Zone &RevolutionFoot::zone_of(const ContactState &state) const
{
  Zone &zone = zone_at(state.zone, state.slip.orientation);
  if (setup.friction_coefficient > 0)
    zone.body.set_sliding(sliding_at(state.slip));
  zone.body.set_forces(state.solution.forces);
  return zone;
}

BodyOfRevolution::Gap RevolutionFoot::gap_at(const ring::Orientation &marks) const
{
  return [this, marks, first = axis(marks)](double radius, double azimuth)
  {
    return setup.profile.gap(radius) + setup.imperfection.gap(radius / setup.profile.contact_radius,
                                                              azimuth + first, marks.glass, marks.table);
  };
}

SlidingTraction RevolutionFoot::sliding_at(const ring::Slip &slip) const
{
  return { setup.friction_coefficient, slip.spin_per_speed, axis(slip.orientation), setup.friction_by_slip };
}

FootDescription RevolutionFoot::description() const
{
  FootDescription description;
  description.body = "revolution";
  description.n_unknowns = elastic_body().n_unknowns();
  description.n_contact_nodes = elastic_body().contact_surface().n_nodes();
  return description;
}

FootCapabilities RevolutionFoot::capabilities() const
{
  FootCapabilities capabilities;
  capabilities.friction_deforms = setup.friction_coefficient > 0;
  return capabilities;
}

RevolutionGuesses RevolutionFoot::starts_from(const ContactGuess &guess, const ring::Orientation &marks) const
{
  RevolutionGuesses starts;
  const auto in_axes_of_lines = [&](std::optional<ContactStart> start)
  {
    if (start)
      start->motion = motion_in_axes(start->motion, axis(marks));
    return start;
  };
  starts.predicted = in_axes_of_lines(guess.predicted);
  starts.nearer_to_rest = in_axes_of_lines(guess.nearer_to_rest);
  if (!guess.previous)
    return starts;
  const ContactState &before = *guess.previous;
  const ring::Orientation &marks_before = before.slip.orientation;
  ContactStart start = { motion_in_axes(before.solution.motion, axis(marks_before)),
                         before.solution.normal_displacement };
  starts.waviness_has_rotated = marks.glass != marks_before.glass || marks.table != marks_before.table;
  if (setup.imperfection.empty() || !starts.waviness_has_rotated)
  {
    starts.previous = { start };
    return starts;
  }
  const Eigen::VectorXd gap_before = zone_at(before.zone, marks_before).body.contact_surface().node_gap;
  const Eigen::VectorXd &gap_now = zone_at(before.zone, marks).body.contact_surface().node_gap;
  const Eigen::VectorXd penetration = -(gap_before + start.normal_displacement);
  start.normal_displacement = -(gap_now + penetration);
  starts.previous = { start };
  if (const long n_turned = crest_line(marks) - crest_line(marks_before); n_turned != 0)
  {
    start.normal_displacement = -(gap_now + rotated_by_lines(penetration, n_turned));
    start.motion = motion_in_axes(start.motion, -static_cast<double>(n_turned) * line_spacing());
    starts.previous.insert(
      before.start_rotated_with_waviness ? starts.previous.begin() : starts.previous.end(), start);
  }
  return starts;
}

double RevolutionFoot::line_spacing() const
{
  return 2 * ring::pi / setup.n_lines;
}

double RevolutionFoot::crest(const ring::Orientation &marks) const
{
  if (setup.imperfection.empty())
    return 0;
  return setup.imperfection.glass.empty() ? marks.table : marks.glass;
}

long RevolutionFoot::crest_line(const ring::Orientation &marks) const
{
  return std::lround(crest(marks) / line_spacing());
}

double RevolutionFoot::axis(const ring::Orientation &marks) const
{
  return crest(marks) - static_cast<double>(crest_line(marks)) * line_spacing();
}

Eigen::VectorXd RevolutionFoot::rotated_by_lines(const Eigen::VectorXd &nodal, long n) const
{
  const Eigen::Index n_lines = setup.n_lines, n_radii = nodal.size() / n_lines, shift = n % n_lines;
  Eigen::MatrixXd result(n_radii, n_lines);
  for (Eigen::Index j = 0; j < n_lines; ++j)
    result.col((j + shift + n_lines) % n_lines) = nodal.segment(j * n_radii, n_radii);
  return result.reshaped();
}

unsigned int RevolutionFoot::n_resolved_harmonics() const
{
  return (setup.n_lines - 1) / 2;
}

ContactState RevolutionFoot::solve(const ContactDemand &demand, const ring::Slip &slip,
                                   const ContactGuess &guess,
                                   const std::function<void(const ContactIteration &)> &) const
{
  ContactState state;
  state.demand = demand;
  state.slip = slip;
  state.zone = guess.previous ? guess.previous->zone : 0;
  press(guess, state);
  auto circles = zones[state.zone]->loaded_circles();
  if (const ContactCompliance &part = zones[state.zone]->body.contact_compliance();
      (part.n_inside > 0 && circles.first == 0) ||
      (part.n_outside > 0 && circles.second == part.radii.size() - 1))
  {
    state.zone = 1;
    press({}, state);
    circles = zones[state.zone]->loaded_circles();
  }
  state.solution.motion = motion_in_axes(state.solution.motion, -axis(slip.orientation));
  state.load = project_onto_rings(state, demand.ring_radii, demand.n_harmonics);
  const Eigen::VectorXd &radii = zones[state.zone]->body.contact_compliance().radii;
  state.inner_radius = radii(circles.first);
  state.outer_radius = radii(circles.second);
  return state;
}

void RevolutionFoot::press(const ContactGuess &guess, ContactState &state) const
{
  const ring::Orientation &marks = state.slip.orientation;
  const double first = axis(marks);
  const RevolutionGuesses starts = starts_from(guess, marks);
  Zone &zone = zone_at(state.zone, marks);
  if (setup.friction_coefficient > 0)
    zone.body.set_sliding(sliding_at(state.slip));
  if (guess.previous)
    zone.body.set_forces(guess.previous->solution.forces);
  else
    zone.body.reset();
  const LinearConditions conditions = conditions_of(
    zone.body.contact_surface(), first == 0 ? state.demand : state.demand.in_rotated_axes(first));
  RevolutionContact contact =
    solve_revolution_contact(setup, *interface, zone.body, *zone.law, conditions, starts);
  state.solution = std::move(contact.solution);
  state.history = std::move(contact.history);
  state.start_rotated_with_waviness =
    guess.previous && guess.previous->start_rotated_with_waviness != (contact.start_used.value_or(0) > 0);
}

std::optional<ContactStart> RevolutionFoot::predict_from(const ContactStart &start, unsigned int zone,
                                                         const Foot &similar) const
{
  const auto *other = dynamic_cast<const RevolutionFoot *>(&similar);
  // Waviness, a hard instead of a soft interface, or another compliance changes the contact width too much
  // for a prediction.
  if (!other || !setup.imperfection.empty() || !other->setup.imperfection.empty() ||
      setup.table.interface->is_hard() != other->setup.table.interface->is_hard() ||
      setup.plane_strain_compliance() != other->setup.plane_strain_compliance())
    return std::nullopt;
  const BodyOfRevolution &body = elastic_body(), &others = other->zones[zone]->body;
  const Eigen::VectorXd &from = others.contact_compliance().radii;
  const Eigen::VectorXd &to = body.contact_compliance().radii;
  const Eigen::Index n_from = other->setup.n_lines, n_to = setup.n_lines;
  Eigen::MatrixXd in_r(to.size(), from.size());
  for (Eigen::Index i = 0; i < to.size(); ++i)
    in_r.row(i) = others.contact_compliance().shape_at(std::clamp(to(i), from(0), from(from.size() - 1)));
  // The penetrations are scaled so that both interfaces have the same pressure.
  const double pressure = setup.line_load(setup.normal_force) / setup.profile.land_width;
  const double softer = other->interface->stiffness_at(pressure) / interface->stiffness_at(pressure);
  const auto scaled = [&](double separation) { return separation < 0 ? softer * separation : separation; };
  const Eigen::VectorXd separation =
    (others.contact_surface().node_gap + start.normal_displacement).unaryExpr(scaled);
  const Eigen::MatrixXd on_lines = in_r * separation.reshaped(from.size(), n_from);
  Eigen::MatrixXd result(to.size(), n_to);
  for (Eigen::Index j = 0; j < n_to; ++j)
  {
    const double place = static_cast<double>(j) / static_cast<double>(n_to) * static_cast<double>(n_from);
    const auto line = static_cast<Eigen::Index>(place);
    const double share = place - static_cast<double>(line);
    result.col(j) = (1 - share) * on_lines.col(line) + share * on_lines.col((line + 1) % n_from);
  }
  return ContactStart{ start.motion, result.reshaped() - body.contact_surface().node_gap };
}

ContactLoad RevolutionFoot::project_onto_rings(const ContactState &state,
                                               const std::vector<double> &ring_radii,
                                               unsigned int n_harmonics) const
{
  const TableLaw &law = *zone_at(state.zone, state.slip.orientation).law;
  return extract_load(law, state.solution, kept_harmonics(n_harmonics), ring_radii)
    .rotated(axis(state.slip.orientation));
}

std::vector<PointForce> RevolutionFoot::point_forces(const ContactState &state) const
{
  const TableLaw &law = *zone_at(state.zone, state.slip.orientation).law;
  return rotated_by(law.load(state.solution, 1).points, axis(state.slip.orientation));
}

PressureMap RevolutionFoot::pressure_map(const ContactState &state) const
{
  const double first = axis(state.slip.orientation);
  PressureMap map = zone_at(state.zone, state.slip.orientation).law->pressure_map(state.solution);
  return first == 0 ? map : map.rotated(first);
}

} // namespace stemware::fem
