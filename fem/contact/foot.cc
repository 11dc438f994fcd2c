#include "fem/contact/foot.h"

#include <stdexcept>

namespace stemware::fem
{

void require_latest(const ElasticBody &body, const ContactState &state)
{
  const ContactSolution &solution = state.solution;
  const Eigen::VectorXd displacement =
    solution.normal_displacement - body.contact_surface().motion_modes() * solution.motion;
  const Eigen::VectorXd difference = body.contact_displacement() - displacement;
  if (!(difference.lpNorm<Eigen::Infinity>() <= 1e-6 * displacement.lpNorm<Eigen::Infinity>()))
    throw std::logic_error("The foot has been pressed again since this contact was solved, so its fields are "
                           "gone; ask for them before the next solution.");
}

} // namespace stemware::fem
