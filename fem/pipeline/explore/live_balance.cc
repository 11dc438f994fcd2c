#include "fem/pipeline/explore/live_balance.h"

#include "fem/pipeline/coupling/study_load.h"
#include "ring_model/friction_functionals.h"

#include <cmath>

namespace stemware::pipeline
{

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
