#include "fem/pipeline/coupling/elastic_foot.h"

#include "ring_model/load/constants.h"
#include "ring_model/load/lagrange.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace stemware::pipeline
{

namespace
{

Eigen::Vector4d numbers_of(const fem::ContactDemand &demand)
{
  return { demand.normal_force, demand.moment_x, demand.moment_y, demand.tilt_moment };
}

bool same_marks(const ring::Slip &one, const ring::Slip &other)
{
  return one.orientation.glass == other.orientation.glass && one.orientation.table == other.orientation.table;
}

} // namespace

ContactPath::Found::Found(const fem::ContactState &state)
    : demand(numbers_of(state.demand))
    , slip(state.slip)
    , zone(state.zone)
    , start{ state.solution.motion, state.solution.normal_displacement, 0, 0, state.solution.forces }
{
}

void ContactPath::append(const fem::ContactState &state)
{
  constexpr std::size_t most = 24, newest = 8;
  last = state;
  const Found now(state);
  recent.erase(std::remove_if(recent.begin(), recent.end(),
                              [&](const Found &one)
                              {
                                return !same_marks(one.slip, now.slip) || one.zone != now.zone ||
                                       (one.demand == now.demand &&
                                        one.slip.spin_per_speed == now.slip.spin_per_speed);
                              }),
               recent.end());
  recent.push_back(now);
  if (recent.size() <= most)
    return;
  // Among the older solutions, the solution with the smallest spin difference from another solution is
  // removed, so that the remaining solutions cover the range of spins.
  const auto room = [&](const Found &one)
  {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Found &other : recent)
      if (&other != &one)
        nearest = std::min(nearest, std::abs(other.slip.spin_per_speed - one.slip.spin_per_speed));
    return nearest;
  };
  recent.erase(std::min_element(recent.begin(), recent.end() - newest,
                                [&](const Found &one, const Found &other)
                                { return room(one) < room(other); }));
}

std::optional<fem::ContactStart> ContactPath::between(std::vector<const Found *> points, double spin,
                                                      std::size_t n_least)
{
  constexpr std::size_t max_points = 4;
  constexpr double largest_sum = 8; // maximum of sum |weight|, which grows with the extrapolation distance
  std::sort(points.begin(), points.end(),
            [&](const Found *one, const Found *other) {
              return std::abs(one->slip.spin_per_speed - spin) < std::abs(other->slip.spin_per_speed - spin);
            });
  for (std::size_t n = std::min(points.size(), max_points); n >= n_least; --n)
  {
    fem::ContactStart start = { Eigen::Vector3d::Zero(),
                                Eigen::VectorXd::Zero(points.front()->start.normal_displacement.size()), 0, 0,
                                Eigen::VectorXd::Zero(points.front()->start.forces.size()) };
    Eigen::VectorXd spins(n);
    for (std::size_t i = 0; i < n; ++i)
      spins(i) = points[i]->slip.spin_per_speed;
    const Eigen::VectorXd weights = ring::lagrange_values(spins, spin);
    for (std::size_t i = 0; i < n; ++i)
    {
      start.motion += weights(i) * points[i]->start.motion;
      start.normal_displacement += weights(i) * points[i]->start.normal_displacement;
      start.forces += weights(i) * points[i]->start.forces;
    }
    if (weights.lpNorm<1>() <= largest_sum)
      return start;
  }
  return std::nullopt;
}

std::optional<fem::ContactStart> ContactPath::expected(const std::vector<const Found *> &own,
                                                       const ring::Slip &slip) const
{
  const double spin = slip.spin_per_speed;
  std::vector<const Found *> similar, similar_at_marks;
  for (const Found &one : from_similar_foot)
  {
    similar.push_back(&one);
    if (same_marks(one.slip, slip))
      similar_at_marks.push_back(&one);
  }
  const auto distance = [spin](const std::vector<const Found *> &points)
  {
    double least = std::numeric_limits<double>::infinity();
    for (const Found *one : points)
      least = std::min(least, std::abs(one->slip.spin_per_speed - spin));
    return least;
  };
  // At equal distance, solutions of this foot predict better than solutions of the similar foot. The similar
  // foot is preferred only if its solutions are closer to @p spin by more than a tenth of @p spin.
  const bool own_are_far = distance(similar_at_marks) + 0.1 * std::abs(spin) < distance(own);
  const std::optional<fem::ContactStart> start = own_are_far ? std::nullopt : between(own, spin, 2);
  return start ? start : between(own_are_far ? similar_at_marks : similar, spin, 1);
}

fem::ContactGuess ContactPath::guess(const fem::ContactDemand &demand, const ring::Slip &slip,
                                     const fem::ContactState *before) const
{
  fem::ContactGuess guess = { before ? before : last ? &*last : nullptr };
  const unsigned int zone = guess.previous ? guess.previous->zone : 0;
  guess.nearer_to_rest = nearest_towards_rest(slip, zone);
  const Eigen::Vector4d asked = numbers_of(demand);
  std::vector<const Found *> known, same_demand;
  for (const Found &one : recent)
    if (same_marks(one.slip, slip) && one.zone == zone)
      known.push_back(&one);
  for (const Found *one : known)
    if (one->demand == asked || one->slip.spin_per_speed == 0)
      same_demand.push_back(one);
  guess.predicted = zone == 0 ? expected(same_demand, slip) : between(same_demand, slip.spin_per_speed, 2);
  if (guess.predicted || known.empty())
    return guess;
  const double radius = last->load.mean_radius;
  const auto distance = [&](const Found *one)
  {
    const Eigen::Vector4d difference = (one->demand - asked).cwiseAbs() / asked(0);
    return radius * std::abs(one->slip.spin_per_speed - slip.spin_per_speed) + difference(0) +
           difference.tail<3>().sum() / radius;
  };
  // Reverse order: among equally near solutions, the newest one is used.
  guess.predicted =
    (*std::min_element(known.rbegin(), known.rend(),
                       [&](const Found *one, const Found *other) { return distance(one) < distance(other); }))
      ->start;
  return guess;
}

std::optional<fem::ContactStart> ContactPath::nearest_towards_rest(const ring::Slip &slip,
                                                                   unsigned int zone) const
{
  const double spin = slip.spin_per_speed;
  const Found *nearest = nullptr;
  for (const Found &one : recent)
    if (const double share = one.slip.spin_per_speed / spin;
        share >= 0 && share < 1 && one.zone == zone && same_marks(one.slip, slip) &&
        (!nearest || share > nearest->slip.spin_per_speed / spin))
      nearest = &one;
  return nearest ? std::optional(nearest->start) : std::nullopt;
}

void ContactPath::predict_from_similar(const ContactPath &similar, const fem::Foot &own,
                                       const fem::Foot &other)
{
  // Minimum relative difference of two spins. A polynomial must not pass through two solutions at one spin.
  constexpr double apart = 1e-5;
  double largest = 0;
  for (const Found &one : similar.recent)
    largest = std::max(largest, std::abs(one.slip.spin_per_speed));
  for (auto one = similar.recent.rbegin(); one != similar.recent.rend(); ++one)
  {
    const auto is_near = [&](const Found &known)
    { return std::abs(known.slip.spin_per_speed - one->slip.spin_per_speed) < apart * largest; };
    if (std::any_of(from_similar_foot.begin(), from_similar_foot.end(), is_near))
      continue;
    const std::optional<fem::ContactStart> start = own.predict_from(one->start, one->zone, other);
    if (!start)
      return;
    from_similar_foot.push_back(*one);
    from_similar_foot.back().start = *start;
  }
}

ElasticFoot::ElasticFoot(std::shared_ptr<const fem::Foot> foot_given, FootSpecification specification)
    : foot(std::move(foot_given))
    , made_from(std::move(specification))
    , highest(foot->n_resolved_harmonics())
{
}

void ElasticFoot::set_rings(std::vector<double> new_radii, unsigned int n_harmonics)
{
  radii = std::move(new_radii);
  placed = true;
  highest = std::min(n_harmonics, foot->n_resolved_harmonics());
}

void ElasticFoot::reset_rings()
{
  set_rings({}, foot->n_resolved_harmonics());
  placed = false;
}

std::shared_ptr<ElasticFoot> ElasticFoot::clone(Study study) const
{
  const auto twin = std::make_shared<ElasticFoot>(*this);
  twin->made_from.study = std::move(study);
  if (std::shared_ptr<const fem::Foot> body = foot->clone())
    twin->foot = std::move(body);
  return twin;
}

void ElasticFoot::predict_from_similar(const ElasticFoot &similar)
{
  path.predict_from_similar(similar.path, *foot, *similar.foot);
}

fem::ContactState ElasticFoot::solve(fem::ContactDemand demand, const ring::Slip &slip, Progress &progress,
                                     const fem::ContactState *before)
{
  if (!demand.has_friction()) // a demand with friction already has rings
    demand.ring_radii = radii;
  demand.n_harmonics = highest;
  fem::ContactState state =
    foot->solve(demand, slip, path.guess(demand, slip, before),
                [&progress](const fem::ContactIteration &step) { progress.iteration(step); });
  path.append(state);
  return state;
}

fem::ContactState ElasticFoot::solve_at_rest(const fem::ContactDemand &demand, const ring::Orientation &marks,
                                             Progress &progress)
{
  const ring::Slip slip = { 0, marks };
  if (at_rest && numbers_of(demand) == numbers_of(at_rest->demand) && same_marks(slip, at_rest->slip))
    at_rest->load = project_onto_rings(*at_rest); // the rings may have changed since the last call
  else
    at_rest = solve(demand, slip, progress);
  return *at_rest;
}

std::shared_ptr<ElasticFoot> study_foot(const FootSpecification &specification, const FootMaker &make_foot,
                                        Progress &progress, const ElasticFoot *similar)
{
  if (!specification.study.load.is_from_contact())
    return nullptr;
  auto foot = std::make_shared<ElasticFoot>(make_foot(specification, similar ? &similar->body() : nullptr),
                                            specification);
  if (similar)
    foot->predict_from_similar(*similar);
  progress.stage_done("mesh_and_stiffness");
  return foot;
}

std::vector<double> chebyshev_radii(double inner, double outer, unsigned int n_rings)
{
  std::vector<double> radii;
  for (unsigned int j = 0; j < n_rings; ++j)
    radii.push_back((inner + outer) / 2 -
                    (outer - inner) / 2 * std::cos(ring::pi * (2 * j + 1) / (2. * n_rings)));
  return radii;
}

} // namespace stemware::pipeline
