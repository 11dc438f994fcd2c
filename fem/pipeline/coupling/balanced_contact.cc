#include "fem/pipeline/coupling/balanced_contact.h"

#include "fem/pipeline/base/numbers.h"
#include "ring_model/failures.h"
#include "ring_model/friction_functionals.h"
#include "ring_model/load/constants.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace stemware::pipeline
{

BalancedContact::BalancedContact(std::shared_ptr<ElasticFoot> foot_given, const ContactBalance &balance,
                                 std::optional<fem::ContactState> start)
    : foot(std::move(foot_given))
    , balance(balance)
    , one_radius(foot->radius())
    , before(std::move(start))
{
}

BalancedContact::BalancedContact(std::shared_ptr<ElasticFoot> foot_given, const ContactBalance &balance,
                                 const fem::ContactState &at_rest, Progress &progress)
    : foot(std::move(foot_given))
    , balance(balance)
    , one_radius(foot->radius())
    , before(at_rest)
    , at_rest(at_rest)
    , progress(progress)
{
}

fem::ContactState BalancedContact::solve(const fem::ContactDemand &demand, double omega)
{
  const ring::Slip slip = { omega / balance.motion.orbit_speed, balance.orientation };
  before = foot->solve(demand, slip, silent_progress(), before ? &*before : nullptr);
  ++counts.n_contact_solutions;
  return *before;
}

fem::ContactDemand BalancedContact::demand_at(double omega, const std::vector<double> &radii,
                                              double rotation) const
{
  const ring::Motion &motion = balance.motion;
  const double arm = ring::friction_arm(balance.closure, motion);
  const Eigen::Vector2d moment = ring::required_moment(balance.closure, motion, Eigen::Vector2d::Zero());
  fem::ContactDemand demand(motion.normal_force(), moment.x(), moment.y());
  demand.ring_radii = radii;
  if (balance.tilts)
    demand.tilt_moment = motion.normal_force() * motion.overturning_height();
  if (arm == 0)
    return demand;
  // With the arm h, the friction force T has the moment h e_z x T = h (-T_y, T_x).
  const ring::FrictionFunctionals friction =
    ring::friction_functionals(motion, radii, std::min(balance.n_harmonics, foot->n_harmonics()), omega);
  demand.friction_x = -arm * friction.side.of_rotated(rotation);
  demand.friction_y = arm * friction.drag.of_rotated(rotation);
  return demand;
}

fem::ContactState BalancedContact::contact_on_one_ring(double omega)
{
  constexpr unsigned int max_rounds = 20;
  constexpr double tolerance = 1e-10; // relative; each round reduces the change of the radius a hundredfold
  const ring::Motion &motion = balance.motion;
  for (unsigned int round = 0;; ++round)
  {
    fem::ContactState state = solve(demand_at(omega, { one_radius }, one_rotation), omega);
    state.load = foot->project_onto_rings(state);
    const double radius = state.load.radius(), rotation = state.load.rotation;
    const bool settled =
      std::abs(radius - one_radius) < tolerance * radius && std::abs(rotation - one_rotation) < tolerance;
    one_radius = radius;
    one_rotation = rotation;
    if (settled || ring::friction_arm(balance.closure, motion) == 0)
      return state;
    if (round == max_rounds)
      throw fem::ContactFailure(fem::ContactOutcome::too_many_steps,
                                "the radius of the single ring does not converge; set Contact/Rings = 5.");
  }
}

fem::ContactState BalancedContact::contact(double omega)
{
  // Cache capacity: enough for the spins around the terminal spin, and for the spins of an error band.
  constexpr std::size_t n_latest = 6;
  if (at_rest && (omega == 0 || !balance.varies_with_spin))
    return *at_rest;
  for (const auto &[spin, state] : latest)
    if (spin == omega)
      return state;
  try
  {
    const std::vector<double> &radii = foot->ring_radii();
    latest.emplace_front(omega, radii.empty() ? contact_on_one_ring(omega)
                                              : solve(demand_at(omega, radii, 0), omega));
  }
  catch (const fem::ContactFailure &failure)
  {
    if (failure.outcome == fem::ContactOutcome::tipping)
      throw ring::Tipping(failure.what());
    throw ring::NoBalance("at " + to_short_text(omega) +
                          " rad/s no balance was found, and the glass does not tip (" + failure.what() + ")");
  }
  if (latest.size() > n_latest)
    latest.pop_back();
  return latest.front().second;
}

ring::Sample BalancedContact::sample_of(const fem::ContactState &state) const
{
  const fem::ContactLoad &load = state.load;
  ring::Sample sample = load.truncated(balance.n_harmonics);
  if (balance.tilts)
    sample.tilt = state.solution.motion.tail<2>();
  // The margin is the minimum load divided by the mean load. With lift-off, the load is replaced by
  // 1 + m cos(theta) with zeros at the ends of the free arc (angle 2 d); its minimum 1 - m is about -d^2 / 2.
  const double share = load.azimuth_fraction.value_or(load.contact_fraction);
  sample.lift_off_margin = share < 1 ? -std::pow(ring::pi * (1 - share), 2) / 2 : load.least / load.a(0);
  sample.stability_margin = state.solution.stability_margin;
  return sample;
}

ring::Sample BalancedContact::sample(double omega)
{
  const ring::Sample sample = sample_of(contact(omega));
  if (omega != 0 && balance.varies_with_spin)
    progress.pieces_done("spins in balance", ++counts.n_balances, 0);
  return sample;
}

std::optional<CouplingStatistics> BalancedContact::statistics() const
{
  return balance.varies_with_spin ? std::optional(counts) : std::nullopt;
}

} // namespace stemware::pipeline
