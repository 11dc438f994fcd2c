#include "fem/pipeline/explore/live_path.h"

#include "fem/pipeline/coupling/study_load.h"
#include "ring_model/friction_functionals.h"

#include <cmath>

namespace stemware::pipeline
{

void LivePath::append(std::optional<LiveBalance> found)
{
  if (!found)
    balances.clear();
  else if (changes.empty() && !balances.empty()) // the same study, solved anew
    balances.back() = std::move(*found);
  else
  {
    if (balances.size() == 2)
      balances.erase(balances.begin());
    balances.push_back(std::move(*found));
    last_move = changes.size() == 1 ? std::optional(changes.front()) : std::nullopt;
  }
  changes.clear();
}

std::optional<LiveBalance> LivePath::expected() const
{
  constexpr double farthest = 2; // as often as the last move
  if (balances.empty())
    return std::nullopt;
  LiveBalance next = balances.back();
  if (balances.size() < 2 || !last_move || changes.size() != 1 || changes.front().entry != last_move->entry ||
      changes.front().from != last_move->to)
    return next;
  const LiveBalance &before = balances.front();
  const double share = (changes.front().to - changes.front().from) / (last_move->to - last_move->from);
  fem::ContactSolution &solution = next.contact.solution;
  const fem::ContactSolution &solution_before = before.contact.solution;
  if (!(std::abs(share) <= farthest) || next.contact.zone != before.contact.zone ||
      solution.forces.size() != solution_before.forces.size())
    return next;
  const auto move_on = [share](auto &now, const auto &then) { now += share * (now - then); };
  move_on(next.spin.omega, before.spin.omega);
  move_on(next.spin.slope, before.spin.slope);
  move_on(solution.motion, solution_before.motion);
  move_on(solution.normal_displacement, solution_before.normal_displacement);
  move_on(solution.forces, solution_before.forces);
  return next;
}

std::optional<std::pair<LiveBalance, ring::LeaningLoad>>
balance_near(const LiveBalance &near, const Study &study, const std::shared_ptr<ElasticFoot> &foot,
             unsigned int n_harmonics)
{
  constexpr unsigned int max_contacts = 6;
  constexpr double accuracy = 1e-8; // of the spin [rad/s]
  if (!varies_with_spin(study) || foot->ring_radii().empty() || near.contact.zone != 0 ||
      near.contact.solution.forces.size() != foot->body().description().n_contact_nodes)
    return std::nullopt;
  const ring::Motion &motion = study.motion.orbit;
  const double scale = motion.orbit_speed / foot->radius();
  const double grip = std::copysign(study.motion.grip_torque, near.spin.omega);
  BalancedContact contacts(foot, moment_balance(study, n_harmonics), near.contact);
  double spin = near.spin.omega, slope = near.spin.slope, step = 0, torque_before = 0;
  for (unsigned int n = 0; n < max_contacts; ++n)
  {
    fem::ContactState contact = contacts.contact(spin);
    ring::LeaningLoad load = contacts.load_of(contact);
    const double torque = ring::wrench(motion, load, spin).torque + load.lean_torque() - grip;
    // Differences that rounding makes say nothing about the slope.
    if (std::abs(step) > 1e-6 * scale)
      slope = (torque - torque_before) / step;
    // Share of the next step that it may miss: the slope is another study's, or that of the last step.
    const double missed = n == 0 ? 0.1 : std::abs(step) / scale;
    step = -torque / slope;
    if (!(slope < 0) || !(std::abs(spin + step - near.spin.omega) <= 0.1 * scale) ||
        (spin + step) * near.spin.omega <= 0)
      return std::nullopt;
    spin += step;
    if (missed * std::abs(step) <= accuracy)
      return std::pair(LiveBalance{ { spin, slope }, std::move(contact) }, std::move(load));
    torque_before = torque;
  }
  return std::nullopt;
}

} // namespace stemware::pipeline
