#include "fem/contact/foot.h"

#include <stdexcept>

namespace stemware::fem
{

bool is_latest(const ElasticBody &body, const ContactSolution &solution)
{
  const Eigen::VectorXd displacement =
    solution.normal_displacement - body.contact_surface().motion_modes() * solution.motion;
  const Eigen::VectorXd difference = body.contact_displacement() - displacement;
  // A body that hardly yields has a displacement that is rounding of the table's motion.
  const double allowed = 1e-6 * displacement.lpNorm<Eigen::Infinity>() +
                         1e-12 * solution.normal_displacement.lpNorm<Eigen::Infinity>();
  // A part of the surface far from the load moves as little as rounding does: the whole decides.
  const SurfaceParts &parts = body.contact_surface().parts;
  return parts.max(difference.lpNorm<Eigen::Infinity>()) <= parts.max(allowed);
}

void require_latest(const ElasticBody &body, const ContactSolution &solution)
{
  if (!is_latest(body, solution))
    throw std::logic_error("The foot has been pressed again since this contact was solved, so its fields are "
                           "gone; ask for them before the next solution.");
}

} // namespace stemware::fem
